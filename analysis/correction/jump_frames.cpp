// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_frames.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kUnrolled = 3;

Surd exact_height(const Surd& launch, const Rational& g, const Rational& t) {
  return launch * t - Surd(g * t * t / 2);
}

JumpShortfall shortfall_at(const JumpedFrame& frame, const Rational& target) {
  return {Surd(target) - frame.height, frame.shortfall, Surd(target) - frame.exact, 0};
}

/// Frames until the body is back on the ground, or the list is over.
struct Path {
  std::vector<JumpedFrame> frames;
  FrameJump::End end = FrameJump::End::landed;
  std::size_t best = 0;  ///< the earliest of the highest
};

Path path(FrameFlight& flight, const Surd& launch, const Rational& g) {
  Path p;
  for (std::size_t n = 0;; ++n) {
    if (n > FrameFlight::kMost)
      throw Unable("the body is not back on the ground after " + std::to_string(FrameFlight::kMost) +
                   " frames, the most that we step exactly over a list");
    const FlownFrame& f = flight.frame(n);
    const Surd height = f.height(launch, g), exact = exact_height(launch, g, f.t);
    const bool falls = f.velocity(launch, g).sign() <= 0;
    p.frames.push_back({f.t, f.h, height, exact, exact - height});
    if (height > p.frames[p.best].height) p.best = n;
    if (n > 0 && height.sign() <= 0 && falls) return p;
    if (!flight.has(n + 1)) {
      p.end = falls ? FrameJump::End::falling : FrameJump::End::rising;
      return p;
    }
  }
}

/// What the launch needs added so that frame n is where the exact motion of the uncorrected launch is.
std::optional<Surd> needed(FrameFlight& flight, std::size_t n, const Surd& launch, const Rational& g) {
  const FlownFrame& f = flight.frame(n);
  if (f.rise.is_zero()) return std::nullopt;
  return (exact_height(launch, g, f.t) - f.height(launch, g)) / Surd(f.rise);
}

std::optional<LaunchCounterExample> counter_example(const FrameJumpQuestion& q, const Program& program,
                                                    const FrameJump& jump, std::size_t n) {
  std::vector<Rational> beginning;
  for (std::size_t k = 1; k < n; ++k) beginning.push_back(jump.frames[k].h);
  const auto ending = [&](const std::vector<Rational>& last) -> std::optional<LaunchCounterExample::Ending> {
    std::vector<Rational> steps = beginning;
    steps.insert(steps.end(), last.begin(), last.end());
    const std::size_t count = steps.size();
    FrameFlight flight(program, std::move(steps), false, q.substeps, q.parameters);
    const auto add = needed(flight, count, jump.launch_velocity, q.g);
    if (!add) return std::nullopt;
    return LaunchCounterExample::Ending{last, flight.frame(count).t, *add};
  };
  const Rational h = jump.frames[n].h;
  const auto one = ending({h});
  if (!one) return std::nullopt;
  // The same time in two pieces first: it shows that the time alone does not decide.
  for (const std::vector<Rational>& last : {std::vector{h / 2, h / 2}, {h / 3, h * Rational(2, 3)}, {h * 2}})
    if (const auto other = ending(last); other && !(other->needed == one->needed))
      return LaunchCounterExample{beginning.size(), *one, *other};
  return std::nullopt;
}

void correct(FrameJump& jump, const FrameJumpQuestion& q, const Program& framed,
             const VariableSteps& in_numbers) {
  const bool in_letters = jump.steps.law && jump.steps.law->only_squares();
  try {
    const VariableSteps& steps = in_letters ? jump.steps : in_numbers;
    Program program = with_square_term(framed, steps);
    FrameFlight flight(program, q.steps, q.repeat, 1, q.parameters);
    const Path p = path(flight, jump.launch_velocity, q.g);
    FrameJump::Corrected corrected{
        std::move(program), square_term(*steps.law), {p.best, p.frames[p.best].height}, {}, true};
    corrected.shortfall = shortfall_at(p.frames[p.best], q.height);
    for (const JumpedFrame& f : p.frames)
      if (!f.shortfall.is_zero()) corrected.exact_at_every_frame = false;
    jump.term = std::move(corrected);
  } catch (const Undefined& e) {
    jump.no_term = e.what();
  }
}

