// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/faulhaber.hpp"

#include "analysis/algebra/error.hpp"

namespace shortfall {

std::vector<std::vector<Rational>> power_sums(int highest) {
  std::vector<std::vector<Rational>> sums;
  for (int m = 0; m <= highest; ++m) {
    std::vector<Rational> s(m + 2);
    if (m == 0) {
      s[1] = 1;
    } else {
      const std::vector<Rational>& before = sums.back();
      Rational rest;  // S_m(1) = 0 for m >= 1
      for (int j = 2; j <= m + 1; ++j) {
        if (before[j - 1].is_zero()) continue;  // half of Bernoulli's numbers are zero
        s[j] = before[j - 1] * Rational(m, j);
        rest -= s[j];
      }
      s[1] = rest;
    }
    sums.push_back(std::move(s));
  }
  return sums;
}

Fraction indefinite_sum(const Fraction& p, Letter n) {
  if (p.denominator().contains(n))
    throw Undefined("a sum over n of a function with n in its denominator has no polynomial closed form");
  const std::vector<Polynomial> coefficients = p.numerator().coefficients(n);
  const auto sums = power_sums(static_cast<int>(coefficients.size()) - 1);
  Polynomial total;
  for (std::size_t m = 0; m < coefficients.size(); ++m)
    if (!coefficients[m].is_zero()) total += coefficients[m] * Polynomial::in(n, sums[m]);
  return p.denominator().is_constant() ? Fraction(std::move(total))
                                       : Fraction(std::move(total), p.denominator());
}

}  // namespace shortfall
