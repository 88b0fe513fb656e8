// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget_parts.hpp"
#include "analysis/floating/passings.hpp"

namespace shortfall {

namespace {

constexpr int kMoreDigits = 60;  // of what is not known exactly

/// A position at a frame: exact, or a ball.
struct Position {
  std::optional<Surd> exact{};
  Ball ball{};
};

/// For an integrator under a constant force: its map is affine in the launch, so two exact answers give it
/// for every launch, sqrt(2 g H) included.
Position position_at(FloatQuestion at, std::int64_t n, const Surd& launch, int bits) {
  const int digits = bits / 4 + kMoreDigits;
  const auto answer = [&](const Rational& v0) {
    at.v0 = v0;
    return numeric_motion(at.program, exact_question(at, n, digits)).position;
  };
  const CertainNumber rest = answer(0), moving = answer(1);
  if (rest.exact && moving.exact) return {Surd(*rest.exact) + Surd(*moving.exact - *rest.exact) * launch};
  const int more = bits_for(digits);
  const Ball still = ball_of(rest, more);
  return {{}, still + (ball_of(moving, more) - still) * ball_of(launch, more)};
}

Ball difference(const Position& a, const Position& b, int bits) {
  if (a.exact && b.exact) return ball_of(*a.exact - *b.exact, bits);
  const auto ball = [&](const Position& p) { return p.exact ? ball_of(*p.exact, bits) : p.ball; };
  return ball(a) - ball(b);
}

/// What a run of a jump is held to.
class Peak {
 public:
  Peak(const Surd& launch, const Rational& height, const Rational& g)
      : launch_(launch), height_(height), g_(g) {}

  Position parabola(const Rational& t) const { return {Surd(t) * launch_ - Surd(g_ * t * t / Rational(2))}; }
  Ball sampling(const Rational& t, int bits) const { return difference({Surd(height_)}, parabola(t), bits); }
  Ball method(const FloatQuestion& q, std::int64_t n, int bits) const {
    return difference(parabola(Rational(n) * q.h), position_at(q, n, launch_, bits), bits);
  }
  Ball representation(const FloatQuestion& q, const FloatQuestion& kept, std::int64_t n, int bits) const {
    return difference(position_at(q, n, launch_, bits), position_at(kept, n, Surd(kept.v0), bits), bits);
  }
  static Ball rounding(const FloatQuestion& kept, const FloatNumber& computed, std::int64_t n, int bits) {
    return difference(position_at(kept, n, Surd(kept.v0), bits), {Surd(computed.value)}, bits);
  }
  /// The best of the frames of half a step about the frame m.
  Ball sampling_at_half(const FloatQuestion& half, std::int64_t m, int bits) const {
    Ball best = sampling(Rational(2 * m) * half.h, bits);
    for (std::int64_t n : {2 * m - 1, 2 * m + 1})
      if (const Ball other = sampling(Rational(n) * half.h, bits); other.to_double() < best.to_double())
        best = other;
    return best;
  }

 private:
  const Surd& launch_;
  const Rational &height_, &g_;
};

std::int64_t flight_frames(const FloatQuestion& q, const Rational& g, int flights) {
  const double frames = (Rational(2) * q.v0 / g / q.h).to_double() * flights + 4;
  check_steps(std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(frames, 1e18))));
  return static_cast<std::int64_t>(frames);
}

}  // namespace

Budget peak_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                   const Rational& g, const Progress& progress) {
  const JumpBudgetQuestion jump = jump_question(question, height, g);
  const FloatQuestion& q = jump.question;
  Budget b{format, q, stored(q, format)};
  const std::int64_t last = flight_frames(q, g, 1);  // back on the ground

  const std::int64_t report = report_steps(format);

  // The peak of the run: the first of its highest frames.
  const auto peak = [&](FloatRun& run) {
    std::pair<std::int64_t, FloatNumber> best{0, run.state().first};
    for (std::int64_t n = 1; n <= last; ++n) {
      run.step();
      const FloatNumber x = run.state().first;
      if (!x.is_finite()) {
        b.not_finite_at = n;
        break;
      }
      if (x.value > best.second.value) {
        best = {n, x};
        b.tracked = run.rounding();
      }
      if (progress && n % report == 0)
        progress("stepping in " + format.name(), static_cast<int>(n / report),
                 static_cast<int>(last / report));
    }
    return best;
  };
  const std::pair<std::int64_t, FloatNumber> first = peak(*float_run(format, q));
  if (b.not_finite_at) return b;
  const FloatNumber again = peak(*second_run(format, q)).second;
  const std::int64_t m = b.steps = first.first;

  const int bits = bits_for(first_digits(format));
  const Peak exact(jump.launch, height, g);
  std::vector<BudgetTerm> terms{{"sampling", exact.sampling(Rational(m) * q.h, bits)},
                                {"method", exact.method(q, m, bits)},
                                {"representation", exact.representation(q, b.stored, m, bits)},
                                {"rounding", Peak::rounding(b.stored, first.second, m, bits)}};
  b.lines = {budget_line("peak", "m", again, Ball(height, bits), Ball(height, bits), std::move(terms), bits)};
  put_first_difference(b);
  put_remedies(b, {[&](const FloatQuestion& half) { return exact.method(half, 2 * m, bits); },
                   [&](const FloatQuestion& kept) { return exact.representation(q, kept, m, bits); },
                   [&](const FloatFormat& other) -> std::optional<Ball> {
                     const auto run = float_run(other, q);
                     for (std::int64_t n = 0; n < m; ++n) run->step();
                     const FloatNumber x = run->state().first;
                     if (!x.is_finite()) return std::nullopt;
                     return Peak::rounding(stored(q, other), x, m, bits);
                   },
                   [&](const FloatQuestion& half) {
                     return std::pair<std::string, Ball>("", exact.sampling_at_half(half, m, bits));
                   }});
  return b;
}

