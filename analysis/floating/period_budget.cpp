// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/pi.hpp"
#include "analysis/floating/budget_parts.hpp"
#include "analysis/floating/passings.hpp"

namespace shortfall {

namespace {

/// An oscillation about a level, from x0, v0.
struct SpringOscillation {
  Rational level;    ///< f0/k
  Rational square;   ///< w^2 = k - c^2/4
  Rational damping;  ///< c
  int side = 0;      ///< on which side of the level it is before frame 1

  double omega() const { return std::sqrt(square.to_double()); }
  double frames_a_period(const Rational& h) const { return 2 * std::numbers::pi / omega() / h.to_double(); }
  Ball period(int bits) const { return Ball(2, bits) * pi(bits) / sqrt(Ball(square, bits)); }
};

SpringOscillation oscillation(const FloatQuestion& q) {
  const Force& f = q.force;
  if (!f.spring || f.degree > 0)
    throw Unable(
        "a period needs a spring, and no force that depends on time: --force spring:k=4, or "
        "damped-spring:k=4,c=1/2");
  if (q.program.solves)
    throw Unable(q.program.name + " has an equation of its own; a period is that of the force alone");
  SpringOscillation o;
  o.damping = f.damper ? *f.c : Rational();
  o.square = *f.k - o.damping * o.damping / Rational(4);
  if (o.square.sign() <= 0) throw Undefined("nothing oscillates under " + f.text + ": that needs k > c^2/4");
  if (const auto push = f.push.find(0); push != f.push.end()) o.level = push->second / *f.k;
  const Rational away = q.x0 - o.level;
  o.side = away.is_zero() ? q.v0.sign() : away.sign();
  if (o.side == 0) throw Undefined("the body rests where the spring holds it: there is no period");
  if (o.frames_a_period(q.h) <= 2.01)
    throw Unable(
        "there are less than two frames in a period, so that passings cannot be told apart: take a "
        "smaller --dt");
  return o;
}

/// The passings of the true motion, from its closed form, each held to the signs about it: two of them are
/// half a period apart, which is more than a frame.
Passings true_passings(const FloatQuestion& q, const SpringOscillation& o, std::size_t count) {
  const double w = o.omega(), c = o.damping.to_double(), h = q.h.to_double();
  const double a = (q.x0 - o.level).to_double(), b = (q.v0.to_double() + c / 2 * a) / w;
  double phase = std::fmod(std::atan2(b, a) + std::numbers::pi / 2,
                           std::numbers::pi);  // of the first passing, in [0, pi)
  if (phase <= 1e-12) phase += std::numbers::pi;
  const MotionFromLevel motion = true_distances(q, o.level);
  const auto distances = motion();
  Passings found;
  int side = o.side;
  const auto side_at = [&](std::int64_t n) {
    if (n == 0) return o.side;
    const auto s = distances->at(n, 256).sign();
    if (!s) throw Unable("the true motion comes too close to its level at frame " + std::to_string(n));
    return *s;
  };
  for (std::size_t i = 0; i < count; ++i, side = -side) {
    std::int64_t n =
        static_cast<std::int64_t>((phase + static_cast<double>(i) * std::numbers::pi) / w / h) + 1;
    if (side_at(n) == side)
      ++n;  // binary64 may take the frame beside it
    else if (n > 1 && side_at(n - 1) != side)
      --n;
    if (side_at(n) == side || side_at(n - 1) != side)
      throw Unable("the passings of the true motion were not found");
    found.frames.push_back(n);
  }
  return found;
}

class Reader {
 public:
  Reader(const FloatQuestion& q, int periods, const Progress& progress)
      : q_(q), o_(oscillation(q)), periods_(periods), progress_(progress) {}

  const SpringOscillation& oscillation_of() const { return o_; }
  std::int64_t most(const Rational& h) const {
    const double frames = o_.frames_a_period(h) * 2 * (periods_ + 1) + 100;
    check_steps(static_cast<std::int64_t>(std::min(frames, 1e18)));
    return static_cast<std::int64_t>(frames);
  }
  std::size_t count() const { return 2 * static_cast<std::size_t>(periods_) + 1; }

