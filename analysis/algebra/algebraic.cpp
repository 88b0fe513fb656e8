// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/algebraic.hpp"

#include <algorithm>

namespace shortfall {

namespace {

/// s with s a = 1 modulo m, for a irreducible m and an a that it does not divide: Euclid's algorithm.
Univariate<Rational> inverse(const Univariate<Rational>& a, const Univariate<Rational>& m) {
  Univariate<Rational> r0 = m, r1 = a, s0, s1({Rational(1)});
  while (r1.degree() > 0) {
    auto [quotient, rest] = divided(r0, r1);
    Univariate<Rational> s = s0 - quotient * s1;
    s0 = std::exchange(s1, std::move(s));
    r0 = std::exchange(r1, std::move(rest));
  }
  return s1 * Univariate<Rational>({Rational(1) / r1[0]});
}

/// How far p can be from p(middle) on an interval of this width that reaches no farther than `reach` from 0.
Rational spread(const Univariate<Rational>& p, const Rational& reach, const Rational& width) {
  Rational slope;
  for (int k = p.degree(); k >= 1; --k) slope = slope * reach + Rational(k) * p[k].abs();
  return slope * width / 2;
}

}  // namespace

Algebraic::Algebraic(const Univariate<Rational>& p, Generator r) : generator_(std::move(r)), value_(p) {
  reduce();
}

void Algebraic::reduce() {
  if (generator_ && value_.degree() >= generator_->degree())
    value_ = divided(value_, generator_->polynomial()).second;
  if (value_.degree() < 1) generator_.reset();
}

void Algebraic::join(const Algebraic& other) {
  if (!other.generator_) return;
  if (generator_ && generator_ != other.generator_)
    throw Error("two numbers of different number fields were combined");
  generator_ = other.generator_;
}

int Algebraic::sign() const {
  if (is_rational()) return rational().sign();
  for (RealRoot narrow = *generator_;; narrow = narrow.refined((narrow.high() - narrow.low()) / 65536)) {
    const Rational reach = std::max(narrow.low().abs(), narrow.high().abs());
    const Rational middle = value_.at((narrow.low() + narrow.high()) / 2);
    if (middle.abs() > spread(value_, reach, narrow.high() - narrow.low())) return middle.sign();
  }
}

double Algebraic::to_double() const {
  if (is_rational()) return rational().to_double();
  for (RealRoot narrow = *generator_;; narrow = narrow.refined((narrow.high() - narrow.low()) / 65536)) {
    const Rational reach = std::max(narrow.low().abs(), narrow.high().abs());
    const Rational middle = value_.at((narrow.low() + narrow.high()) / 2);
    if (middle.abs() > spread(value_, reach, narrow.high() - narrow.low()) * Rational(2).pow(54))
      return middle.to_double();
  }
}

Algebraic Algebraic::operator-() const {
  Algebraic result = *this;
  result.value_ = -result.value_;
  return result;
}

Algebraic& Algebraic::operator+=(const Algebraic& other) {
  join(other);
  value_ = value_ + other.value_;
  reduce();
  return *this;
}

Algebraic& Algebraic::operator-=(const Algebraic& other) { return *this += -other; }

Algebraic& Algebraic::operator*=(const Algebraic& other) {
  join(other);
  value_ = value_ * other.value_;
  reduce();
  return *this;
}

Algebraic& Algebraic::operator/=(const Algebraic& other) {
  if (other.is_zero()) throw Undefined("division by zero");
  Algebraic factor = other;
  if (other.generator_)
    factor.value_ = inverse(other.value_, other.generator_->polynomial());
  else
    factor = Algebraic(Rational(1) / other.rational());
  return *this *= factor;
}

}  // namespace shortfall