namespace {

/// The time at which a motion from the ground comes down again, as its frames say.
Ball landing(const MotionFromLevel& motion, std::int64_t most, const Rational& h, const std::string& what,
             int bits, const Progress& progress) {
  const Passings found = passings(motion, 1, 1, most, what, progress);
  if (found.frames.empty())
    throw Unable(what + " has not come down again after " + std::to_string(most) + " frames");
  if (found.frames[0] == 1) throw Unable(what + " does not leave the ground: its frame 1 is not above it");
  return passing_times(motion, found, h, bits)[0];
}

RunPassings run_landing(FloatRun& run, std::int64_t most, const Rational& h, const FloatFormat& format,
                        const Progress& progress) {
  RunPassings found = run_passings(run, 0, 1, 1, most, h, format, progress);
  if (found.not_finite_at) return found;
  if (found.frames.empty())
    throw Unable("the run in " + format.name() + " has not come down again after " + std::to_string(most) +
                 " frames");
  if (found.frames[0] == 1)
    throw Unable("the run in " + format.name() + " does not leave the ground: its frame 1 is not above it");
  return found;
}

}  // namespace

Budget landing_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                      const Rational& g, const Progress& progress) {
  const JumpBudgetQuestion jump = jump_question(question, height, g);
  const FloatQuestion& q = jump.question;
  Budget b{format, q, stored(q, format)};
  constexpr int kFlights = 3;  // a method's may be longer than the true one
  const std::int64_t most = flight_frames(q, g, kFlights);
  const RunPassings first = run_landing(*float_run(format, q), most, q.h, format, progress);
  b.not_finite_at = first.not_finite_at;
  if (b.not_finite_at) return b;
  const RunPassings second = run_landing(*second_run(format, q), most, q.h, format, progress);
  b.steps = first.frames[0];

  const auto exact = [&](const Rational& h, int bits) {
    return landing(parabola_distances(h, jump.launch, g), 2 * most, h, "the parabola", bits, progress);
  };
  const auto map = [&](const FloatQuestion& at, int bits) {
    return landing(map_distances(at, 0, jump.launch), 2 * most, at.h, q.program.name, bits, progress);
  };
  // Frames of the stored map are read with the step that is meant, as those of the run are.
  const auto kept_map = [&](const FloatQuestion& kept, int bits) {
    return landing(map_distances(kept, 0), 2 * most, q.h, q.program.name + " with stored constants", bits,
                   progress);
  };
  const Surd truth = Surd(Rational(2) / g) * jump.launch;
  for (int digits = first_digits(format);; digits *= 2) {
    const int bits = bits_for(digits);
    const Ball sampled = exact(q.h, bits), ideal = map(q, bits), kept = kept_map(b.stored, bits);
    std::vector<BudgetTerm> terms{{"sampling", ball_of(truth, bits) - sampled},
                                  {"method", sampled - ideal},
                                  {"representation", ideal - kept},
                                  {"rounding", kept - Ball(first.times[0], bits)}};
    b.lines = {budget_line("landing", "s", {FloatNumber::Kind::finite, second.times[0]}, ball_of(truth, bits),
                           ball_of(truth, bits + 40), std::move(terms), bits)};
    if (b.lines[0].closes() || digits >= kMostBudgetDigits) break;
  }
  put_first_difference(b);
  const int bits = bits_for(first_digits(format));
  put_remedies(b, {[&](const FloatQuestion& half) { return exact(half.h, bits) - map(half, bits); },
                   [&](const FloatQuestion& kept) { return map(q, bits) - kept_map(kept, bits); },
                   [&](const FloatFormat& other) -> std::optional<Ball> {
                     const RunPassings there = run_landing(*float_run(other, q), most, q.h, other, progress);
                     if (there.not_finite_at) return std::nullopt;
                     return kept_map(stored(q, other), bits) - Ball(there.times[0], bits);
                   },
                   [&](const FloatQuestion& half) {
                     return std::pair<std::string, Ball>("", ball_of(truth, bits) - exact(half.h, bits));
                   }});
  return b;
}

}  // namespace shortfall
