// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_numbers.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/surd.hpp"

namespace shortfall {

namespace {

void check_not_negative(int sign) {
  if (sign < 0) throw Undefined("a coefficient is the square root of a negative number");
}

Rational discriminant(const RealRoot& quadratic) {
  const auto& p = quadratic.polynomial();
  return p[1] * p[1] - Rational(4) * p[2] * p[0];
}

}  // namespace

Rational SplittingNumbers<Rational>::root(const RealRoot& root) const {
  if (!root.is_rational()) throw FieldTooSmall{root};
  return root.rational();
}

Rational SplittingNumbers<Rational>::square_root(const Rational& value) const {
  check_not_negative(value.sign());
  const Surd root = Surd::sqrt(value);
  if (!root.is_rational()) throw FieldTooSmall{shortfall::square_root(RealRoot(value))};
  return root.rational_part();
}

Algebraic SplittingNumbers<Algebraic>::root(const RealRoot& root) const {
  if (root.is_rational()) return root.rational();
  if (root.degree() == generator->degree() && root == *generator)
    return Algebraic(Univariate<Rational>({Rational(0), Rational(1)}), generator);
  if (root.degree() != 2) throw FieldTooSmall{};
  // (-p1 +- sqrt(D)) / (2 p2); the right one lies in the root's interval.
  const auto& p = root.polynomial();
  const Algebraic half(Rational(1) / (Rational(2) * p[2])), middle = Algebraic(-p[1]) * half;
  const Algebraic reach = square_root(Algebraic(discriminant(root))) * half;
  const Algebraic upper = middle + reach;
  return Algebraic(root.low()) < upper && upper < Algebraic(root.high()) ? upper : middle - reach;
}

Algebraic SplittingNumbers<Algebraic>::square_root(const Algebraic& value) const {
  check_not_negative(value.sign());
  if (!value.is_rational()) throw FieldTooSmall{};
  const Surd root = Surd::sqrt(value.rational());
  if (root.is_rational()) return root.rational_part();
  if (generator->degree() != 2) throw FieldTooSmall{};
  // 2 p2 r + p1 is a square root of the generator's discriminant.
  const Surd ratio = Surd::sqrt(value.rational() / discriminant(*generator));
  if (!ratio.is_rational()) throw FieldTooSmall{};
  const auto& p = generator->polynomial();
  const Algebraic own(Univariate<Rational>({p[1], Rational(2) * p[2]}), generator);
  return Algebraic(ratio.rational_part()) * own.abs();
}

KnownDigits SplittingNumbers<KnownDigits>::root(const RealRoot& root) const {
  return KnownDigits(ball(root, KnownDigits::kBits));
}

KnownDigits SplittingNumbers<KnownDigits>::square_root(const KnownDigits& value) const {
  if (value.ball().sign() == -1) check_not_negative(-1);
  return KnownDigits(sqrt(value.ball()));
}

}  // namespace shortfall
