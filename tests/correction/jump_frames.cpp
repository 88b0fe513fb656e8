// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps over frames of lengths of their own. Truth is stepping, by hand or in another number type, and what
// a fixed step is already known to do.
#include "analysis/correction/jump_frames.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"
#include "tests/correction/engine_loop.hpp"
#include "tests/undamped_catalogue.hpp"

namespace shortfall {
namespace {

using Steps = std::vector<Rational>;
using End = FrameJump::End;
using testing::kG;

/// About 60 Hz with a hitch now and then; long enough for a jump of a metre or two.
Steps random_frames() {
  Steps steps;
  for (int k = 0; k < 90; ++k) {
    const int hitch = *rc::gen::weightedElement<int>({{9, 1}, {1, 5}});
    steps.push_back(Rational(*rc::gen::inRange(12, 22) * hitch, 1000));
  }
  return steps;
}

/// Heights after a launch by the interpreter in numbers p + q sqrt(d): another type than the code under test
/// uses.
std::vector<Surd> heights(const Program& program, const Steps& steps, const Surd& launch, const Rational& g) {
  const Tape tape = lower(program);
  Numbers<Surd> problem{.force = [&](const Surd&, const Surd&, const Surd&) { return Surd(-g); }};
  Run<Numbers<Surd>> run(tape, problem, Surd(steps.front()));
  run.begin(0, launch, 0);
  std::vector<Surd> result{run.read_out().first};
  for (const Rational& h : steps) {
    run.set_step(Surd(h));
    run.step();
    result.push_back(run.read_out().first);
  }
  return result;
}

Surd exact(const Surd& launch, const Rational& g, const Rational& t) {
  return launch * Surd(t) - Surd(g * t * t / 2);
}

TEST_CASE("symplectic Euler over any frames, by hand: v -= g h, x += h v") {
  CHECK(rc::check([] {
    const Steps steps = random_frames();
    const Rational height(*rc::gen::inRange(1, 180), 100);
    const FrameJump j = jump(find_integrator("symplectic-euler"), {.height = height, .steps = steps});
    Surd x, v = Surd::sqrt(2 * kG * height), top;
    Rational t, squares, best_squares;
    std::size_t n = 0, best = 0;
    for (const Rational& h : steps) {
      v = v - Surd(kG * h);
      x = x + v * Surd(h);
      t += h;
      squares += h * h;
      ++n;
      RC_ASSERT(j.frames[n].t == t);
      RC_ASSERT(j.frames[n].height == x);
      RC_ASSERT(j.frames[n].shortfall == Surd(kG / 2 * squares));
      if (x > top) {
        top = x;
        best = n;
        best_squares = squares;
      }
      if (x.sign() <= 0) break;
    }
    RC_ASSERT(j.frames.size() == n + 1);
    RC_ASSERT(j.end == End::landed);
    RC_ASSERT(j.best_frame.n == Rational(best));
    RC_ASSERT(j.best_frame.height == top);
    RC_ASSERT(j.shortfall.method == Surd(kG / 2 * best_squares));
    RC_ASSERT(j.shortfall.total == Surd(height) - top);
    RC_ASSERT(j.shortfall.total == j.shortfall.method + j.shortfall.sampling);
    RC_ASSERT(j.shortfall.sampling.sign() >= 0);
  }));
}

TEST_CASE("every integrator of the catalogue does over a list what stepping does") {
  CHECK(rc::check([] {
    const Program program = *rc::gen::elementOf(testing::short_catalogue());
    const int substeps = *rc::gen::element(1, 1, 3);
    RC_LOG() << program.name << ", substeps " << substeps << "\n";
    const Steps steps = random_frames();
    const FrameJump j = jump(program, {.height = 1, .steps = steps, .substeps = substeps});
    const std::vector<Surd> truth = heights(substepped(program, substeps), steps, j.launch_velocity, kG);
    for (std::size_t n = 0; n < j.frames.size(); ++n) {
      RC_ASSERT(j.frames[n].height == truth[n]);
      RC_ASSERT(j.frames[n].height <= j.best_frame.height);
      RC_ASSERT(j.frames[n].exact == exact(j.launch_velocity, kG, j.frames[n].t));
      if (j.exactness.exact == true) RC_ASSERT(j.frames[n].shortfall.is_zero());
    }
  }));
}

TEST_CASE("a list of equal frames is a fixed step") {
  for (const Program& program : testing::short_catalogue()) {
    CAPTURE(program.name);
    const FrameJump list = jump(program, {.height = Rational(2, 5), .steps = Steps(60, Rational(1, 50))});
    const Jump fixed = jump(program, {.height = Rational(2, 5), .binary32_frames = 0});
    CHECK(list.best_frame.n == fixed.best_frame.n);
    CHECK(list.best_frame.height == fixed.best_frame.height);
    CHECK(list.shortfall.method == fixed.shortfall.method);
    CHECK(list.shortfall.sampling == fixed.shortfall.sampling);
    CHECK(list.tie == fixed.tie);
    CHECK(list.equal_steps);
    REQUIRE(list.hindsight);
    CHECK(*list.hindsight == Surd(fixed.correction.value(fixed.g)));
  }
  const FrameJump story = jump(find_integrator("symplectic-euler"),
                               {.height = Rational(2, 5), .steps = Steps(60, Rational(1, 50))});
  CHECK((story.shortfall.total * Surd(100)).decimal(9) == "2.762010199");
}

TEST_CASE("the counter-example holds: a launch that is right for one ending misses the other") {
  CHECK(rc::check([] {
    const Program program = *rc::gen::elementOf(testing::short_catalogue());
    RC_LOG() << program.name << "\n";
    const Steps steps = random_frames();
    const FrameJump j = jump(program, {.height = 1, .steps = steps});
    RC_ASSERT(j.counter_example.has_value() == (j.exactness.exact == false));
    if (!j.counter_example) return;
    const LaunchCounterExample& c = *j.counter_example;
    const auto list = [&](const LaunchCounterExample::Ending& e) {
      Steps all(steps.begin(), steps.begin() + static_cast<long>(c.beginning));
      all.insert(all.end(), e.steps.begin(), e.steps.end());
      return all;
    };
    const auto missing = [&](const LaunchCounterExample::Ending& e, const Surd& added) {
      return exact(j.launch_velocity, kG, e.t) -
             heights(program, list(e), j.launch_velocity + added, kG).back();
    };
    RC_ASSERT(missing(c.one, c.one.needed).is_zero());
    RC_ASSERT(missing(c.other, c.other.needed).is_zero());
    RC_ASSERT(!missing(c.other, c.one.needed).is_zero());
    RC_ASSERT(!missing(c.one, c.other.needed).is_zero());
  }));
}

TEST_CASE("with the term every frame is exact, and only sampling is left") {
  CHECK(rc::check([] {
    const Program program = *rc::gen::elementOf(testing::short_catalogue());
    const int substeps = *rc::gen::element(1, 4);
    const FrameJump j = jump(program, {.height = 1, .steps = random_frames(), .substeps = substeps});
    if (!j.term) {
      RC_ASSERT(j.exactness.exact == true || !j.no_term.empty());
      return;
    }
    RC_ASSERT(j.term->exact_at_every_frame);
    RC_ASSERT(j.term->shortfall.method.is_zero());
    RC_ASSERT(j.term->shortfall.total == Surd(1) - j.term->best_frame.height);
  }));
  const FrameJump euler =
      jump(find_integrator("symplectic-euler"), {.height = 1, .steps = Steps(90, Rational(1, 60))});
  REQUIRE(euler.term);
  CHECK(print(euler.term->added) == "-1/2*a*h^2");
}

TEST_CASE("the accumulator, by hand: time is saved up, and fixed steps are taken while they fit") {
  CHECK(rc::check([] {
    const Steps steps = random_frames();
    const Rational dt(1, *rc::gen::element(50, 60, 120));
    const FrameJump j =
        jump(find_integrator("symplectic-euler"), {.height = 1, .steps = steps, .fixed_dt = dt});
    RC_ASSERT(j.accumulator.has_value());
    RC_ASSERT(j.accumulator->correction.value(kG) == kG * dt / 2);
    Surd x, v = j.launch_velocity + Surd(kG * dt / 2), top;
    Rational saved, taken, taken_then;
    std::size_t frame = 0;
    for (std::size_t n = 0; n < steps.size(); ++n) {
      for (saved += steps[n]; saved >= dt; saved -= dt) {
        v = v - Surd(kG * dt);
        x = x + v * Surd(dt);
        taken += 1;
        RC_ASSERT(x == exact(j.launch_velocity, kG, taken * dt));
      }
      if (x > top) {
        top = x;
        frame = n + 1;
        taken_then = taken;
      }
    }
    RC_ASSERT(j.accumulator->height == top);
    RC_ASSERT(j.accumulator->frame == frame);
    RC_ASSERT(j.accumulator->steps == taken_then);
    RC_ASSERT(j.accumulator->shortfall == Surd(1) - top);
  }));
}

TEST_CASE("a repeated list is the list written out") {
  const Steps three{Rational(1, 60), Rational(1, 30), Rational(1, 100)};
  Steps all;
  for (int k = 0; k < 60; ++k) all.insert(all.end(), three.begin(), three.end());
  const Program program = find_integrator("adams-bashforth-2");
  const FrameJump repeated = jump(program, {.height = 1, .steps = three, .repeat = true});
  const FrameJump whole = jump(program, {.height = 1, .steps = all});
  REQUIRE(repeated.frames.size() == whole.frames.size());
  for (std::size_t n = 0; n < whole.frames.size(); ++n)
    CHECK(repeated.frames[n].height == whole.frames[n].height);
  CHECK(repeated.end == End::landed);
}

TEST_CASE("a list may be over while the body rises, or while it falls") {
  const Program program = find_integrator("symplectic-euler");
  const auto over = [&](int frames) {
    return jump(program, {.height = 1, .steps = Steps(static_cast<std::size_t>(frames), Rational(1, 60))});
  };
  CHECK(over(10).end == End::rising);
  CHECK_FALSE(over(10).top_is_certain);
  CHECK(over(40).end == End::falling);
  CHECK(over(40).top_is_certain);
  CHECK(over(40).best_frame.height == over(90).best_frame.height);
  CHECK(over(90).end == End::landed);
  // With alpha < 0 a frame that begins with a falling body may still end higher.
  const Program springy =
      parse("integrator springy\nstep\n  x = x + h*v - h^2*a(x, v, t)\n  v = v + h*a(x, v, t)\n", "s");
  const FrameJump negative = jump(springy, {.height = 1, .steps = Steps(40, Rational(1, 60))});
  CHECK(negative.end == End::falling);
  CHECK_FALSE(negative.top_is_certain);
  // What an earlier step has left behind could lift the body again.
  const FrameJump two_step =
      jump(find_integrator("adams-bashforth-2"), {.height = 1, .steps = Steps(40, Rational(1, 60))});
  CHECK(two_step.end == End::falling);
  CHECK_FALSE(two_step.top_is_certain);
}

TEST_CASE(
    "a body that is exactly at the ground has landed, and of two frames that are equally high the earlier "
    "counts") {
  // u = 2 m/s, g = 1 m/s^2, frames of 1 s: v = 1, 0, -1 and x = 1, 1, 0.
  const FrameJump j =
      jump(find_integrator("symplectic-euler"), {.height = 2, .steps = Steps(9, Rational(1)), .g = 1});
  REQUIRE(j.frames.size() == 4);
  CHECK(j.frames[3].height.is_zero());
  CHECK(j.end == End::landed);
  CHECK(j.best_frame.n == 1);
  CHECK(j.tie);
}

TEST_CASE("a first frame that is too long keeps the body on the ground, up to the height that is said") {
  const Program program = find_integrator("symplectic-euler");
  const Steps steps{Rational(1, 10), Rational(1, 100), Rational(1, 100), Rational(1, 100)};
  const FrameJump low = jump(program, {.height = Rational(1, 100), .steps = steps});
  REQUIRE(low.lift_off.height);
  CHECK(*low.lift_off.height == kG / 200);
  CHECK_FALSE(low.lifts_off);
  CHECK(low.best_frame.n == 0);
  CHECK(low.frames.size() == 2);
  CHECK_FALSE(low.hindsight);
  CHECK_FALSE(jump(program, {.height = *low.lift_off.height, .steps = steps}).lifts_off);
  CHECK(
      jump(program, {.height = *low.lift_off.height + Rational(1, 1'000'000), .steps = steps, .repeat = true})
          .lifts_off);
}

TEST_CASE("the longest frame and what it is to blame for") {
  Steps steps(90, Rational(1, 60));
  steps[4] = Rational(1, 12);
  const FrameJump j = jump(find_integrator("symplectic-euler"), {.height = 1, .steps = steps});
  CHECK(j.longest == 5);
  REQUIRE(j.longest_cost);
  CHECK(*j.longest_cost == Surd(kG / 2 / 144));
}

TEST_CASE("an integrator that damps has no law, no term, no fixed step that is exact; stepping goes on") {
  const Program damped = parse(
      "integrator damped\n  param c : 1/T = 1/10\nstep\n  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v\n",
      "d");
  const FrameJump j = jump(damped, {.height = 1, .steps = Steps(90, Rational(1, 60))});
  CHECK_FALSE(j.steps.law);
  CHECK_FALSE(j.term);
  CHECK_FALSE(j.accumulator);
  CHECK(j.exactness.exact == false);
  CHECK(j.shortfall.total == j.shortfall.method + j.shortfall.sampling);
  const FrameJump free =
      jump(damped, {.height = 1, .steps = Steps(90, Rational(1, 60)), .parameters = {{"c", 0}}});
  CHECK(free.term);
}

TEST_CASE("what makes no sense is refused") {
  const Program program = find_integrator("symplectic-euler");
  const Steps steps(3, Rational(1, 60));
  CHECK_THROWS_AS(jump(program, {.height = 0, .steps = steps}), BadInput);
  CHECK_THROWS_AS(jump(program, FrameJumpQuestion{.height = 1, .steps = {}}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .steps = {Rational(1, 60), 0}}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .steps = {Rational(-1, 60)}}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .steps = steps, .g = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .steps = steps, .fixed_dt = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .steps = steps, .parameters = {{"beta", 1}}}), BadInput);
  CHECK_THROWS_AS(jump(parse("integrator floating\nstep\n  x = x + h*v\n", "f"),
                       {.height = 1, .steps = steps, .repeat = true}),
                  Unable);
}

}  // namespace
}  // namespace shortfall
