// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/algebraic_over.hpp"

#include <algorithm>
#include <tuple>

#include "analysis/algebra/sturm.hpp"

namespace shortfall {

namespace {

using Poly = Univariate<Algebraic>;

/// s and d with s a = d modulo m, d the monic common divisor of a and m.
std::pair<Poly, Poly> cofactor_and_common(const Poly& a, const Poly& m) {
  Poly r0 = m, r1 = a, s0, s1({Algebraic(1)});
  while (!r1.is_zero()) {
    auto [quotient, rest] = divided(r0, r1);
    Poly s = s0 - quotient * s1;
    s0 = std::exchange(s1, std::move(s));
    r0 = std::exchange(r1, std::move(rest));
  }
  const Poly scale({Algebraic(1) / r0.leading()});
  return {s0 * scale, r0 * scale};
}

/// The interval's middle, and how far its ends are from it and from 0.
struct Span {
  Rational middle, half, reach;
  Span(const RealRoot& r, const Rational& width) {
    const RealRoot narrow = r.refined(width);
    middle = (narrow.low() + narrow.high()) / 2;
    half = (narrow.high() - narrow.low()) / 2;
    reach = std::max(narrow.low().abs(), narrow.high().abs());
  }
};

}  // namespace

AlgebraicOver::AlgebraicOver(const Poly& p, Generator s) : generator_(std::move(s)), value_(p) { reduce(); }

void AlgebraicOver::reduce() {
  if (generator_ && value_.degree() >= generator_->modulus.degree())
    value_ = divided(value_, generator_->modulus).second;
  if (value_.degree() < 1) generator_.reset();
}

void AlgebraicOver::join(const AlgebraicOver& other) {
  if (!other.generator_) return;
  if (generator_ && generator_ != other.generator_)
    throw Error("two numbers of different number fields were combined");
  generator_ = other.generator_;
}

int AlgebraicOver::visible_sign(const Rational& width) const {
  const Span s(generator_->root, width);
  const Span r(generator_->base ? *generator_->base : RealRoot(0), width);
  // |p(r, s) - p(middles)| is at most what the derivatives by both can make of the distances.
  Rational value, by_r, by_s;
  for (int j = value_.degree(); j >= 0; --j) {
    const Univariate<Rational>& c = value_[j].polynomial();
    Rational size, slope;
    for (int k = c.degree(); k >= 0; --k) {
      slope = slope * r.reach + size;
      size = size * r.reach + c[k].abs();
    }
    value = value * s.middle + c.at(r.middle);
    by_r = by_r * s.reach + slope;
    if (j > 0) by_s = by_s * s.reach + size * j;
  }
  return value.abs() > by_r * r.half + by_s * s.half ? value.sign() : 0;
}

bool AlgebraicOver::is_zero() const {
  if (value_.is_zero()) return true;
  if (!generator_) return false;
  for (const int bits : {64, 256})
    if (visible_sign(Rational(1) / Rational(2).pow(bits)) != 0) return false;
  // Very small, or zero: it is zero where it shares the root s with the modulus.
  const Poly common = gcd(value_, generator_->modulus);
  if (common.degree() < 1) return false;
  const RealRoot& root = generator_->root;
  const bool here = root.is_rational() ? common.at(Algebraic(root.rational())).is_zero()
                                       : Sturm<Algebraic>(common).roots_between(root.low(), root.high()) == 1;
  generator_->modulus = here ? common : divided(generator_->modulus, common).first;
  return here;
}

int AlgebraicOver::sign() const {
  if (!generator_) return value_.is_zero() ? 0 : value_[0].sign();
  if (is_zero()) return 0;
  for (int bits = 64;; bits *= 2)
    if (const int sign = visible_sign(Rational(1) / Rational(2).pow(bits)); sign != 0) return sign;
}

AlgebraicOver AlgebraicOver::operator-() const {
  AlgebraicOver result = *this;
  result.value_ = -result.value_;
  return result;
}

AlgebraicOver& AlgebraicOver::operator+=(const AlgebraicOver& other) {
  join(other);
  value_ = value_ + other.value_;
  reduce();
  return *this;
}

AlgebraicOver& AlgebraicOver::operator*=(const AlgebraicOver& other) {
  join(other);
  value_ = value_ * other.value_;
  reduce();
  return *this;
}

AlgebraicOver& AlgebraicOver::operator/=(const AlgebraicOver& other) {
  if (other.is_zero()) throw Undefined("division by zero");
  if (!other.generator_) return *this *= AlgebraicOver(Algebraic(1) / other.value_[0]);
  Extension& extension = *other.generator_;
  auto [cofactor, common] = cofactor_and_common(other.value_, extension.modulus);
  while (common.degree() > 0) {
    // It is not zero at s, so that s is a root of the rest of the modulus.
    extension.modulus = divided(extension.modulus, common).first;
    std::tie(cofactor, common) =
        cofactor_and_common(divided(other.value_, extension.modulus).second, extension.modulus);
  }
  return *this *= AlgebraicOver(cofactor, other.generator_);
}

}  // namespace shortfall
