// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/passings.hpp"

#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/ball_trajectory.hpp"
#include "analysis/floating/binary_format.hpp"
#include "analysis/floating/budget_parts.hpp"
#include "analysis/floating/exact_trajectory.hpp"

namespace shortfall {

namespace {

constexpr int kSignBits = 64;
constexpr int kMostSignBits = 1 << 14;
constexpr int kMostBallBits = 1024;               ///< asked for, where there are exact numbers as well
constexpr long kFewBits = 64;                     ///< a step, with which exact numbers are as fast as balls
constexpr std::int64_t kMostBallFrames = 20'000;  ///< room for their growth makes balls longer and longer

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

  /// By which the numbers get longer.
  long bits_a_step() const { return leading_bit(here_.denominator_of_a_step()); }

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

/// A map with irrational coefficients, stepped in balls.
class BallMap : public Distances {
 public:
  BallMap(const FloatQuestion& q, Rational level, std::optional<Surd> launch)
      : level_(std::move(level)), launch_(std::move(launch)), here_(made(q, launch_ ? Rational() : q.v0)) {
    if (launch_) faster_.emplace(made(q, 1));
  }
  Ball at(std::int64_t frame, int bits) override {
    if (frame > kMostBallFrames)
      throw Unable(
          "the integrator has irrational coefficients, so that its passings are looked for in at most " +
          std::to_string(kMostBallFrames) + " frames; ask for a frame instead (--steps)");
    const Ball level(level_, bits + 64), rest = here_.position(frame, bits + 64);
    if (!launch_) return rest - level;
    return rest + (faster_->position(frame, bits + 64) - rest) * ball_of(*launch_, bits + 64) - level;
  }

 private:
  static BallTrajectory made(const FloatQuestion& q, const Rational& v0) {
    NumericQuestion n = exact_question(q, 0, kBudgetDigits);
    n.v0 = v0;
    return {q.program, n};
  }
  Rational level_;
  std::optional<Surd> launch_;
  BallTrajectory here_;
  std::optional<BallTrajectory> faster_;
};

/// A map whose exact numbers are long: in balls, and exactly where these do not decide.
class LongMap : public Distances {
 public:
  LongMap(std::unique_ptr<BallMap> balls, std::unique_ptr<SteppedMap> exact)
      : balls_(std::move(balls)), exact_(std::move(exact)) {}
  Ball at(std::int64_t frame, int bits) override {
    const bool long_way = bits > kMostBallBits || frame > kMostBallFrames;
    return exact_ && long_way ? exact_->at(frame, bits) : balls_->at(frame, bits);
  }

 private:
  std::unique_ptr<BallMap> balls_;
  std::unique_ptr<SteppedMap> exact_;  ///< null where coefficients are irrational
};

/// As many bits as the sign needs.
int sign(Distances& d, std::int64_t frame, const std::string& what) {
  for (int bits = kSignBits; bits <= kMostSignBits; bits *= 4)
    if (const auto s = d.at(frame, bits).sign()) return *s;
  throw Unable(what + " comes so close to the level at frame " + std::to_string(frame) +
               " that its side is not found");
}

}  // namespace

MotionFromLevel map_distances(const FloatQuestion& question, const Rational& level,
                              const std::optional<Surd>& launch) {
  return [=]() -> std::unique_ptr<Distances> {
    FloatQuestion q = question;
    std::optional<Surd> irrational = launch;
    if (launch && launch->is_rational()) {
      q.v0 = launch->rational_part();
      irrational.reset();
    }
    std::unique_ptr<SteppedMap> exact;
    try {
      exact = std::make_unique<SteppedMap>(q, level, irrational);
      if (exact->bits_a_step() <= kFewBits) return exact;
    } catch (const Unable&) {  // irrational coefficients
    }
    return std::make_unique<LongMap>(std::make_unique<BallMap>(q, level, irrational), std::move(exact));
  };
}

MotionFromLevel parabola_distances(const Rational& h, const Surd& launch, const Rational& g) {
  return [=] {
    return std::make_unique<AnyFrame>([=](std::int64_t frame, int bits) {
      const Rational t = Rational(frame) * h;
      return ball_of(Surd(t) * launch - Surd(g * t * t / Rational(2)), bits + 64);
    });
  };
}

MotionFromLevel true_distances(const FloatQuestion& question, const Rational& level) {
  return [=] {
    return std::make_unique<AnyFrame>([=](std::int64_t frame, int bits) {
      const NumericMotion m =
          numeric_motion(question.program, exact_question(question, frame, digits_for(bits) + 20));
      return ball_of(m.exact_position, bits + 64) - Ball(level, bits + 64);
    });
  };
}

Passings passings(const MotionFromLevel& motion, int side, std::size_t count, std::int64_t most,
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

std::vector<Ball> passing_times(const MotionFromLevel& motion, const Passings& passings, const Rational& h,
                                int bits) {
  const std::unique_ptr<Distances> d = motion();
  std::vector<Ball> times;
  for (std::int64_t n : passings.frames) {
    const Ball before = d->at(n - 1, bits), after = d->at(n, bits);
    times.push_back(Ball(h, bits) * (Ball(n - 1, bits) + before / (before - after)));
  }
  return times;
}

RunPassings run_passings(FloatRun& run, const Rational& level, int side, std::size_t count, std::int64_t most,
                         const Rational& h, const FloatFormat& format, const Progress& progress) {
  const std::int64_t report = report_steps(format);
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
    if (progress && n % report == 0)
      progress("stepping in " + format.name(), static_cast<int>(n / report), static_cast<int>(most / report));
  }
  return found;
}

}  // namespace shortfall
