// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/rounding_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// A number's largest size, and how far off it can be. The size of a scalar that is divided by is its exact
/// size, since those here are products of constants.
struct Bounded {
  double size = 0;
  double error = 0;
};

/// Sizes and errors of one step, in a format with the unit roundoff u; results below the normal numbers are
/// off by half the least unit besides.
struct BoundProblem {
  using Scalar = Bounded;
  using Vector = Bounded;
  static inline thread_local double unit = 0, least = 0;

  const FloatQuestion* question = nullptr;
  double largest_t = 0;

  static Bounded made(double size, double error) {
    // A few units more than needed: these sums are rounded, too.
    constexpr double kUp = 1 + 1e-12;
    return {size * kUp, (error + unit * (size + error) + least) * kUp};
  }
  Scalar number(const Rational& value) const { return {std::abs(value.to_double()), 0}; }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar&) const;
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }
  Scalar function(Function, const Scalar&, const Scalar&) const { throw Unable("a function"); }
  Scalar root(const RealRoot&, const std::string&) const { throw Unable("a root"); }
  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    throw Unable("a stage");
  }
};

Bounded operator-(const Bounded& a) { return a; }
Bounded operator+(const Bounded& a, const Bounded& b) {
  return BoundProblem::made(a.size + b.size, a.error + b.error);
}
Bounded operator-(const Bounded& a, const Bounded& b) { return a + b; }
Bounded operator*(const Bounded& a, const Bounded& b) {
  return BoundProblem::made(a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error);
}
Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = b.size - b.error;
  if (!(least > 0)) throw Unable("a division");
  return BoundProblem::made(a.size / least, (a.error + a.size / least * b.error) / least);
}

Bounded BoundProblem::acceleration(const Vector& x, const Vector& v, const Scalar& t) const {
  const Force& f = question->force;
  Bounded a{};
  for (int d = f.degree; d >= 0; --d) {
    const auto push = f.push.find(d);
    const Bounded c = number(push == f.push.end() ? Rational() : push->second);
    a = d == f.degree ? c : c + Bounded{std::max(t.size, largest_t), t.error} * a;
  }
  if (f.spring) a = a + number(*f.k) * x;
  if (f.damper) a = a + number(*f.c) * v;
  return a;
}

Tape tape_of(const FloatQuestion& q) {
  return lower(q.substeps > 1 ? substepped(q.program, q.substeps) : q.program,
               parameter_values(q.program, q.parameters));
}

using Rows = std::vector<std::vector<double>>;

/// The step's matrix on the carried vectors.
std::optional<Rows> matrix_of(const Tape& tape, const FloatQuestion& q) {
  const Fraction k = q.force.spring ? Fraction(*q.force.k) : Fraction(),
                 c = q.force.damper ? Fraction(*q.force.c) : Fraction();
  Rows rows;
  for (const auto& row : step_map(tape, -1, k, c, Fraction(q.h)).matrix()) {
    rows.emplace_back();
    for (const Fraction& entry : row) {
      if (!entry.is_constant()) return std::nullopt;
      rows.back().push_back(entry.constant().to_double());
    }
  }
  return rows;
}

/// The sum of |row| times what is off.
double weighed(const std::vector<double>& row, const std::vector<double>& off) {
  double sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) sum += std::abs(row[i]) * off[i];
  return sum;
}

}  // namespace

std::optional<double> rounding_bound(const FloatFormat& format, const FloatQuestion& q, std::int64_t steps,
                                     double largest_x, double largest_v) {
  const bool once =
      format.variant == FloatFormat::Variant::plain || format.variant == FloatFormat::Variant::toward_zero;
  if (!once || format.kind == FloatFormat::Kind::double_double) return std::nullopt;
  try {
    const Tape tape = tape_of(q);
    if (!tape.finish.empty()) return std::nullopt;
    const auto m = matrix_of(tape, q);
    if (!m) return std::nullopt;
    const BinaryFormat storage = format.storage();
    const int half = format.rounding() == Rounding::nearest_even ? 0 : 1;
    BoundProblem::unit = std::ldexp(1.0, half - storage.precision);
    BoundProblem::least = std::ldexp(1.0, static_cast<int>(std::max(storage.least_unit, -1074L)) - 1 + half);
    BoundProblem problem;
    problem.question = &q;
    problem.largest_t = (q.h * Rational(steps)).to_double();
    Run<BoundProblem> run(tape, problem, problem.number(q.h));
    // The clock t is added up in the format as well: at most so far off.
    const double time_error =
        q.force.degree > 0 ? problem.largest_t * BoundProblem::unit * static_cast<double>(steps) : 0;
    run.begin({largest_x, 0}, {largest_v, 0}, {problem.largest_t, time_error});
    const std::size_t states = tape.states.size();
    std::vector<double> at_start, in_step;
    for (std::size_t s = 0; s < states; ++s) {
      const Bounded made = run.state(static_cast<int>(s));
      at_start.push_back(made.error);
      run.set_state(static_cast<int>(s), {made.size + made.error, 0});
    }
    run.step();
    for (std::size_t s = 0; s < states; ++s) in_step.push_back(run.state(static_cast<int>(s)).error);
    // Over j, |the first row of M^j| times what one step rounds.
    std::vector<double> row(states, 0), next(states);
    row[0] = 1;
    double bound = 0;
    for (std::int64_t j = 0; j < steps; ++j) {
      bound += weighed(row, in_step);
      for (std::size_t c = 0; c < states; ++c) {
        next[c] = 0;
        for (std::size_t r = 0; r < states; ++r) next[c] += row[r] * (*m)[r][c];
      }
      std::swap(row, next);
    }
    return (bound + weighed(row, at_start)) * (1 + 1e-6);
  } catch (const Unable&) {
    return std::nullopt;
  }
}

}  // namespace shortfall
