// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/passings.hpp"

#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget_parts.hpp"
#include "analysis/floating/exact_trajectory.hpp"

namespace shortfall {

namespace {

constexpr int kSignBits = 64;
constexpr int kMostSignBits = 1 << 14;
constexpr std::int64_t kMostPoweredFrames = 20'000;  ///< where each costs powers of a matrix

/// A map with rational coefficients, stepped.
class SteppedMap : public Distances {
 public:
  SteppedMap(const FloatQuestion& q, Rational level, std::optional<Surd> launch)
      : level_(std::move(level)), launch_(std::move(launch)), here_(made(q, launch_ ? Rational() : q.v0)) {
    if (launch_) faster_.emplace(made(q, 1));
  }
  Ball at(std::int64_t frame, int bits) override {
    here_.advance(frame - here_.frame());
    if (!launch_) return here_.position().minus(level_, bits);
    faster_->advance(frame - faster_->frame());
    // The map is affine in the launch: what a unit of it adds is the difference of the two.
    const Ball rest = here_.position().ball(bits + 64), unit = faster_->position().ball(bits + 64) - rest;
    return rest + unit * ball_of(*launch_, bits + 64) - Ball(level_, bits + 64);
  }

 private:
  static ExactTrajectory made(const FloatQuestion& q, const Rational& v0) {
    NumericQuestion n = exact_question(q, 0, kBudgetDigits);
    n.v0 = v0;
    return {q.program, n};
  }
  Rational level_;
  std::optional<Surd> launch_;
  ExactTrajectory here_;
  std::optional<ExactTrajectory> faster_;
};

/// A motion known for any frame by itself.
class AnyFrame : public Distances {
 public:
  using Value = std::function<Ball(std::int64_t frame, int bits)>;
  explicit AnyFrame(Value value) : value_(std::move(value)) {}
  Ball at(std::int64_t frame, int bits) override { return value_(frame, bits); }

 private:
  Value value_;
};

int digits_for(int bits) { return bits * 3 / 10 + 1; }

/// A map with irrational coefficients, by powers of its matrix in balls.
Ball powered(FloatQuestion q, const Rational& level, const std::optional<Surd>& launch, std::int64_t frame,
             int bits) {
  if (frame > kMostPoweredFrames)
    throw Unable(q.program.name +
                 " has irrational coefficients, so that its passings are looked for in at most " +
                 std::to_string(kMostPoweredFrames) + " frames; ask for a frame instead (--steps)");
  const auto x = [&](const Rational& v0) {
    q.v0 = v0;
    return ball_of(numeric_motion(q.program, exact_question(q, frame, digits_for(bits) + 20)).position,
                   bits + 64);
  };
  const Ball level_here(level, bits + 64);
  if (!launch) return x(q.v0) - level_here;
  const Ball rest = x(0);
  return rest + (x(1) - rest) * ball_of(*launch, bits + 64) - level_here;
}

/// As many bits as the sign needs.
int sign(Distances& d, std::int64_t frame, const std::string& what) {
  for (int bits = kSignBits; bits <= kMostSignBits; bits *= 4)
    if (const auto s = d.at(frame, bits).sign()) return *s;
  throw Unable(what + " comes so close to the level at frame " + std::to_string(frame) +
               " that its side is not found");
}

}  // namespace

Motion map_distances(const FloatQuestion& question, const Rational& level,
                     const std::optional<Surd>& launch) {
  return [=]() -> std::unique_ptr<Distances> {
    FloatQuestion q = question;
    std::optional<Surd> irrational = launch;
    if (launch && launch->is_rational()) {
      q.v0 = launch->rational_part();
      irrational.reset();
    }
    try {
      return std::make_unique<SteppedMap>(q, level, irrational);
    } catch (const Unable&) {  // irrational coefficients
      return std::make_unique<AnyFrame>(
          [=](std::int64_t frame, int bits) { return powered(q, level, irrational, frame, bits); });
    }
  };
}

Motion parabola_distances(const Rational& h, const Surd& launch, const Rational& g) {
  return [=] {
    return std::make_unique<AnyFrame>([=](std::int64_t frame, int bits) {
      const Rational t = Rational(frame) * h;
      return ball_of(Surd(t) * launch - Surd(g * t * t / Rational(2)), bits + 64);
    });
  };
}

Motion true_distances(const FloatQuestion& question, const Rational& level) {
  return [=] {
    return std::make_unique<AnyFrame>([=](std::int64_t frame, int bits) {
      const NumericMotion m =
          numeric_motion(question.program, exact_question(question, frame, digits_for(bits) + 20));
      return ball_of(m.exact_position, bits + 64) - Ball(level, bits + 64);
    });
  };
}

Passings passings(const Motion& motion, int side, std::size_t count, std::int64_t most,
                  const std::string& what, const Progress& progress) {
  const std::unique_ptr<Distances> d = motion();
  Passings found;
  for (std::int64_t n = 1; n <= most && found.frames.size() < count; ++n) {
    if (sign(*d, n, what) != side) {
      found.frames.push_back(n);
      side = -side;
    }
    if (progress && n % 1000 == 0)
      progress("looking for passings of " + what, static_cast<int>(n / 1000), static_cast<int>(most / 1000));
  }
  return found;
}

std::vector<Ball> passing_times(const Motion& motion, const Passings& passings, const Rational& h, int bits) {
  const std::unique_ptr<Distances> d = motion();
  std::vector<Ball> times;
  for (std::int64_t n : passings.frames) {
    const Ball before = d->at(n - 1, bits), after = d->at(n, bits);
    times.push_back(Ball(h, bits) * (Ball(n - 1, bits) + before / (before - after)));
  }
  return times;
}

RunPassings run_passings(FloatRun& run, const Rational& level, int side, std::size_t count, std::int64_t most,
                         const Rational& h, const std::string& format, const Progress& progress) {
  RunPassings found;
  Rational before = run.state().first.value - level;
  for (std::int64_t n = 1; n <= most && found.frames.size() < count; ++n) {
    run.step();
    const FloatNumber x = run.state().first;
    if (!x.is_finite()) {
      found.not_finite_at = n;
      return found;
    }
    const Rational after = x.value - level;
    if (after.sign() != side) {
      found.frames.push_back(n);
      const Rational moved = before - after;  // 0 where it begins at the level and does not move
      found.times.push_back(h * (Rational(n - 1) + (moved.is_zero() ? Rational(1) : before / moved)));
      side = -side;
    }
    before = after;
    if (progress && n % kReportSteps == 0)
      progress("stepping in " + format, static_cast<int>(n / kReportSteps),
               static_cast<int>(most / kReportSteps));
  }
  return found;
}

}  // namespace shortfall
