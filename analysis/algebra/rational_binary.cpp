// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {
namespace {

struct Format {
  int precision;      // bits, the leading one included
  long least_unit;    // the subnormals are the multiples of 2^least_unit
  long greatest_bit;  // finite numbers are below 2^(greatest_bit + 1)
};
constexpr Format kBinary64{53, -1074, 1023};
constexpr Format kBinary32{24, -149, 127};

/// The number of the format nearest to above / below (both positive), ties to even; as a double, which holds
/// it exactly.
double nearest(mpz_class above, mpz_class below, const Format& format) {
  const long bits_above = bit_length(above);
  const long bits_below = bit_length(below);
  // 2^(exponent - 1) < above / below < 2^(exponent + 1)
  long exponent = bits_above - bits_below;
  if (exponent > format.greatest_bit + 1) return std::numeric_limits<double>::infinity();
  if (exponent < format.least_unit - 2) return 0;
  const bool overestimated = exponent >= 0 ? above < (below << static_cast<unsigned long>(exponent))
                                           : (above << static_cast<unsigned long>(-exponent)) < below;
  if (overestimated) --exponent;
  const long unit = std::max(exponent - (format.precision - 1), format.least_unit);
  if (unit >= 0)
    below <<= static_cast<unsigned long>(unit);
  else
    above <<= static_cast<unsigned long>(-unit);
  mpz_class quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
  const int against_half = cmp(mpz_class(2 * remainder), below);
  if (against_half > 0 || (against_half == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
  const double result = std::ldexp(quotient.get_d(), static_cast<int>(unit));
  return result >= std::ldexp(1.0, static_cast<int>(format.greatest_bit) + 1)
             ? std::numeric_limits<double>::infinity()
             : result;
}

/// Both parts are floating-point numbers themselves, so that one IEEE division rounds once.
template <class Float>
bool is_exact(std::int64_t value) {
  constexpr std::int64_t kLargest = std::int64_t{1} << std::numeric_limits<Float>::digits;
  return -kLargest <= value && value <= kLargest;
}

double nearest(const Rational& value, const Format& format) {
  const double size = nearest(abs(gmp_numerator(value)), gmp_denominator(value), format);
  return value.sign() < 0 ? -size : size;
}

}  // namespace

double Rational::to_double() const {
  if (!big_ && is_exact<double>(numerator_) && is_exact<double>(denominator_))
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);
  return nearest(*this, kBinary64);
}

float Rational::to_float() const {
  if (!big_ && is_exact<float>(numerator_) && is_exact<float>(denominator_))
    return static_cast<float>(numerator_) / static_cast<float>(denominator_);
  return static_cast<float>(nearest(*this, kBinary32));
}

Rational Rational::from_double(double value) {
  if (!std::isfinite(value))
    throw BadInput("only a finite floating-point number stands for a rational number");
  int exponent = 0;
  const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  mpz_class above = gmp_integer(significand);
  mpz_class below = 1;
  (exponent > 0 ? above : below) <<= static_cast<unsigned long>(std::abs(exponent));
  return rational(std::move(above), std::move(below));
}

}  // namespace shortfall
