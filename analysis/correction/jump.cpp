// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump.hpp"

#include <utility>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

/// The exact motion at the end of frame n.
Surd exact_height(const Surd& launch, const Rational& g, const Rational& dt, const Rational& n) {
  const Rational t = n * dt;
  return launch * t - Surd(g * t * t / 2);
}

JumpShortfall shortfall_at(const Frame& frame, const Surd& exact, const Rational& target) {
  return {Surd(target) - frame.height, exact - frame.height, Surd(target) - exact};
}

Surd at(const std::array<Surd, 3>& p, const Surd& n) { return p[0] + n * (p[1] + n * p[2]); }

Jump::Corrected corrected(const Flight& flight, const Jump& jump) {
  Jump::Corrected result;
  result.launch = jump.launch_velocity + Surd(jump.correction.value(jump.g));
  result.best_frame = flight.highest(result.launch, jump.g);
  const Surd exact = exact_height(jump.launch_velocity, jump.g, jump.dt, result.best_frame.n);
  result.shortfall = shortfall_at(result.best_frame, exact, jump.target);
  // Parabolas, so three frames of the settled flight, and the unsettled ones, are all of them.
  result.exact_at_every_frame = flight.parabolic();
  for (int n = 0; n < flight.settled() + 3; ++n)
    if (flight.height(result.launch, jump.g, n) != exact_height(jump.launch_velocity, jump.g, jump.dt, n))
      result.exact_at_every_frame = false;
  return result;
}

}  // namespace

std::optional<OnFrame> on_frame(const Flight& flight, const Rational& height, const Rational& g) {
  // The frame nearest to the ideal time, or one beside it: too early a frame is passed by later ones, and the
  // reverse.
  constexpr int kFramesAside = 64;
  const Surd ideal = Surd::sqrt(2 * height / g) / Surd(flight.dt());
  Rational m = (ideal + Surd(Rational(1, 2))).floor();
  if (m.sign() <= 0) m = 1;
  int direction = 0;
  for (int tried = 0; tried < kFramesAside && m.sign() > 0; ++tried) {
    const Rational rise = flight.rise(m);
    if (rise.sign() <= 0) return std::nullopt;
    const Rational launch = (height + g * flight.fall(m)) / rise;
    Frame top = flight.highest(launch, g);
    if (top.n == m) return OnFrame{launch, std::move(top)};
    const int towards = top.n > m ? 1 : -1;
    if (towards * direction < 0) return std::nullopt;
    direction = towards;
    m += direction;
  }
  return std::nullopt;
}

Jump jump(const Flight& flight, const Rational& height, const Rational& g, std::int64_t binary32_frames) {
  if (height.sign() <= 0) throw BadInput("a jump is higher than 0 m, not " + height.str() + " m");
  if (g.sign() <= 0) throw BadInput("gravity is greater than 0 m/s^2 (downwards), not " + g.str() + " m/s^2");
  Jump jump;
  jump.integrator = flight.program().name;
  jump.substeps = flight.substeps();
  jump.dt = flight.dt();
  jump.g = g;
  jump.target = height;
  jump.launch_velocity = Surd::sqrt(2 * g * height);
  jump.ideal_time = jump.launch_velocity / Surd(g);

  jump.best_frame = flight.highest(jump.launch_velocity, g);
  const Rational& n = jump.best_frame.n;
  jump.lifts_off = n.sign() > 0;
  jump.tie = jump.lifts_off && flight.height(jump.launch_velocity, g, n + 1) == jump.best_frame.height;
  jump.shortfall = shortfall_at(jump.best_frame, exact_height(jump.launch_velocity, g, jump.dt, n), height);
  if (flight.parabolic()) {
    const auto heights = flight.heights(jump.launch_velocity, g);
    jump.ideal_time_height = at(heights, jump.ideal_time / Surd(jump.dt));
    if (heights[2].sign() < 0)
      jump.parabola_top = heights[0] - heights[1] * heights[1] / (Surd(4) * heights[2]);
  }

  jump.lift_off = lift_off(flight, g);
  jump.correction = launch_correction(flight);
  if (jump.correction.exists) jump.corrected = corrected(flight, jump);
  jump.on_frame = on_frame(flight, height, g);
  if (!jump.on_frame) {
    jump.no_on_frame = "no frame that is brought to " + height.str() + " m is the highest one";
    jump.no_binary32 = jump.no_on_frame;
  } else {
    auto [best, reason] =
        binary32_launch(flight, height, g, jump.on_frame->launch, jump.on_frame->top.n, binary32_frames);
    jump.binary32 = best;
    jump.no_binary32 = std::move(reason);
  }
  return jump;
}

Jump jump(const Program& program, const JumpQuestion& question) {
  const Flight flight(program, question.dt, question.substeps, question.parameters);
  return jump(flight, question.height, question.g, question.binary32_frames);
}

}  // namespace shortfall
