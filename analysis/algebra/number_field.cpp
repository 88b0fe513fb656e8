// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/number_field.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/linear_solve.hpp"

namespace shortfall {

namespace {

/// Lowest power first, at most degree-many coefficients, each free of the generator.
std::vector<Polynomial> remainder(std::vector<Polynomial> p, const NumberField::Generator& g) {
  const std::size_t degree = g.minimal.size() - 1;
  while (p.size() > degree) {
    const Polynomial leading = std::move(p.back());
    p.pop_back();
    if (leading.is_zero()) continue;
    for (std::size_t k = 0; k < degree; ++k)
      if (!g.minimal[k].is_zero()) p[p.size() - degree + k] -= leading * Polynomial(g.minimal[k]);
  }
  return p;
}

Polynomial joined(const std::vector<Polynomial>& coefficients, Letter letter) {
  Polynomial result;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    result += coefficients[k] * Polynomial::letter(letter, static_cast<int>(k));
  return result;
}

/// c with c p = 1 modulo the generator's minimal polynomial, each coefficient a fraction free of the
/// generator.
std::vector<Fraction> inverse(const Polynomial& p, const NumberField::Generator& g) {
  const std::size_t degree = g.minimal.size() - 1;
  std::vector<std::vector<Fraction>> matrix(degree, std::vector<Fraction>(degree));
  std::vector<Polynomial> shifted = p.coefficients(g.letter);
  for (std::size_t column = 0; column < degree; ++column) {
    const std::vector<Polynomial> rest = remainder(shifted, g);
    for (std::size_t row = 0; row < rest.size(); ++row) matrix[row][column] = rest[row];
    shifted.insert(shifted.begin(), Polynomial());
  }
  std::vector<Fraction> one(degree);
  one[0] = 1;
  const auto found = solve_linear<Fraction>(matrix, one);
  if (!found.solution) throw Error("a minimal polynomial is reducible over its field");
  return *found.solution;
}

}  // namespace

NumberField::NumberField(std::vector<Generator> generators)
    : outer_(current_), generators_(std::move(generators)) {
  current_ = this;
}

NumberField::~NumberField() { current_ = outer_; }

void NumberField::adjoin(Generator generator) { generators_.push_back(std::move(generator)); }

bool NumberField::concerns(const Polynomial& p) const {
  return std::ranges::any_of(generators_, [&](const Generator& g) { return p.contains(g.letter); });
}

Polynomial NumberField::reduced(Polynomial p) const {
  for (const Generator& g : generators_)
    if (p.degree(g.letter) >= g.degree()) p = joined(remainder(p.coefficients(g.letter), g), g.letter);
  return p;
}

void NumberField::settle(Polynomial& numerator, Polynomial& denominator) const {
  if (!concerns(numerator) && !concerns(denominator)) return;
  numerator = reduced(std::move(numerator));
  if (!concerns(denominator)) return;
  denominator = reduced(std::move(denominator));
  if (denominator.is_zero())
    throw Undefined("a denominator vanishes for the algebraic numbers of the integrator");
  for (const Generator& g : generators_) {
    if (!denominator.contains(g.letter)) continue;
    const std::vector<Fraction> factor = inverse(denominator, g);
    Polynomial common = 1;
    for (const Fraction& f : factor) common *= exact_quotient(f.denominator(), gcd(common, f.denominator()));
    std::vector<Polynomial> whole;
    for (const Fraction& f : factor) whole.push_back(f.numerator() * exact_quotient(common, f.denominator()));
    numerator = reduced(numerator * joined(whole, g.letter));
    denominator = common;
  }
}

}  // namespace shortfall
