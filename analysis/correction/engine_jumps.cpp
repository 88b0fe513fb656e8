// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/engine_jumps.hpp"

namespace shortfall {

EngineJump engine_jump(const Program& engine, const JumpQuestion& question) {
  constexpr const char* kDamping = "c";
  EngineJump result;
  Values values = question.parameters;
  const bool has_damping = engine.parameter(kDamping) != nullptr;
  if (has_damping) values[kDamping] = 0;
  const Flight flight(engine, question.dt, question.substeps, values, question.by, question.force_frames);
  result.undamped = jump(flight, question.height, question.g, question.binary32_frames);
  EngineJump::UsualFix& fix = result.usual_fix;
  fix.launch = result.undamped.launch_velocity + Surd(question.g * question.dt / 2);
  fix.best_frame = flight.highest(fix.launch, question.g);
  fix.shortfall = Surd(question.height) - fix.best_frame.height;
  if (has_damping && !parameter_values(engine, question.parameters).at(kDamping).is_zero()) {
    const Flight damped(engine, question.dt, question.substeps, question.parameters, question.by,
                        question.force_frames);
    result.damped = jump(damped, question.height, question.g, question.binary32_frames);
  }
  return result;
}

}  // namespace shortfall
