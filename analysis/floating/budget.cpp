// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/budget.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget_parts.hpp"
#include "analysis/floating/rounding_bound.hpp"

namespace shortfall {

namespace {

/// The computed motion and the true one after n steps, as balls.
struct ExactMotionEnd {
  Ball x, v, true_x, true_v;
};
ExactMotionEnd exact_motion_end(const FloatQuestion& q, std::int64_t steps, int digits) {
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

/// Runs to the end; the largest |x| and |v| on the way, and whether something stopped being finite.
struct RunResult {
  std::pair<FloatNumber, FloatNumber> state;
  double largest_x = 0, largest_v = 0;
  std::optional<std::int64_t> not_finite_at;
};
RunResult run_to(FloatRun& run, std::int64_t steps, const FloatFormat& format, const Progress& progress) {
  const std::int64_t report = report_steps(format);
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
    if (progress && n % report == 0)
      progress("stepping in " + format.name(), static_cast<int>(n / report),
               static_cast<int>(steps / report));
  }
  r.state = run.state();
  return r;
}

/// x, v and energy, where the exact map is known.
void put_frame_lines(Budget& b, const RunResult& r, const RunResult& second) {
  const FloatQuestion& question = b.question;
  const std::int64_t steps = b.steps;
  for (int digits = first_digits(b.format);; digits *= 2) {
    const int bits = bits_for(digits);
    const ExactMotionEnd ideal = exact_motion_end(question, steps, digits),
                         kept = exact_motion_end(b.stored, steps, digits);
    const ExactMotionEnd again = exact_motion_end(question, steps, digits + 10);
    const auto parts = [&](const Ball& truth, const Ball& method, const Ball& representation,
                           const FloatNumber& run_value) {
      return std::vector<BudgetTerm>{
          {"method", truth - method},
          {"representation", b.stored.as_meant ? Ball(0, bits) : method - representation},
          {"rounding", representation - Ball(run_value.value, bits)}};
    };
    b.lines = {budget_line("x", "m", second.state.first, ideal.true_x, again.true_x,
                           parts(ideal.true_x, ideal.x, kept.x, r.state.first), bits),
               budget_line("v", "m/s", second.state.second, ideal.true_v, again.true_v,
                           parts(ideal.true_v, ideal.v, kept.v, r.state.second), bits)};
    if (const auto energy = energy_of(question.force)) {
      const auto of = [&](const Ball& x, const Ball& v) { return (*energy)(x, v, bits); };
      const auto of_run = [&](const RunResult& result) {
        const Rational x = result.state.first.value, v = result.state.second.value;
        return FloatNumber{FloatNumber::Kind::finite,
                           v * v / Rational(2) + energy->k * x * x / Rational(2) - energy->f0 * x};
      };
      const Ball truth = of(ideal.true_x, ideal.true_v);
      b.lines.push_back(budget_line("energy", "m^2/s^2", of_run(second), truth,
                                    of(again.true_x, again.true_v),
                                    parts(truth, of(ideal.x, ideal.v), of(kept.x, kept.v), of_run(r)), bits));
    }
    const bool done = std::ranges::all_of(b.lines, [](const BudgetLine& l) { return l.closes(); });
    if (done || digits >= kMostBudgetDigits) break;
  }
}

}  // namespace

Budget budget(const FloatFormat& format, const FloatQuestion& question, std::int64_t steps,
              const Progress& progress) {
  check_steps(steps);
  Budget b{format, question, stored(question, format), steps};
  const auto run = float_run(format, question);
  const RunResult r = run_to(*run, steps, format, progress);
  if (r.not_finite_at) {
    b.not_finite_at = r.not_finite_at;
    return b;
  }
  const auto other = second_run(format, question);
  const RunResult second = run_to(*other, steps, format, progress);
  b.tracked = other->rounding();
  try {
    put_frame_lines(b, r, second);
  } catch (const Unable& e) {  // a coefficient that depends on t, for instance
    if (!b.tracked) throw;
    b.lines.clear();
    b.reason = e.what();
    put_first_difference(b);
    return b;
  }
  put_first_difference(b);
  const int digits = first_digits(format), bits = bits_for(digits);
  put_remedies(
      b, {[&](const FloatQuestion& half) {
            const ExactMotionEnd e = exact_motion_end(half, 2 * steps, digits);
            return e.true_x - e.x;
          },
          [&](const FloatQuestion& kept) {
            return exact_motion_end(question, steps, digits).x - exact_motion_end(kept, steps, digits).x;
          },
          [&](const FloatFormat& other_format) -> std::optional<Ball> {
            const RunResult there = run_to(*float_run(other_format, question), steps, other_format, progress);
            if (there.not_finite_at) return std::nullopt;
            return exact_motion_end(stored(question, other_format), steps, digits).x -
                   Ball(there.state.first.value, bits);
          }});
  b.rounding_bound = rounding_bound(format, b.stored, steps, r.largest_x, r.largest_v);
  return b;
}

}  // namespace shortfall
