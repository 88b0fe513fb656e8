// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/amplification.hpp"

#include <algorithm>

#include "analysis/motion/step_map.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

constexpr Letter kEigenvalue = kTimeLetter;  // a step's matrix does not contain the letter of time

/// Monic in the eigenvalue, lowest power first.
std::vector<Fraction> monic(const Polynomial& p) {
  const std::vector<Polynomial> coefficients = p.coefficients(kEigenvalue);
  std::vector<Fraction> result;
  for (const Polynomial& c : coefficients) result.emplace_back(c, coefficients.back());
  return result;
}

Polynomial cleared(const std::vector<Fraction>& p) {
  Polynomial common = 1;
  for (const Fraction& c : p) common = common * exact_quotient(c.denominator(), gcd(common, c.denominator()));
  Polynomial result;
  for (std::size_t k = 0; k < p.size(); ++k)
    result += (p[k] * Fraction(common)).numerator() * Polynomial::letter(kEigenvalue, static_cast<int>(k));
  return result;
}

/// Whether a factor has the root 1 where there is no force.
bool belongs_to_motion(const Polynomial& factor) {
  return factor.substitute(kStiffness, Rational(0))
      .substitute(kDamping, Rational(0))
      .substitute(kEigenvalue, Rational(1))
      .is_zero();
}

void split(Amplification& a) {
  std::vector<Fraction> p = characteristic_coefficients(a.matrix);
  for (Fraction& c : p) c = reduced(c, a.algebraic);
  while (p[static_cast<std::size_t>(a.zeros)].is_zero()) ++a.zeros;
  a.nonzero.assign(p.begin() + a.zeros, p.end());
  if (a.nonzero.size() == 3) {
    a.pair = a.nonzero;
    return;
  }
  Polynomial motion = 1, others = 1;
  for (const auto& [factor, multiplicity] : factor(cleared(a.nonzero)).factors) {
    if (factor.degree(kEigenvalue) < 1) continue;
    Polynomial& product = belongs_to_motion(factor) ? motion : others;
    product = product * factor.pow(multiplicity);
  }
  if (motion.degree(kEigenvalue) != 2) return;
  a.pair = monic(motion);
  a.spurious = monic(others);
}

}  // namespace

Fraction Amplification::trace() const {
  if (pair.empty())
    throw Unable("the motion's two eigenvalues cannot be told from " + std::to_string(spurious_count()) +
                 " spurious one(s) by a formula without roots, so there is no trace of their own");
  return -pair[1];
}

Fraction Amplification::determinant() const {
  if (pair.empty()) trace();
  return pair[0];
}

Amplification amplification(SquareMatrix<Fraction> matrix, std::vector<std::string> letters,
                            std::vector<std::string> states, std::vector<AlgebraicLetter> algebraic) {
  Amplification result;
  result.letters = std::move(letters);
  result.states = std::move(states);
  result.algebraic = std::move(algebraic);
  result.matrix = reduced(std::move(matrix), result.algebraic);
  split(result);
  return result;
}

Amplification amplification(const Program& program, const Values& given, Damping damping,
                            FreeFunctions functions) {
  const Fraction c = damping == Damping::viscous ? Fraction::letter(kDamping) : Fraction();
  const auto is_number = [](const ExtraLetters::Extra& e) { return e.root != nullptr; };
  StepMap map = step_map(lower(program, given), -1, Fraction::letter(kStiffness), c);
  // exp and pow of parameters are no rational functions; of the parameters' values they may be numbers.
  if (functions == FreeFunctions::evaluated && !std::ranges::all_of(map.extras, is_number))
    map = step_map(lower(program, parameter_values(program, given)), -1, Fraction::letter(kStiffness), c);
  std::vector<AlgebraicLetter> algebraic;
  for (const ExtraLetters::Extra& e : map.extras) {
    if (!e.root && functions == FreeFunctions::letters) continue;
    if (!e.root)
      throw Unable("the step of " + program.name + " contains " + e.name +
                   ", which depends on the length of the step itself");
    algebraic.push_back({e.letter, *e.root});
  }
  const NumberField field(map.generators);
  SquareMatrix<Fraction> matrix;
  for (auto& row : map.matrix()) {
    matrix.emplace_back();
    for (const Fraction& f : row) {
      if (f.contains(kCount))
        throw Unable("the step of " + program.name + " changes with t, so it has no amplification matrix");
      matrix.back().push_back(f.substitute(kStepLetter, Fraction(1)));
    }
  }
  return amplification(std::move(matrix), map.letters, map.states, std::move(algebraic));
}

Amplification repeated(const Amplification& step, int count) {
  if (count == 1) return step;
  SquareMatrix<Fraction> once = step.matrix;
  for (auto& row : once)
    for (Fraction& f : row)
      f = f.substitute(kStiffness, Fraction::letter(kStiffness) / Fraction(count * count))
              .substitute(kDamping, Fraction::letter(kDamping) / Fraction(count));
  SquareMatrix<Fraction> matrix = once;
  for (int k = 1; k < count; ++k) matrix = reduced(product(matrix, once), step.algebraic);
  return amplification(std::move(matrix), step.letters, step.states, step.algebraic);
}

Fraction trace(const Program& program, const Values& given) { return amplification(program, given).trace(); }

Fraction determinant(const Program& program, const Values& given) {
  return amplification(program, given).determinant();
}

}  // namespace shortfall
