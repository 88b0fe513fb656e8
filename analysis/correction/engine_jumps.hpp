// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/jump.hpp"

namespace shortfall {

/// What an engine makes of a jump, and of the correction that is right for most engines.
struct EngineJump {
  Jump undamped;  ///< its damping number, the parameter c, is 0
  /// The launch is sqrt(2 g H) + g dt/2.
  struct UsualFix {
    Surd launch;
    Frame best_frame;
    Surd shortfall;  ///< H - the highest frame, metres
  };
  UsualFix usual_fix;
  std::optional<Jump> damped;  ///< with the engine's default damping, when it has one
};

/// param   question  its parameters are the engine's, without c
EngineJump engine_jump(const Program& engine, const JumpQuestion& question);

}  // namespace shortfall
