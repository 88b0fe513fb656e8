// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/faulhaber.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

std::vector<Rational> bernoulli_numbers(int highest) {
  std::vector<Rational> b(static_cast<std::size_t>(highest) + 1);
  b[0] = 1;
  if (highest >= 1) b[1] = Rational(-1, 2);
  // T_1, T_2, ...: tan x = sum of T_k x^(2k-1)/(2k-1)!
  const auto count = static_cast<std::size_t>(highest) / 2;
  std::vector<mpz_class> tangent(count + 1, 1);
  for (std::size_t k = 2; k <= count; ++k) tangent[k] = tangent[k - 1] * (k - 1);
  for (std::size_t k = 2; k <= count; ++k)
    for (std::size_t j = k; j <= count; ++j) {
      tangent[j] *= j - k + 2;
      mpz_addmul_ui(tangent[j].get_mpz_t(), tangent[j - 1].get_mpz_t(), j - k);
    }
  // B_2k = (-1)^(k-1) 2k T_k / (4^k (4^k - 1))
  mpz_class power = 1;
  for (std::size_t k = 1; k <= count; ++k) {
    power *= 4;
    const mpz_class above = tangent[k] * (2 * k);
    b[2 * k] = rational(k % 2 == 0 ? mpz_class(-above) : above, power * (power - 1));
  }
  return b;
}

std::vector<std::vector<Rational>> power_sums(int highest) {
  const std::vector<Rational> bernoulli = bernoulli_numbers(highest);
  std::vector<std::vector<Rational>> sums;
  sums.reserve(static_cast<std::size_t>(highest) + 1);
  for (int m = 0; m <= highest; ++m) {
    std::vector<Rational> s(m + 2);
    for (int j = 2; j <= m + 1; ++j) {
      const Rational& before = sums.back()[j - 1];
      if (before.is_zero()) continue;  // half of Bernoulli's numbers are zero
      s[j] = before.times(static_cast<unsigned>(m), static_cast<unsigned>(j));
    }
    s[1] = bernoulli[m];
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
