// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/algebraic_root.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

/// An expression as a polynomial in one name.
class PolynomialIn {
 public:
  PolynomialIn(const std::string& name, const TokenReader& in) : name_(name), in_(in) {}

  Univariate<Rational> of(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return Univariate<Rational>({e->value});
      case Op::name:
        if (e->name != name_)
          throw in_.error(e->place, "the equation of the root '" + name_ + "' is made of numbers and '" +
                                        name_ + "'; found '" + e->name + "'");
        return Univariate<Rational>({Rational(0), Rational(1)});
      case Op::negate:
        return -of(e->operands[0]);
      case Op::add:
        return of(e->operands[0]) + of(e->operands[1]);
      case Op::subtract:
        return of(e->operands[0]) - of(e->operands[1]);
      case Op::multiply:
        return limited(e, of(e->operands[0]) * of(e->operands[1]));
      case Op::divide: {
        const Univariate<Rational> below = of(e->operands[1]);
        if (below.is_zero()) throw in_.error(e->place, "division by zero");
        if (below.degree() > 0)
          throw in_.error(e->place, "the equation of a root does not divide by the root");
        return of(e->operands[0]) * Univariate<Rational>({Rational(1) / below[0]});
      }
      case Op::power: {
        std::int64_t exponent = 0;
        if (e->operands[1]->op != Op::number || !e->operands[1]->value.fits_int64(exponent) || exponent < 0 ||
            exponent > kHighestRootDegree)
          throw in_.error(beginning(e->operands[1]),
                          "an exponent in the equation of a root is a whole number from 0 to " +
                              std::to_string(kHighestRootDegree));
        const Univariate<Rational> base = of(e->operands[0]);
        Univariate<Rational> result({Rational(1)});
        for (std::int64_t k = 0; k < exponent; ++k) result = limited(e, result * base);
        return result;
      }
      case Op::force:
      case Op::call:
      case Op::sum:
        break;
    }
    throw in_.error(e->place, "the equation of a root is a polynomial in '" + name_ + "'");
  }

 private:
  Univariate<Rational> limited(const Expr& e, Univariate<Rational> p) const {
    if (p.degree() > kHighestRootDegree)
      throw in_.error(e->place,
                      "the equation of a root has at most degree " + std::to_string(kHighestRootDegree));
    for (const Rational& c : p.coefficients())
      if (c.digits() > 1000)
        throw in_.error(e->place, "a coefficient of the equation has more than 1000 digits");
    return p;
  }

  const std::string& name_;
  const TokenReader& in_;
};

/// How far two numbers are apart, for an exact comparison of distances: r - near with its sign.
bool nearer(const RealRoot& a, const RealRoot& b, const Rational& near) {
  // |a - near| < |b - near| for a < b: the middle of the two decides.
  // (a + b)/2 > near  <=>  a is nearer. Refine until the intervals tell.
  for (Rational width(1);; width = width / 16) {
    const RealRoot p = a.refined(width), q = b.refined(width);
    if (p.low() + q.low() > near * 2) return true;
    if (p.high() + q.high() < near * 2) return false;
    if (width < Rational(1, 1'000'000'000)) return true;  // equally near, for all we can print: the smaller
  }
}

}  // namespace

std::shared_ptr<const RealRoot> chosen_root(const Root& root, const TokenReader& in) {
  const PolynomialIn side(root.name, in);
  const Univariate<Rational> p = side.of(root.left) - side.of(root.right);
  if (p.is_zero())
    throw in.error(root.place, "every number solves the equation of the root '" + root.name + "'");
  const std::vector<RealRoot> solutions = p.degree() < 1 ? std::vector<RealRoot>() : real_roots(p);
  if (solutions.empty())
    throw in.error(root.place, "the equation of the root '" + root.name + "' has no real solution");
  std::size_t best = 0;
  if (solutions.size() > 1) {
    if (!root.near) {
      std::string known;
      for (const RealRoot& s : solutions) known += (known.empty() ? "" : ", ") + s.significant(5);
      throw in.error(root.place, "the equation of the root '" + root.name + "' has " +
                                     std::to_string(solutions.size()) + " real solutions, " + known +
                                     "; say which with: near NUMBER");
    }
    for (std::size_t i = 1; i < solutions.size(); ++i)
      if (!nearer(solutions[best], solutions[i], *root.near)) best = i;
  }
  return std::make_shared<const RealRoot>(solutions[best]);
}

}  // namespace shortfall
