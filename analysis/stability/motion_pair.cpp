// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/motion_pair.hpp"

namespace shortfall {

namespace {

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

}  // namespace

MotionPair motion_pair(const std::vector<Fraction>& characteristic,
                       const std::function<bool(const Polynomial&)>& belongs_to_motion) {
  MotionPair result;
  while (characteristic[static_cast<std::size_t>(result.zeros)].is_zero()) ++result.zeros;
  result.nonzero.assign(characteristic.begin() + result.zeros, characteristic.end());
  if (result.nonzero.size() == 3) {
    result.pair = result.nonzero;
    return result;
  }
  Polynomial motion = 1, others = 1;
  for (const auto& [factor, multiplicity] : factor(cleared(result.nonzero)).factors) {
    if (factor.degree(kEigenvalue) < 1) continue;
    Polynomial& product = belongs_to_motion(factor) ? motion : others;
    product = product * factor.pow(multiplicity);
  }
  if (motion.degree(kEigenvalue) != 2) return result;
  result.pair = monic(motion);
  result.spurious = monic(others);
  return result;
}

}  // namespace shortfall
