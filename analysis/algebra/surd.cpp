// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/surd.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/algebra/decimal.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {
namespace {

/// The non-negative rational whose square is d, if there is one.
std::optional<Rational> square_root(const Rational& d) {
  mpz_class above = gmp_numerator(d);
  mpz_class below = gmp_denominator(d);
  if (!mpz_perfect_square_p(above.get_mpz_t()) || !mpz_perfect_square_p(below.get_mpz_t()))
    return std::nullopt;
  return rational(mpz_class(::sqrt(above)), mpz_class(::sqrt(below)));
}

/// q with q sqrt(d) = the number's irrational part, for another radicand d.
Rational over(const Surd& number, const Rational& d) {
  if (number.is_rational() || number.radicand() == d) return number.root_part();
  if (const auto ratio = square_root(number.radicand() / d)) return number.root_part() * *ratio;
  throw Unable("sqrt(" + number.radicand().str() + ") and sqrt(" + d.str() +
               ") are independent: we compute with one square root at a time");
}

/// |x| as a double or float; irrational numbers are never half way between two, so bounds meet at last.
template <class Round>
auto rounded(const Surd& x, Round round) {
  for (long bits = 128;; bits *= 2) {
    const Rational scale = Rational(2).pow(static_cast<int>(bits));
    const Rational below = (x * scale).floor();
    const auto low = round(below / scale);
    if (low == round((below + 1) / scale)) return low;
  }
}

Rational ten_to(long exponent) { return Rational(10).pow(static_cast<int>(exponent)); }

}  // namespace

Surd::Surd(Rational p, Rational q, Rational d) : p_(std::move(p)), q_(std::move(q)), d_(std::move(d)) {
  if (d_.sign() < 0) throw Undefined("the square root of " + d_.str() + " is not a real number");
  if (q_.is_zero() || d_.is_zero()) {
    q_ = d_ = 0;
  } else if (const auto root = square_root(d_)) {
    p_ += q_ * *root;
    q_ = d_ = 0;
  }
}

void Surd::settle() {
  if (q_.is_zero()) d_ = 0;
}

int Surd::sign() const {
  const int p = p_.sign(), q = q_.sign();
  if (p * q >= 0) return p != 0 ? p : q;
  // Opposite signs: the larger square wins; they cannot be equal, since sqrt(d) is irrational.
  return p_ * p_ > q_ * q_ * d_ ? p : q;
}

std::strong_ordering Surd::operator<=>(const Surd& other) const {
  if (is_rational() || other.is_rational() || d_ == other.d_ || square_root(other.d_ / d_))
    return (*this - other).sign() <=> 0;
  // x against y, both moved by the other's rational part: x - p' against q' sqrt(d'), by signs and then by
  // squares.
  const Surd left = *this - Surd(other.p_);
  const Surd right(0, other.q_, other.d_);
  if (left.sign() != right.sign()) return left.sign() <=> right.sign();
  const int squares = (left * left - right * right).sign();
  return squares * right.sign() <=> 0;
}

Surd Surd::operator-() const {
  Surd result;
  result.p_ = -p_;
  result.q_ = -q_;
  result.d_ = d_;
  return result;
}

Surd& Surd::operator+=(const Surd& other) {
  if (is_rational()) {
    q_ = other.q_;
    d_ = other.d_;
  } else {
    q_ += over(other, d_);
  }
  p_ += other.p_;
  settle();
  return *this;
}

Surd& Surd::operator-=(const Surd& other) { return *this += -other; }

Surd& Surd::operator*=(const Surd& other) {
  if (is_rational()) {
    const Rational factor = p_;
    *this = other;
    p_ *= factor;
    q_ *= factor;
  } else {
    const Rational q = over(other, d_);
    const Rational p = other.p_;
    const Rational sum = p_ * q + q_ * p;
    p_ = p_ * p + q_ * q * d_;
    q_ = sum;
  }
  settle();
  return *this;
}

Surd& Surd::operator/=(const Surd& other) {
  if (other.is_zero()) throw Undefined("division of " + str() + " by zero");
  const Rational norm = other.p_ * other.p_ - other.q_ * other.q_ * other.d_;
  Surd inverse;
  inverse.p_ = other.p_ / norm;
  inverse.q_ = -other.q_ / norm;
  inverse.d_ = other.d_;
  return *this *= inverse;
}

Rational Surd::floor() const {
  if (is_rational()) return p_.floor();
  // Over one denominator: (a + s sqrt(n)) / b with whole a, n and b > 0; and floor(x / b) = floor(floor(x) /
  // b).
  const mpz_class v = gmp_denominator(d_);
  const mpz_class b = lcm(gmp_denominator(p_), gmp_denominator(q_));
  const mpz_class a = gmp_numerator(p_) * (b / gmp_denominator(p_));
  const mpz_class q = gmp_numerator(q_) * (b / gmp_denominator(q_));
  mpz_class root = ::sqrt(mpz_class(q * q * gmp_numerator(d_) * v));
  if (q < 0) root = -root - 1;  // never a square, so the floor of the negative root lies one below
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), mpz_class(a * v + root).get_mpz_t(), mpz_class(b * v).get_mpz_t());
  return rational(result);
}

double Surd::to_double() const {
  if (is_rational()) return p_.to_double();
  return rounded(*this, [](const Rational& r) { return r.to_double(); });
}

float Surd::to_float() const {
  if (is_rational()) return p_.to_float();
  return rounded(*this, [](const Rational& r) { return r.to_float(); });
}

Rational Surd::approximation(int digits) const {
  check_digits(digits, 0);
  if (is_rational()) return p_;
  const Rational enough = ten_to(digits);
  for (int bits = static_cast<int>(3.33 * digits) + 8;; bits *= 2) {
    const Rational scale = Rational(2).pow(bits);
    const Rational below = (*this * scale).floor();
    if (below.abs() > enough) return below / scale;
  }
}

std::string Surd::decimal(int places) const {
  if (is_rational()) return p_.decimal(places);
  check_digits(places, 0);
  mpz_class whole = gmp_numerator((abs() * ten_to(places) + Rational(1, 2)).floor());
  if (sign() < 0) whole = -whole;
  return decimal_text(whole, places);
}

std::string Surd::significant(int digits) const {
  if (is_rational()) return p_.significant(digits);
  check_digits(digits, 1);
  const Surd size = abs();
  const Rational near = size.approximation(3);
  // 10^exponent <= |x| < 10^(exponent + 1), guessed from the number of digits and then settled exactly.
  long exponent =
      static_cast<long>(near.numerator().digits()) - static_cast<long>(near.denominator().digits()) + 1;
  while (size < ten_to(exponent)) --exponent;
  mpz_class whole = gmp_numerator((size * ten_to(digits - 1 - exponent) + Rational(1, 2)).floor());
  if (whole == power_of_ten(static_cast<unsigned long>(digits))) {
    whole /= 10;
    ++exponent;
  }
  if (sign() < 0) whole = -whole;
  return significant_text(whole, exponent);
}

std::string Surd::str() const {
  if (is_rational()) return p_.str();
  const Rational size = q_.abs();
  const std::string root = (size.is_one() ? "" : size.str() + "*") + "sqrt(" + d_.str() + ")";
  if (p_.is_zero()) return (q_.sign() < 0 ? "-" : "") + root;
  return p_.str() + (q_.sign() < 0 ? " - " : " + ") + root;
}

}  // namespace shortfall
