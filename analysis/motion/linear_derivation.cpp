// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/linear_derivation.hpp"

#include <algorithm>
#include <random>

#include "analysis/motion/spectrum.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// Steps random rational numbers and holds the closed form against them: no letters, another interpreter's
/// problem.
RandomCheck random_check(const Tape& tape, const Program& program, const Values& given,
                         const LinearDerivation& d) {
  constexpr int kTrials = 3;
  constexpr int kSteps = 12;
  RandomCheck check{kTrials, kSteps, true};
  std::mt19937 random(1687);
  const auto draw = [&] {
    return Rational(static_cast<int>(random() % 81) - 40, 1 + static_cast<int>(random() % 9));
  };
  const auto positive = [&] {
    return Rational(1 + static_cast<int>(random() % 40), 1 + static_cast<int>(random() % 9));
  };
  const Values parameters = parameter_values(program, given);
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Rational> column{draw(), draw()};
    for (int i = 0; i <= d.force.degree; ++i) column.push_back(draw());
    const Rational h(1, 2 + static_cast<int>(random() % 30));
    const Rational k = d.force.spring ? d.force.k.value_or(positive()) : Rational(0);
    const Rational c = d.force.damper ? d.force.c.value_or(positive()) : Rational(0);
    std::map<Letter, Rational> letters{
        {kStepLetter, h}, {kStiffness, k}, {kDamping, c}, {kTimeLetter, 0}, {kCount, 0}};
    for (std::size_t i = 0; i < tape.parameters.size(); ++i)
      letters[kFirstParameter + static_cast<int>(i)] = parameters.at(tape.parameters[i].name);
    Numbers<Rational> problem{[&](const Rational& x, const Rational& v, const Rational& t) {
      Rational f;
      for (int i = d.force.degree; i >= 0; --i) f = f * t + column[2 + i];
      return f - k * x - c * v;
    }};
    try {
      Run<Numbers<Rational>> run(tape, problem, h);
      run.begin(column[0], column[1], 0);
      std::vector<Rational> polynomial;
      for (const Fraction& f : d.form.oscillation.polynomial) polynomial.push_back(f.evaluate(letters));
      // The oscillation in numbers: its first values, then its recurrence.
      const auto first = [&](const Oscillation::Values& values) {
        std::vector<Rational> sum(d.form.oscillation.order());
        for (std::size_t col = 0; col < column.size(); ++col)
          for (std::size_t j = 0; j < sum.size(); ++j)
            sum[j] += values[col][j].evaluate(letters) * column[col];
        return sum;
      };
      std::vector<Rational> rx = first(d.form.oscillation.position);
      std::vector<Rational> rv = first(d.form.oscillation.velocity);
      const auto advance = [&](std::vector<Rational>& window) {
        if (window.empty()) return;
        Rational next;
        for (std::size_t j = 0; j < window.size(); ++j) next -= polynomial[j] * window[j];
        window.erase(window.begin());
        window.push_back(next);
      };
      for (int n = 0; n <= kSteps; ++n, advance(rx), advance(rv)) {
        if (n > 0) run.step();
        if (n < d.form.valid_from) continue;
        const auto [x, v] = run.read_out();
        letters[kCount] = n;
        for (const auto& [stepped, motion, rest] :
             {std::tuple{x, &d.form.position, &rx}, {v, &d.form.velocity, &rv}}) {
          Rational closed = rest->empty() ? Rational(0) : rest->front();
          for (std::size_t col = 0; col < motion->size(); ++col)
            for (const Sequence::Term& term : (*motion)[col].terms())
              closed += term.coefficient.evaluate(letters) * term.base.evaluate(letters).pow(n) * column[col];
          check.agrees = check.agrees && closed == stepped;
        }
      }
    } catch (const Undefined&) {
      --check.trials;  // the numbers hit a pole of the step; the formula says so itself
    }
  }
  check.agrees = check.agrees && check.trials > 0;
  return check;
}

/// Puts the pieces of a two-term oscillation together.
class Wave {
 public:
  explicit Wave(LinearDerivation& d)
      : d_(d),
        w_(d.wording()),
        trace_(-d.form.oscillation.polynomial[1]),
        determinant_(d.form.oscillation.polynomial[0]) {}

  void tell() {
    const Fraction half = trace_ / Fraction(2);
    const bool unit = determinant_ == Fraction(1);
    const Expr r = unit ? number(1) : name("r");
    if (!unit)
      d_.definitions.push_back(
          {"r", call("sqrt", {formula(determinant_, w_)}), "growth of the amplitude per step"});
    d_.definitions.push_back(
        {"theta", call("acos", {unit ? formula(half, w_) : formula(half, w_) / r}), "phase per step"});
    const Expr n = name("n");
    const Expr angle = n * name("theta");
    const Expr growth = unit ? number(1) : binary(Expression::Op::power, r, n);
    const Expr sine_unit = unit ? call("sin", {name("theta")}) : r * call("sin", {name("theta")});
    d_.position = wave(d_.form.position, d_.form.oscillation.position, half, growth * call("cos", {angle}),
                       growth * call("sin", {angle}) / sine_unit);
    d_.velocity = wave(d_.form.velocity, d_.form.oscillation.velocity, half, growth * call("cos", {angle}),
                       growth * call("sin", {angle}) / sine_unit);
    const std::string trace = print(formula(trace_, w_));
    d_.condition =
        "T^2 < 4 D, with T = " + trace + ", D = " + print(formula(determinant_, w_)) + ": two complex roots";
    // Double root T/2: the powers (T/2)^n and n (T/2)^(n-1).
    const Expr root = formula(half, w_);
    add_case("T^2 = 4 D: a double root T/2", half, binary(Expression::Op::power, root, n),
             n * binary(Expression::Op::power, root, n - number(1)));
    // Two real roots z1, z2: half their sum of powers takes the place of the cosine, the difference over z1 -
    // z2 that of the sine.
    const Expr z1 = binary(Expression::Op::power, name("z1"), n);
    const Expr z2 = binary(Expression::Op::power, name("z2"), n);
    add_case("T^2 > 4 D: two real roots z1, z2 = T/2 + sqrt(T^2/4 - D), T/2 - sqrt(T^2/4 - D)", half,
             (z1 + z2) / number(2), (z1 - z2) / (name("z1") - name("z2")));
  }

