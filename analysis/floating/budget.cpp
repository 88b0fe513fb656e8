// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/budget.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/floating/rounding_bound.hpp"
#include "analysis/motion/numeric_motion.hpp"

namespace shortfall {

namespace {

constexpr int kDigits = 60;  // of every exact answer, at first
constexpr int kMostDigits = 4000;
constexpr int kNarrow = 40;  // the residual is narrower than 10^-40 of the total
constexpr std::int64_t kReport = 100'000;
constexpr std::int64_t kCompared = 100'000;  // with exact rationals: a second

Ball zero(int bits) { return Ball(0, bits); }

/// What balls compare with: the largest part, from below.
bool narrower(const Ball& residual, const Ball& total) {
  const Rational width = Rational::parse(residual.radius());
  if (width.is_zero()) return true;
  const Rational size = total.midpoint().abs();
  return !size.is_zero() && width < size / Rational(10).pow(kNarrow);
}

NumericQuestion exact_question(const FloatQuestion& q, std::int64_t steps, int digits) {
  NumericQuestion n;
  n.force = q.force;
  n.parameters = q.parameters;
  n.substeps = q.substeps;
  n.h = q.h;
  n.x0 = q.x0;
  n.v0 = q.v0;
  n.steps = Rational(steps);
  n.digits = digits;
  return n;
}

Ball ball_of(const CertainNumber& n, int bits) { return n.exact ? Ball(*n.exact, bits) : n.ball; }

int bits_for(int digits) { return digits * 4 + 64; }

/// The computed motion and the true one after n steps, as balls.
struct ExactState {
  Ball x, v, true_x, true_v;
};
ExactState exact_state(const FloatQuestion& q, std::int64_t steps, int digits) {
  const NumericMotion m = numeric_motion(q.program, exact_question(q, steps, digits));
  const int bits = bits_for(digits);
  return {ball_of(m.position, bits), ball_of(m.velocity, bits), ball_of(m.exact_position, bits),
          ball_of(m.exact_velocity, bits)};
}

/// v^2/2 + k x^2/2 - f0 x: per mass, where the force has a potential.
struct Energy {
  Rational k, f0;
  Ball operator()(const Ball& x, const Ball& v, int bits) const {
    const Ball half(Rational(1, 2), bits);
    return half * v * v + half * Ball(k, bits) * x * x - Ball(f0, bits) * x;
  }
};
std::optional<Energy> energy_of(const Force& f) {
  if (f.damper || f.degree > 0 || (!f.spring && f.degree < 0)) return std::nullopt;
  Energy e;
  if (f.spring) e.k = *f.k;
  if (const auto a = f.push.find(0); a != f.push.end()) e.f0 = a->second;
  return e;
}

BudgetLine line(const std::string& quantity, const std::string& unit, const FloatNumber& computed,
                const Ball& truth, const Ball& again, std::vector<BudgetTerm> terms, int bits) {
  BudgetLine l{quantity,         unit,      computed, truth, again - Ball(computed.value, bits),
               std::move(terms), zero(bits)};
  Ball sum = zero(bits);
  for (const BudgetTerm& t : l.terms) sum += t.value;
  l.residual = l.observed - sum;
  return l;
}

/// Runs to the end; the largest |x| and |v| on the way, and whether something stopped being finite.
struct RunResult {
  std::pair<FloatNumber, FloatNumber> state;
  double largest_x = 0, largest_v = 0;
  std::optional<std::int64_t> not_finite_at;
};
RunResult run_to(FloatRun& run, std::int64_t steps, const std::string& format, const Progress& progress) {
  RunResult r;
  std::tie(r.largest_x, r.largest_v) = run.rough();
  r.largest_x = std::abs(r.largest_x);
  r.largest_v = std::abs(r.largest_v);
  for (std::int64_t n = 1; n <= steps; ++n) {
    run.step();
    const auto [x, v] = run.rough();
    if (!(std::abs(x) < HUGE_VAL && std::abs(v) < HUGE_VAL)) {
      r.not_finite_at = n;
      return r;
    }
    r.largest_x = std::max(r.largest_x, std::abs(x));
    r.largest_v = std::max(r.largest_v, std::abs(v));
    if (progress && n % kReport == 0)
      progress("stepping in " + format, static_cast<int>(n / kReport), static_cast<int>(steps / kReport));
  }
  r.state = run.state();
  return r;
}

/// The first step at which the run is not the exact map of its constants. As long as the two agree, exact
/// numbers are as short as the run's.
void put_first_difference(Budget& b) {
  try {
    const auto run = float_run(b.format, b.question), exact = exact_run(b.stored);
    for (std::int64_t n = 1; n <= std::min(b.steps, kCompared); ++n) {
      run->step();
      exact->step();
      const auto [x, v] = run->state();
      const auto [exact_x, exact_v] = exact->state();
      b.compared = n;
      if (x.is_finite() && v.is_finite() && x.value == exact_x.value && v.value == exact_v.value) continue;
      b.differs_at = n;
      return;
    }
  } catch (const Unable&) {  // irrational coefficients: no exact run
    b.compared = 0;
  }
}

void check_steps(std::int64_t steps) {
  if (steps < 1) throw BadInput("a budget is about one step or more");
  if (steps > kMostFloatSteps)
    throw Unable(
        "a run of " + std::to_string(steps) + " steps takes days: at most " +
        std::to_string(kMostFloatSteps) +
        " are run. The exact map alone answers for any number (shortfall derive --steps), and a clock too "
        "(shortfall clock)");
}

}  // namespace

bool BudgetLine::closes() const { return residual.contains_zero() && narrower(residual, observed); }

Budget budget(const FloatFormat& format, const FloatQuestion& question, std::int64_t steps,
              const Progress& progress) {
  check_steps(steps);
  Budget b{format, question, stored(question, format), steps};
  const auto run = float_run(format, question);
  const RunResult r = run_to(*run, steps, format.name(), progress);
  if (r.not_finite_at) {
    b.not_finite_at = r.not_finite_at;
    return b;
  }
  // The observed error is taken from a second run, begun anew.
  run->begin();
  const RunResult second = run_to(*run, steps, format.name(), progress);
  for (int digits = kDigits;; digits *= 2) {
    const int bits = bits_for(digits);
    const ExactState ideal = exact_state(question, steps, digits),
                     kept = exact_state(b.stored, steps, digits);
    const ExactState again = exact_state(question, steps, digits + 10);
    const auto parts = [&](const Ball& truth, const Ball& method, const Ball& representation,
                           const FloatNumber& run_value) {
      return std::vector<BudgetTerm>{{"method", truth - method},
                                     {"representation", method - representation},
                                     {"rounding", representation - Ball(run_value.value, bits)}};
    };
    b.lines = {line("x", "m", second.state.first, ideal.true_x, again.true_x,
                    parts(ideal.true_x, ideal.x, kept.x, r.state.first), bits),
               line("v", "m/s", second.state.second, ideal.true_v, again.true_v,
                    parts(ideal.true_v, ideal.v, kept.v, r.state.second), bits)};
    if (const auto energy = energy_of(question.force)) {
      const auto of = [&](const Ball& x, const Ball& v) { return (*energy)(x, v, bits); };
      const auto of_run = [&](const RunResult& result) {
        const Rational x = result.state.first.value, v = result.state.second.value;
        return FloatNumber{FloatNumber::Kind::finite,
                           v * v / Rational(2) + energy->k * x * x / Rational(2) - energy->f0 * x};
      };
      const Ball truth = of(ideal.true_x, ideal.true_v);
      b.lines.push_back(line("energy", "m^2/s^2", of_run(second), truth, of(again.true_x, again.true_v),
                             parts(truth, of(ideal.x, ideal.v), of(kept.x, kept.v), of_run(r)), bits));
    }
    const bool done = std::ranges::all_of(b.lines, [](const BudgetLine& l) { return l.closes(); });
    if (done || digits >= kMostDigits) break;
  }
  put_first_difference(b);
  b.rounding_bound = rounding_bound(format, b.stored, steps, r.largest_x, r.largest_v);
  return b;
}

Budget peak_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                   const Rational& g, const Progress& progress) {
  if (height.sign() <= 0 || g.sign() <= 0)
    throw BadInput("a jump needs a positive height and a positive gravity");
  constexpr int kLaunchDigits = 400;
  FloatQuestion q = question;
  q.force = force_named("constant");
  q.force.push[0] = -g;
  q.x0 = 0;
  const Surd launch = Surd::sqrt(Rational(2) * g * height);
  q.v0 = launch.is_rational() ? launch.rational_part() : launch.approximation(kLaunchDigits);
  Budget b{format, q, stored(q, format)};

  // The peak of the run: the first of its highest frames.
  const auto run = float_run(format, q);
  const auto peak = [&]() {
    run->begin();
    std::pair<std::int64_t, FloatNumber> best{0, run->state().first};
    const double last = (Rational(2) * q.v0 / g / q.h).to_double() + 4;  // back on the ground
    check_steps(std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(last, 1e18))));
    for (std::int64_t n = 1; static_cast<double>(n) <= last; ++n) {
      run->step();
      const FloatNumber x = run->state().first;
      if (!x.is_finite()) {
        b.not_finite_at = n;
        break;
      }
      if (x.value > best.second.value) best = {n, x};
      if (progress && n % kReport == 0)
        progress("stepping in " + format.name(), static_cast<int>(n / kReport),
                 static_cast<int>(last / kReport));
    }
    return best;
  };
  const auto [m, computed] = peak();
  if (b.not_finite_at) return b;
  const FloatNumber again = peak().second;
  b.steps = m;

  // The map is affine in the launch: two exact runs give it for every launch, sqrt(2 g H) included.
  const auto map_at = [&](FloatQuestion at, std::int64_t n) {
    std::pair<Rational, Rational> affine;  // for launch 0, and what each unit of launch adds
    at.v0 = 0;
    const auto value = [&] {
      const CertainNumber x = numeric_motion(at.program, exact_question(at, n, kDigits)).position;
      if (!x.exact) throw Unable("the exact map has no short exact value here");
      return *x.exact;
    };
    affine.first = value();
    at.v0 = 1;
    affine.second = value() - affine.first;
    return affine;
  };
  const auto ideal_map = map_at(q, m);
  const Surd ideal = Surd(ideal_map.first) + Surd(ideal_map.second) * launch;
  const auto kept_map = map_at(b.stored, m);
  const Surd kept = Surd(kept_map.first + kept_map.second * b.stored.v0);
  const Rational t = Rational(m) * q.h;
  const Surd exact_there = Surd(t) * launch - Surd(g * t * t / Rational(2));

  const int bits = bits_for(kDigits);
  const auto as_ball = [&](const Surd& s) {
    return s.is_rational()
               ? Ball(s.rational_part(), bits)
               : Ball(s.rational_part(), bits) + Ball(s.root_part(), bits) * sqrt(Ball(s.radicand(), bits));
  };
  std::vector<BudgetTerm> terms{{"sampling", as_ball(Surd(height) - exact_there)},
                                {"method", as_ball(exact_there - ideal)},
                                {"representation", as_ball(ideal - kept)},
                                {"rounding", as_ball(kept - Surd(computed.value))}};
  b.lines = {line("peak", "m", again, Ball(height, bits), Ball(height, bits), std::move(terms), bits)};
  put_first_difference(b);
  return b;
}

}  // namespace shortfall