std::optional<AccumulatorJump> accumulated(const FrameJump& jump, const FrameJumpQuestion& q,
                                           const Program& program) {
  const Flight flight(program, q.fixed_dt, q.substeps, q.parameters);
  AccumulatorJump result;
  result.dt = q.fixed_dt;
  try {
    result.correction = launch_correction(flight);
  } catch (const Unable&) {
    return std::nullopt;
  }
  if (!result.correction.exists) return std::nullopt;
  const Surd launch = jump.launch_velocity + Surd(result.correction.value(q.g));
  // Heights rise up to the frame nearest to the ideal time and fall from then on.
  Rational t;
  for (std::size_t n = 1; n <= FrameFlight::kMost && (q.repeat || n <= q.steps.size()); ++n) {
    if (Surd(t) > jump.ideal_time + Surd(q.fixed_dt)) break;
    t += q.steps[(n - 1) % q.steps.size()];
    const Rational steps = (t / q.fixed_dt).floor();
    if (Surd height = flight.height(launch, q.g, steps); height > result.height) {
      result.frame = n;
      result.steps = steps;
      result.height = std::move(height);
    }
  }
  result.shortfall = Surd(q.height) - result.height;
  return result;
}

/// The height from which on frame 1 is above the ground.
LiftOff lift_off_of(const FlownFrame& first, const Rational& g) {
  LiftOff result;
  if (first.rise.sign() <= 0) {
    result.reason = "a greater launch does not lift frame 1";
    return result;
  }
  const Rational least = std::max(Rational(0), first.fall / first.rise);
  result.height = g * least * least / 2;
  return result;
}

/// With x += h v - alpha g h^2, v -= g h and alpha >= 0, no frame that begins with v <= 0 ends higher.
bool stays_below(const VariableSteps& steps) {
  return steps.law && steps.law->only_squares() && steps.law->read_velocity.is_zero() &&
         steps.law->alpha.is_constant() && steps.law->alpha.constant().sign() >= 0;
}

}  // namespace

FrameJump jump(const Program& program, const FrameJumpQuestion& q) {
  if (q.height.sign() <= 0) throw BadInput("a jump is higher than 0 m, not " + q.height.str() + " m");
  if (q.g.sign() <= 0)
    throw BadInput("gravity is greater than 0 m/s^2 (downwards), not " + q.g.str() + " m/s^2");
  if (q.fixed_dt.sign() <= 0)
    throw BadInput("a time step is longer than 0 s, not " + q.fixed_dt.str() + " s");
  FrameFlight flight(program, q.steps, q.repeat, q.substeps, q.parameters);
  const Program& framed = flight.program();
  const Values values = parameter_values(framed, q.parameters);

  FrameJump jump;
  jump.integrator = program.name;
  jump.substeps = q.substeps;
  jump.g = q.g;
  jump.target = q.height;
  jump.launch_velocity = Surd::sqrt(2 * q.g * q.height);
  jump.ideal_time = jump.launch_velocity / Surd(q.g);
  jump.equal_steps = std::ranges::all_of(q.steps, [&](const Rational& h) { return h == q.steps.front(); });

  Path p = path(flight, jump.launch_velocity, q.g);
  jump.frames = std::move(p.frames);
  jump.end = p.end;
  const JumpedFrame& best = jump.frames[p.best];
  jump.best_frame = {p.best, best.height};
  jump.lifts_off = p.best > 0;
  jump.tie =
      jump.lifts_off && p.best + 1 < jump.frames.size() && jump.frames[p.best + 1].height == best.height;
  jump.shortfall = shortfall_at(best, q.height);
  jump.lift_off = lift_off_of(flight.frame(1), q.g);

  jump.steps = variable_steps(framed, q.parameters);
  const VariableSteps in_numbers = variable_steps(framed, values);
  jump.exactness = list_exactness(framed, q.parameters);
  if (!jump.steps.law) try {
      jump.unrolled = unrolled_shortfalls(framed, kUnrolled, values);
    } catch (const Unable&) {
    } catch (const Undefined&) {
    }
  jump.top_is_certain =
      jump.end == FrameJump::End::landed || (jump.end == FrameJump::End::falling && stays_below(in_numbers));
  if (jump.lifts_off) {
    const auto longest =
        std::max_element(jump.frames.begin() + 1, jump.frames.begin() + static_cast<long>(p.best) + 1,
                         [](const auto& a, const auto& b) { return a.h < b.h; });
    jump.longest = static_cast<std::size_t>(longest - jump.frames.begin());
    if (in_numbers.law && in_numbers.law->only_squares())
      jump.longest_cost =
          Surd((in_numbers.law->alpha.constant() - Rational(1, 2)) * q.g * longest->h * longest->h);
    jump.hindsight = needed(flight, p.best, jump.launch_velocity, q.g);
    jump.counter_example = counter_example(q, program, jump, p.best);
  }
  if (jump.exactness.exact != true) {
    correct(jump, q, framed, in_numbers);
    jump.accumulator = accumulated(jump, q, program);
  }
  return jump;
}

std::vector<ListExactness> catalogue_exactness() {
  std::vector<ListExactness> result;
  for (const Program& program : catalogue())
    if (family(program) != "engines")  // an engine is no step that one could take instead
      result.push_back(list_exactness(program));
  return result;
}

}  // namespace shortfall
