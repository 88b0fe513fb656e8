// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/intended_motion.hpp"

namespace shortfall {

namespace {

JumpShortfall shortfall_at(const Frame& frame, const IntendedMotion& motion, const Jump& jump,
                           const Surd& launch) {
  const Surd exact = motion.height(launch, jump.g, frame.n * jump.dt);
  const Surd target(jump.target);
  return {target - frame.height, exact - frame.height, jump.exact_top - exact, target - jump.exact_top};
}

Jump::Corrected corrected(const Flight& flight, const IntendedMotion& motion, const Jump& jump) {
  Jump::Corrected result;
  result.launch = jump.launch_velocity + Surd(jump.correction.value(jump.g));
  result.best_frame = flight.highest(result.launch, jump.g);
  result.shortfall = shortfall_at(result.best_frame, motion, jump, jump.launch_velocity);
  // Parabolas, so three frames of the settled flight, and the unsettled ones, are all of them.
  result.exact_at_every_frame = flight.parabolic() && !motion.damped();
  for (int n = 0; n < flight.settled() + 3; ++n)
    if (flight.height(result.launch, jump.g, n) != motion.height(jump.launch_velocity, jump.g, n * jump.dt))
      result.exact_at_every_frame = false;
  return result;
}

/// u with (u r1 - g f1)^2/(4 g f2) + u r0 - g f0 = H, the larger one.
std::optional<Surd> launch_for_top(const Flight& flight, const Rational& height, const Rational& g) {
  if (!flight.parabolic()) return std::nullopt;
  const auto& [r0, r1, r2] = flight.rise();
  const auto& [f0, f1, f2] = flight.fall();
  if (!r2.is_zero() || r1.sign() <= 0 || f2.sign() <= 0) return std::nullopt;
  const Rational middle = (g * f1 - 2 * g * f2 * r0 / r1) / r1;
  const Rational square = middle * middle + (4 * g * f2 * (height + g * f0) - g * g * f1 * f1) / (r1 * r1);
  if (square.sign() <= 0) return std::nullopt;
  return Surd(middle) + Surd::sqrt(square);
}

}  // namespace

std::optional<OnFrame> on_frame(const Flight& flight, const Rational& height, const Rational& g) {
  const Surd ideal = Surd::sqrt(2 * height / g) / Surd(flight.dt());
  Rational m = (ideal + Surd(Rational(1, 2))).floor();
  if (m.sign() <= 0) m = 1;
  // Below `low` frames are too early, from `high` on too late; strides double until both are known.
  std::optional<Rational> low, high;
  for (Rational stride = 1;; stride = low && high ? stride : stride * 2) {
    const Rational rise = flight.rise(m);
    if (rise.sign() <= 0) return std::nullopt;
    const Rational launch = (height + g * flight.fall(m)) / rise;
    if (launch.sign() <= 0) return std::nullopt;
    Frame top = flight.highest(launch, g);
    if (top.n == m) return OnFrame{launch, std::move(top)};
    (top.n > m ? low : high) = m;
    if (low && high) {
      if (*high - *low <= 1) return std::nullopt;
      m = ((*low + *high) / 2).floor();
    } else if (low) {
      m += stride;
    } else {
      if (m.is_one()) return std::nullopt;
      m = std::max(Rational(1), m - stride);
    }
  }
}

Jump jump(const Flight& flight, const Rational& height, const Rational& g, std::int64_t binary32_frames) {
  if (height.sign() <= 0) throw BadInput("a jump is higher than 0 m, not " + height.str() + " m");
  if (g.sign() <= 0) throw BadInput("gravity is greater than 0 m/s^2 (downwards), not " + g.str() + " m/s^2");
  Jump jump;
  jump.integrator = flight.program().name;
  jump.substeps = flight.substeps();
  jump.dt = flight.dt();
  jump.g = g;
  jump.parameters = flight.parameters();
  jump.by = flight.launch_by();
  jump.force_frames = flight.force_frames();
  const IntendedMotion motion(flight.program(), flight.parameters());
  jump.drag = motion.drag();
  jump.rounded = flight.rounded();
  jump.target = height;
  jump.launch_velocity = Surd::sqrt(2 * g * height);
  jump.ideal_time = motion.time_of_top(jump.launch_velocity, g);
  jump.exact_top = motion.top(jump.launch_velocity, g);

  jump.best_frame = flight.highest(jump.launch_velocity, g);
  const Rational& n = jump.best_frame.n;
  jump.lifts_off = n.sign() > 0;
  jump.tie = jump.lifts_off && flight.height(jump.launch_velocity, g, n + 1) == jump.best_frame.height;
  jump.shortfall = shortfall_at(jump.best_frame, motion, jump, jump.launch_velocity);
  try {
    jump.limit = limit_met(flight, jump.launch_velocity, g, n);
  } catch (const Unable& e) {
    jump.limit_unknown = e.what();
  }
  if (flight.parabolic()) {
    const auto heights = flight.heights(jump.launch_velocity, g);
    // While a force acts the motion is another one.
    const Surd free(jump.by == LaunchBy::force && jump.force_frames > 1 ? jump.force_frames : 0);
    if (const Surd ideal = jump.ideal_time / Surd(jump.dt); ideal >= free)
      jump.ideal_time_height = parabola_at(heights, ideal);
    if (heights[2].sign() < 0 && -heights[1] / (Surd(2) * heights[2]) >= free)
      jump.parabola_top = heights[0] - heights[1] * heights[1] / (Surd(4) * heights[2]);
  }
  if (jump.by == LaunchBy::force && !motion.damped()) {
    const Rational half = g * jump.dt * jump.force_frames / 2;
    jump.exact_force_launch = Surd(half) + Surd::sqrt(half * half + 2 * g * height);
  }

  jump.lift_off = lift_off(flight, g);
  jump.correction = launch_correction(flight);
  if (jump.correction.exists)
    jump.corrected = corrected(flight, motion, jump);
  else
    jump.launch_for_top = launch_for_top(flight, height, g);
  jump.on_frame = on_frame(flight, height, g);
  if (!jump.on_frame) {
    jump.no_on_frame = "no frame that is brought to " + height.str() + " m is the highest one";
    jump.no_binary32 = jump.no_on_frame;
  } else {
    auto [best, reason] =
        binary32_launch(flight, height, g, jump.on_frame->launch, jump.on_frame->top.n, binary32_frames);
    jump.binary32 = best;
    jump.no_binary32 = std::move(reason);
    if (jump.limit_unknown.empty())
      jump.on_frame_limit = limit_met(flight, jump.on_frame->launch, g, jump.on_frame->top.n);
  }
  return jump;
}

Jump jump(const Program& program, const JumpQuestion& question) {
  const Flight flight(program, question.dt, question.substeps, question.parameters, question.by,
                      question.force_frames);
  return jump(flight, question.height, question.g, question.binary32_frames);
}

}  // namespace shortfall
