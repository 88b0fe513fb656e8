// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/traced_value.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;

/// A float of more digits than these was rounded.
constexpr int kLongestDecimal = 12;
constexpr int kLongestDecimalOfFloat = 6;

/// The fraction of a small denominator that was rounded to this float, as an author would write it.
template <class T>
std::string advice(T value) {
  for (int q = 3; q <= 1000; ++q) {
    const double p = std::round(static_cast<double>(value) * q);
    if (std::abs(p) < 1e9 && p != 0 && static_cast<T>(p / q) == value) {
      const std::string fraction = std::to_string(static_cast<long long>(p)) + ", " + std::to_string(q);
      return "write shortfall::Rational(" + fraction + "), or divide by " + std::to_string(q);
    }
  }
  return "write it as a quotient of whole numbers, shortfall::Rational(p, q), or sqrt of one";
}

template <class T>
Rational meant(T value, int longest) {
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  const std::string decimal(text.data(), end);
  if (!std::isfinite(value)) throw BadInput(decimal + " is no number that a step can use");
  int digits = 0;
  for (const char c : decimal.substr(0, decimal.find('e')))
    if (c != '-' && c != '.' && (digits > 0 || c != '0')) ++digits;
  if (digits > longest && value != std::floor(value))
    throw BadInput("the floating-point number " + decimal + " is not exact; " + advice(value));
  return Rational::parse(decimal);
}

const Expr& known(const Expr& e) {
  if (!e) throw BadInput("the step reads a value before it gives it one");
  return e;
}

}  // namespace

Rational meant_number(double value) { return meant(value, kLongestDecimal); }
Rational meant_number(float value) { return meant(value, kLongestDecimalOfFloat); }

TracedScalar::TracedScalar(const Rational& value) {
  const Rational top = value.numerator();
  Expr size = number(top.sign() < 0 ? -top : top);
  if (!value.is_integer()) size = binary(Op::divide, size, number(value.denominator()));
  e_ = value.sign() < 0 ? negate(size) : size;
}

const Expr& TracedScalar::expression() const { return known(e_); }
const Expr& TracedVector::expression() const { return known(e_); }

TracedScalar operator+(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(binary(Op::add, a.expression(), b.expression()));
}
TracedScalar operator-(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(binary(Op::subtract, a.expression(), b.expression()));
}
TracedScalar operator*(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(binary(Op::multiply, a.expression(), b.expression()));
}
TracedScalar operator/(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(binary(Op::divide, a.expression(), b.expression()));
}
TracedScalar TracedScalar::operator-() const { return TracedScalar(negate(expression())); }

TracedVector operator+(const TracedVector& a, const TracedVector& b) {
  return TracedVector(binary(Op::add, a.expression(), b.expression()));
}
TracedVector operator-(const TracedVector& a, const TracedVector& b) {
  return TracedVector(binary(Op::subtract, a.expression(), b.expression()));
}
TracedVector operator*(const TracedScalar& a, const TracedVector& b) {
  return TracedVector(binary(Op::multiply, a.expression(), b.expression()));
}
TracedVector operator*(const TracedVector& a, const TracedScalar& b) {
  return TracedVector(binary(Op::multiply, a.expression(), b.expression()));
}
TracedVector operator/(const TracedVector& a, const TracedScalar& b) {
  return TracedVector(binary(Op::divide, a.expression(), b.expression()));
}
TracedVector TracedVector::operator-() const { return TracedVector(negate(expression())); }

TracedScalar sqrt(const TracedScalar& s) { return TracedScalar(call("sqrt", {s.expression()})); }
TracedScalar exp(const TracedScalar& s) { return TracedScalar(call("exp", {s.expression()})); }
TracedScalar pow(const TracedScalar& base, int exponent) {
  if (exponent < 0) return TracedScalar(1) / pow(base, -exponent);
  return TracedScalar(binary(Op::power, base.expression(), number(exponent)));
}
TracedScalar pow(const TracedScalar& base, const TracedScalar& exponent) {
  return TracedScalar(call("pow", {base.expression(), exponent.expression()}));
}
TracedScalar max(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(call("max", {a.expression(), b.expression()}));
}
TracedScalar min(const TracedScalar& a, const TracedScalar& b) {
  return TracedScalar(call("min", {a.expression(), b.expression()}));
}

}  // namespace shortfall