  Ball truly(const FloatQuestion& q, int bits, int periods) const {
    const Passings p = true_passings(q, o_, 2 * static_cast<std::size_t>(periods) + 1);
    return mean(passing_times(true_distances(q, o_.level), ends(p), q.h, bits), periods, bits);
  }
  Ball truly(const FloatQuestion& q, int bits) const { return truly(q, bits, periods_); }
  /// param   h  what frames are multiplied with: the step that is meant
  Ball map(const FloatQuestion& q, const Rational& h, int bits) const {
    const MotionFromLevel motion = map_distances(q, o_.level);
    const Passings p = passings(motion, o_.side, count(), most(h), q.program.name, progress_);
    if (p.frames.size() < count()) throw too_few(q.program.name, p.frames.size(), most(h));
    return mean(passing_times(motion, ends(p), h, bits), periods_, bits);
  }
  struct Run {
    Rational period;
    std::int64_t last = 0;
    std::optional<std::int64_t> not_finite_at;
  };
  Run run(FloatRun& run, const FloatFormat& format) const {
    const RunPassings p = run_passings(run, o_.level, o_.side, count(), most(q_.h), q_.h, format, progress_);
    if (p.not_finite_at) return {{}, 0, p.not_finite_at};
    if (p.frames.size() < count()) throw too_few("the run in " + format.name(), p.frames.size(), most(q_.h));
    return {(p.times.back() - p.times.front()) / Rational(periods_), p.frames.back(), {}};
  }

 private:
  static Passings ends(const Passings& p) { return {{p.frames.front(), p.frames.back()}}; }
  static Ball mean(const std::vector<Ball>& times, int periods, int bits) {
    return (times.back() - times.front()) / Ball(periods, bits);
  }
  static Unable too_few(const std::string& what, std::size_t passings, std::int64_t frames) {
    return Unable(what + " passes its level only " + std::to_string(passings) + " times in " +
                  std::to_string(frames) + " frames: it has no such period");
  }
  const FloatQuestion& q_;
  SpringOscillation o_;
  int periods_;
  const Progress& progress_;
};

}  // namespace

Budget period_budget(const FloatFormat& format, const FloatQuestion& q, int periods,
                     const Progress& progress) {
  if (periods < 1 || periods > kMostPeriods)
    throw BadInput("a number of periods is a whole number from 1 to " + std::to_string(kMostPeriods));
  Budget b{format, q, stored(q, format)};
  b.periods = periods;
  const Reader reader(q, periods, progress);
  const Reader::Run first = reader.run(*float_run(format, q), format);
  b.not_finite_at = first.not_finite_at;
  if (b.not_finite_at) return b;
  const Reader::Run second = reader.run(*second_run(format, q), format);
  b.steps = first.last;
  const SpringOscillation& o = reader.oscillation_of();
  for (int digits = first_digits(format);; digits *= 2) {
    const int bits = bits_for(digits);
    const Ball truth = o.period(bits), sampled = reader.truly(q, bits), ideal = reader.map(q, q.h, bits),
               kept = reader.map(b.stored, q.h, bits);
    std::vector<BudgetTerm> terms{{"sampling", truth - sampled},
                                  {"method", sampled - ideal},
                                  {"representation", b.stored.as_meant ? Ball(0, bits) : ideal - kept},
                                  {"rounding", kept - Ball(first.period, bits)}};
    b.lines = {budget_line("period", "s", {FloatNumber::Kind::finite, second.period}, truth,
                           o.period(bits + 40), std::move(terms), bits)};
    if (b.lines[0].closes() || digits >= kMostBudgetDigits) break;
  }
  put_first_difference(b);
  const int bits = bits_for(first_digits(format));
  put_remedies(
      b,
      {[&](const FloatQuestion& half) { return reader.truly(half, bits) - reader.map(half, half.h, bits); },
       [&](const FloatQuestion& kept) { return reader.map(q, q.h, bits) - reader.map(kept, q.h, bits); },
       [&](const FloatFormat& other) -> std::optional<Ball> {
         const Reader::Run there = reader.run(*float_run(other, q), other);
         if (there.not_finite_at) return std::nullopt;
         return reader.map(stored(q, other), q.h, bits) - Ball(there.period, bits);
       },
       [&](const FloatQuestion&) {
         const int more = 10 * periods;
         return std::pair<std::string, Ball>(
             std::to_string(more) + " periods (--periods " + std::to_string(more) + ")",
             o.period(bits) - reader.truly(q, bits, more));
       }});
  return b;
}

}  // namespace shortfall
