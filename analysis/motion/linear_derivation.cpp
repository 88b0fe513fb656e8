// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/linear_derivation.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/motion/spectrum.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongestStep = 400;  // terms; a few seconds

std::size_t size_of(const StepMap& map) {
  std::size_t terms = 0;
  for (const LinearForm& row : map.step)
    for (int c = 0; c < row.columns(); ++c) terms += row[c].numerator().terms().size();
  return terms;
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
    const std::string first = unused_name("z1", w_.letters), second = unused_name("z2", w_.letters);
    const Fraction half = trace_ / Fraction(2);
    const bool unit = determinant_ == Fraction(1);
    const std::string growth_name = free_name({"r", "rho", "growth"});
    const std::string phase_name = free_name({"theta", "phi", "phase"});
    const Expr r = unit ? number(1) : name(growth_name);
    if (!unit)
      d_.definitions.push_back(
          {growth_name, call("sqrt", {formula(determinant_, w_)}), "growth of the amplitude per step"});
    d_.definitions.push_back(
        {phase_name, call("acos", {unit ? formula(half, w_) : formula(half, w_) / r}), "phase per step"});
    const Expr n = name("n");
    const Expr angle = n * name(phase_name);
    const Expr growth = unit ? number(1) : binary(Expression::Op::power, r, n);
    const Expr sine_unit = unit ? call("sin", {name(phase_name)}) : r * call("sin", {name(phase_name)});
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
    const Expr z1 = binary(Expression::Op::power, name(first), n);
    const Expr z2 = binary(Expression::Op::power, name(second), n);
    add_case("T^2 > 4 D: two real roots " + first + ", " + second +
                 " = T/2 + sqrt(T^2/4 - D), T/2 - sqrt(T^2/4 - D)",
             half, (z1 + z2) / number(2), (z1 - z2) / (name(first) - name(second)));
  }

 private:
  /// The first of these that is no letter of the integrator.
  std::string free_name(const std::vector<std::string>& wanted) const {
    for (const std::string& word : wanted)
      if (std::ranges::find(w_.letters, word) == w_.letters.end()) return word;
    return wanted.back() + "_";
  }

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

LinearDerivation linear_derivation(const Program& program, const Force& asked, const Values& given,
                                   int substeps) {
  const Program stepped_program = substepped(program, substeps);
  const Tape tape = lower(stepped_program, given);
  LinearDerivation d;
  d.integrator = program.name;
  d.substeps = substeps;
  d.force = with_own_equation(asked, program, given);
  const Force given_force = without_own_equation(d.force);
  const Force& force = d.force;
  d.map = step_map(tape, force.degree, given_force.stiffness(), given_force.damping());
  if (const std::size_t terms = size_of(d.map); force.degree > 0 && terms > kLongestStep)
    throw Unable("one step under this force is a formula of " + std::to_string(terms) +
                 " terms, and the proof for every n multiplies them: ask for a lower degree, or for numbers "
                 "with --steps");
  const NumberField field(d.map.generators);
  // Once more, in the letters of this step.
  d.force = with_own_equation(asked, program, given, *d.map.force.extras);
  d.map.letters = d.map.force.extras->names();
  d.map.extras = d.map.force.extras->all();
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
  d.check = random_check(stepped_program, given,
                         {given_force.spring, given_force.damper, given_force.k, given_force.c}, d.map,
                         d.form, 3, 12);
  d.assumptions = {"every step has the same length h"};
  d.assumptions.insert(d.assumptions.end(), d.map.assumed.begin(), d.map.assumed.end());
  d.digits = printed_digits(program);
  if (d.digits > 0) d.assumptions.push_back(about_printed_decimals(program));
  d.singular = singular_factors(d.map);
  const bool implicit = !tape.solves.empty();
  for (const Polynomial& p : d.singular)
    d.assumptions.push_back(print(formula(Fraction(p), w)) +
                            (implicit ? " is not 0, where an implicit stage would have no solution"
                                      : " is not 0, where the step would divide by it"));
  if (d.form.valid_from > 0)
    d.assumptions.push_back("n >= " + std::to_string(d.form.valid_from) +
                            ": before that, the start is still felt");
  return d;
}

}  // namespace shortfall
