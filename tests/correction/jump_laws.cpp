// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of every jump, at random heights, steps and gravities, for every integrator of the catalogue. Truth is
// plain stepping in exact arithmetic, which knows no closed form.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <vector>

#include "analysis/correction/jump.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/undamped_catalogue.hpp"

namespace shortfall {
namespace {

/// A jump of at most about a hundred frames. Engines do not damp here, and their limits do not act.
struct ShortJump {
  Program program;
  Values values;
  int substeps;
  Rational dt, g, height;
};

ShortJump random_jump() {
  const Program program = *rc::gen::elementOf(testing::short_catalogue());
  const int substeps = *rc::gen::weightedElement<int>({{4, 1}, {1, 2}, {1, 4}});
  const Rational dt(*rc::gen::inRange(1, 30), *rc::gen::inRange(20, 500));
  const Rational g(*rc::gen::inRange(1, 3000), *rc::gen::inRange(1, 200));
  // H = g dt^2 q / 2 has its peak near frame sqrt(q).
  const Rational q(*rc::gen::inRange(1, 40'000), *rc::gen::inRange(10, 1000));
  RC_LOG() << program.name << ", substeps " << substeps << "\n";
  Values values;
  if (program.parameter("c")) values["c"] = 0;
  return {program, values, substeps, dt, g, g * dt * dt * q / 2};
}

Jump jump_of(const ShortJump& c) {
  return jump(c.program, {.height = c.height,
                          .dt = c.dt,
                          .g = c.g,
                          .substeps = c.substeps,
                          .parameters = c.values,
                          .binary32_frames = 0});
}

/// Heights of frames 0..count by stepping.
std::vector<Surd> stepped(const ShortJump& c, const Surd& launch, int count) {
  const Tape tape = lower(undisturbed(substepped(c.program, c.substeps)), c.values);
  Numbers<Surd> problem{.force = [&](const Surd&, const Surd&, const Surd&) { return Surd(-c.g); }};
  Run<Numbers<Surd>> run(tape, problem, Surd(c.dt));
  run.begin(0, launch, 0);
  std::vector<Surd> heights{run.read_out().first};
  for (int n = 0; n < count; ++n) {
    run.step();
    heights.push_back(run.read_out().first);
  }
  return heights;
}

int count_of(const Rational& n) {
  std::int64_t count = 0;
  RC_ASSERT(n.fits_int64(count));
  return static_cast<int>(count);
}

TEST_CASE("the shortfall is the method's part and the sampling's, exactly, and sampling is never negative") {
  CHECK(rc::check([] {
    const ShortJump c = random_jump();
    const Jump j = jump_of(c);
    RC_ASSERT(j.shortfall.total == j.shortfall.method + j.shortfall.sampling);
    RC_ASSERT(j.shortfall.total == Surd(c.height) - j.best_frame.height);
    RC_ASSERT(j.shortfall.sampling.sign() >= 0);
  }));
}

TEST_CASE("the highest frame is the one that stepping finds, the earliest of two") {
  CHECK(rc::check([] {
    const ShortJump c = random_jump();
    const Jump j = jump_of(c);
    const std::vector<Surd> heights = stepped(c, j.launch_velocity, count_of(j.best_frame.n) + 30);
    std::size_t best = 0;
    for (std::size_t n = 1; n < heights.size(); ++n)
      if (heights[n] > heights[best]) best = n;
    RC_ASSERT(j.best_frame.n == Rational(best));
    RC_ASSERT(j.best_frame.height == heights[best]);
    RC_ASSERT(j.tie == (best > 0 && heights[best + 1] == heights[best]));
    RC_ASSERT(j.lifts_off == (best > 0));
  }));
}

TEST_CASE("corrected, every frame is the parabola, sampled") {
  CHECK(rc::check([] {
    const ShortJump c = random_jump();
    const Jump j = jump_of(c);
    RC_ASSERT(j.corrected.has_value());
    RC_ASSERT(j.corrected->exact_at_every_frame);
    const std::vector<Surd> heights = stepped(c, j.corrected->launch, 40);
    for (std::size_t n = 0; n < heights.size(); ++n) {
      const Rational t = Rational(n) * c.dt;
      RC_ASSERT(heights[n] == j.launch_velocity * t - Surd(c.g * t * t / 2));
    }
    RC_ASSERT(j.corrected->shortfall.method.is_zero());
    RC_ASSERT(j.corrected->shortfall.total.sign() >= 0);
    RC_ASSERT(j.corrected->shortfall.total <= Surd(c.g * c.dt * c.dt / 8));
  }));
}

TEST_CASE("on a frame, the top is H exactly, earlier frames are lower and later ones not higher") {
  CHECK(rc::check([] {
    const ShortJump c = random_jump();
    const Jump j = jump_of(c);
    RC_ASSERT(j.on_frame.has_value());
    const std::size_t top = static_cast<std::size_t>(count_of(j.on_frame->top.n));
    const std::vector<Surd> heights = stepped(c, j.on_frame->launch, static_cast<int>(top) + 30);
    RC_ASSERT(heights[top] == Surd(c.height));
    for (std::size_t n = 0; n < heights.size(); ++n)
      RC_ASSERT((n < top ? heights[n] < heights[top] : heights[n] <= heights[top]));
  }));
}

TEST_CASE(
    "a jump that aims just higher than the lift-off height leaves the ground, one that does not stays") {
  CHECK(rc::check([] {
    ShortJump c = random_jump();
    const Jump j = jump_of(c);
    RC_ASSERT(j.lift_off.height.has_value());
    const Rational edge = *j.lift_off.height;
    RC_ASSERT(j.lifts_off == (c.height > edge));
    const Rational little = c.g * c.dt * c.dt / 1'000'000;
    c.height = edge + little;
    RC_ASSERT(jump_of(c).lifts_off);
    if (edge.sign() <= 0) return;
    c.height = edge;
    RC_ASSERT(!jump_of(c).lifts_off);
    c.height = edge - edge / 1000;
    const Jump below = jump_of(c);
    RC_ASSERT(below.best_frame.n.is_zero());
    RC_ASSERT(below.best_frame.height.is_zero());
  }));
}

TEST_CASE("two frames that are equally high are a tie, and the earlier one is named") {
  // Verlet at u = (2 m + 1) g dt / 2: symmetric about m + 1/2.
  const Rational dt(1, 50), g(981, 100);
  const Rational launch = 7 * g * dt / 2;
  const Jump j = jump(find_integrator("velocity-verlet"), JumpQuestion{.height = launch * launch / (2 * g)});
  CHECK(j.best_frame.n == 3);
  CHECK(j.tie);
  // H = 3 * 4 g dt^2 / 2: frames 3 and 4 can both be the top, and at H both are.
  const Jump both = jump(find_integrator("symplectic-euler"), JumpQuestion{.height = 6 * g * dt * dt});
  CHECK(both.on_frame->top.n == 3);
  const Flight flight(find_integrator("symplectic-euler"), dt);
  CHECK(flight.height(both.on_frame->launch, g, 4) == Surd(both.target));
}

TEST_CASE("a billion metres, a billion frames: no frame is stepped") {
  const Jump high =
      jump(find_integrator("symplectic-euler"), {.height = 1'000'000'000, .binary32_frames = 0});
  CHECK(high.best_frame.n == 713'921);
  CHECK((high.shortfall.method - Surd(high.best_frame.n * high.dt * high.dt * high.g / 2)).is_zero());
  const Jump fine = jump(find_integrator("symplectic-euler"),
                         {.height = 1'000'000'000, .dt = Rational(1, 1'000'000'000), .binary32_frames = 0});
  CHECK(fine.best_frame.n == Rational::parse("14278431229270"));
  CHECK(fine.on_frame->top.height == Surd(1'000'000'000));
}

}  // namespace
}  // namespace shortfall
