// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_jump.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/floating/exact_state.hpp"

namespace shortfall {

namespace {

using Coefficients = std::vector<mpz_class>;

/// p^2. A product of two different coefficients is half of (a + b)^2 - a^2 - b^2: a square is a third
/// cheaper than a product.
Coefficients squared(const Coefficients& p) {
  Coefficients result(2 * p.size() - 1), squares;
  for (std::size_t i = 0; i < p.size(); ++i) {
    squares.emplace_back(p[i] * p[i]);
    result[2 * i] += squares[i];
  }
  mpz_class sum, cross;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      sum = p[i] + p[j];
      cross = sum * sum;
      cross -= squares[i];
      cross -= squares[j];
      result[i + j] += cross;
    }
  return result;
}

/// p modulo a monic polynomial.
void reduce(Coefficients& p, const Coefficients& modulus) {
  const std::size_t degree = modulus.size() - 1;
  while (p.size() > degree) {
    const mpz_class lead = std::move(p.back());
    p.pop_back();
    for (std::size_t k = 0; k < degree; ++k)
      if (modulus[k] != 0) p[p.size() - degree + k] -= lead * modulus[k];
  }
}

/// Refuses when numbers are too long, or will be: the lengths of a power that grows exponentially double with
/// every squaring, those of others do not get so far.
class LengthCheck {
 public:
  void operator()(const Coefficients& p, int squarings_left) {
    std::int64_t length = 0;
    for (const mpz_class& c : p)
      length = std::max(length, static_cast<std::int64_t>(mpz_sizeinbase(c.get_mpz_t(), 2)));
    const bool doubles = length > kLong && length > before_ + before_ / 2;
    before_ = length;
    if (length > kLongestExactNumber ||
        (doubles && length > 2 * (kLongestExactNumber >> std::min(squarings_left, 62))))
      throw Unable("the exact state there would have more than " + std::to_string(kLongestExactNumber) +
                   " binary digits; numbers after n steps with certain digits need no such memory");
  }

 private:
  static constexpr std::int64_t kLong = 1 << 20;
  std::int64_t before_ = 0;
};

}  // namespace

Coefficients annihilator(const ExactStep& step, const std::vector<mpz_class>& z) {
  // Without common factors: the numbers of a late state are long, what annihilates it is not.
  std::vector<mpz_class> vector = z;
  std::vector<std::vector<Rational>> rows(step.size());  // columns z, M z, M^2 z, ...
  for (;;) {
    std::vector<Rational> right;
    for (const mpz_class& entry : vector) right.push_back(rational(entry));
    const auto found = solve_linear<Rational>(rows, right);
    if (found.solution) {
      Coefficients p;
      for (const Rational& c : *found.solution) p.push_back(-gmp_numerator(c));
      p.emplace_back(1);
      return p;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(right[i]);
    vector = product(step.matrix, vector);
  }
}

std::vector<mpz_class> jumped(const ExactStep& step, const std::vector<mpz_class>& z, std::int64_t steps) {
  // What annihilates the first state annihilates all that come after it.
  const Coefficients modulus = annihilator(step, step.start);
  std::vector<mpz_class> result(z.size()), moved = z;
  if (modulus.size() == 1) return result;  // it is zero, and stays so
  LengthCheck check_length;
  Coefficients power{1};
  for (int bit = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(steps))) - 1; bit >= 0; --bit) {
    power = squared(power);
    if (steps >> bit & 1) power.emplace(power.begin(), 0);
    reduce(power, modulus);
    check_length(power, bit);
  }
  for (std::size_t k = 0; k < power.size(); ++k) {
    if (k > 0) moved = product(step.matrix, moved);
    for (std::size_t i = 0; i < z.size(); ++i) result[i] += power[k] * moved[i];
  }
  return result;
}

}  // namespace shortfall