 private:
  void add_case(const std::string& condition, const Fraction& half, const Expr& cosine, const Expr& sine) {
    d_.cases.push_back({condition, wave(d_.form.position, d_.form.oscillation.position, half, cosine, sine),
                        wave(d_.form.velocity, d_.form.oscillation.velocity, half, cosine, sine)});
  }

  /// rational part + A cosine + B sine, where A = r(0) and B = r(1) - T/2 r(0).
  Expr wave(const Motion& rational, const Oscillation::Values& values, const Fraction& half,
            const Expr& cosine, const Expr& sine) const {
    Expr total = formula(rational, d_.force.degree, w_);
    for (const bool with_cosine : {true, false}) {
      Expr amplitude = number(0);
      for (std::size_t c = 0; c < values.size(); ++c) {
        const Fraction a = with_cosine ? values[c][0] : values[c][1] - half * values[c][0];
        amplitude =
            joined(amplitude, formula(a, name(column_name(static_cast<int>(c), d_.force.degree)), w_));
      }
      if (is_number(amplitude, 0)) continue;
      const bool minus = amplitude->op == Expression::Op::negate;
      const Expr part = chained(minus ? amplitude->operands[0] : amplitude, with_cosine ? cosine : sine);
      total = is_number(total, 0) ? (minus ? negate(part) : part) : minus ? total - part : total + part;
    }
    return total;
  }

  LinearDerivation& d_;
  Wording w_;
  Fraction trace_;
  Fraction determinant_;
};

/// Reported x and v after n steps as functions of x0, v0.
Matrix pair_after(const ClosedForm& form, int n) {
  Matrix m(2, std::vector<Fraction>(2));
  for (const int column : {0, 1})
    for (const int row : {0, 1}) m[row][column] = motion_at(form, row == 0, n, column);
  return m;
}

/// The matrix that takes each reported pair to the next one, if there is one: then the pair alone carries the
/// motion.
void find_amplification(LinearDerivation& d) {
  const int from = d.form.valid_from;
  const Matrix first = pair_after(d.form, from);
  const Fraction size = first[0][0] * first[1][1] - first[0][1] * first[1][0];
  if (size.is_zero()) return;
  const Matrix second = pair_after(d.form, from + 1);
  Matrix m = second * Matrix{{first[1][1], -first[0][1]}, {-first[1][0], first[0][0]}};
  for (auto& row : m)
    for (Fraction& entry : row) entry /= size;
  // Both sides of x(n+1) = M x(n) satisfy a recurrence of the order of the carried vectors: so many n are all
  // n.
  Matrix now = second;
  for (int n = from + 1; n <= from + d.map.force.states; ++n) {
    const Matrix next = pair_after(d.form, n + 1);
    if (!(m * now == next)) return;
    now = next;
  }
  d.amplification = m;
  d.amplified_from = from;
  d.trace = m[0][0] + m[1][1];
  d.determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  d.discriminant = d.trace->pow(2) - Fraction(4) * *d.determinant;
}

/// Whether it is positive for every step length: a polynomial in h alone with coefficients of one sign.
bool is_harmless(const Polynomial& p) {
  for (const Polynomial::Term& t : p.terms())
    if (t.monomial.total_degree() != t.monomial.exponent(kStepLetter) || t.coefficient.sign() < 0)
      return false;
  return true;
}

/// The factors of the step's denominators: an implicit stage divides by them.
std::vector<Polynomial> singular_factors(const StepMap& map) {
  std::vector<Polynomial> found;
  for (const LinearForm& row : map.step)
    for (int c = 0; c < row.columns(); ++c)
      for (const auto& [factor, multiplicity] : factor(row[c].denominator()).factors)
        if (!is_harmless(factor) && std::ranges::find(found, factor) == found.end()) found.push_back(factor);
  return found;
}

}  // namespace

LinearDerivation linear_derivation(const Program& program, const Force& force, const Values& given,
                                   int substeps) {
  const Program stepped_program = substepped(program, substeps);
  const Tape tape = lower(stepped_program, given);
  LinearDerivation d;
  d.integrator = program.name;
  d.force = force;
  d.substeps = substeps;
  d.map = step_map(tape, force.degree, force.stiffness(), force.damping());
  d.form = closed_form(d.map);
  d.proof = prove(d.map, d.form);
  d.exact = linear_flow(force, d.map.letters);
  find_amplification(d);
  const Wording w = d.wording();
  if (d.form.oscillation.is_zero()) {
    d.position = formula(d.form.position, force.degree, w);
    d.velocity = formula(d.form.velocity, force.degree, w);
  } else if (d.form.oscillation.order() == 2) {
    Wave(d).tell();
  }
  d.check = random_check(tape, stepped_program, given, d);
  d.assumptions = {"every step has the same length h"};
  d.singular = singular_factors(d.map);
  for (const Polynomial& p : d.singular)
    d.assumptions.push_back(print(formula(Fraction(p), w)) +
                            " is not 0, where an implicit stage would have no solution");
  if (d.form.valid_from > 0)
    d.assumptions.push_back("n >= " + std::to_string(d.form.valid_from) +
                            ": before that, the start is still felt");
  return d;
}

}  // namespace shortfall
