// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/expression.hpp"

#include <algorithm>
#include <cstdlib>

namespace shortfall {

using Op = Expression::Op;

namespace {

Expr make(Op op, std::vector<Expr> operands, Place place) {
  return std::make_shared<const Expression>(Expression{op, {}, {}, std::move(operands), place});
}

}  // namespace

Expr number(Rational value, Place place) {
  return std::make_shared<const Expression>(Expression{Op::number, std::move(value), {}, {}, place});
}
Expr name(std::string name, Place place) {
  return std::make_shared<const Expression>(Expression{Op::name, {}, std::move(name), {}, place});
}
Expr negate(Expr a, Place place) { return make(Op::negate, {std::move(a)}, place); }
Expr binary(Op op, Expr a, Expr b, Place place) { return make(op, {std::move(a), std::move(b)}, place); }
Expr force(Expr x, Expr v, Expr t, Place place) {
  return make(Op::force, {std::move(x), std::move(v), std::move(t)}, place);
}
Expr call(std::string function, std::vector<Expr> arguments, Place place) {
  return std::make_shared<const Expression>(
      Expression{Op::call, {}, std::move(function), std::move(arguments), place});
}
Expr sum(std::string index, Expr from, Expr to, Expr body) {
  return std::make_shared<const Expression>(
      Expression{Op::sum, {}, std::move(index), {std::move(from), std::move(to), std::move(body)}, {}});
}

std::optional<Rational> literal_value(const Expr& e) {
  if (e->op == Op::number) return e->value;
  if (e->op == Op::name || e->op == Op::force || e->op == Op::call || e->op == Op::sum) return {};
  const auto left = literal_value(e->operands[0]);
  if (!left || e->op == Op::negate) return left ? std::optional(-*left) : left;
  const auto right = literal_value(e->operands[1]);
  if (!right) return {};
  switch (e->op) {
    case Op::add:
      return *left + *right;
    case Op::subtract:
      return *left - *right;
    case Op::multiply:
      return *left * *right;
    case Op::divide:
      return right->is_zero() ? std::nullopt : std::optional(*left / *right);
    default: {
      std::int64_t exponent = 0;
      if (!right->fits_int64(exponent) || std::abs(exponent) > 1000 || (left->is_zero() && exponent < 0))
        return {};
      return left->pow(static_cast<int>(exponent));
    }
  }
}

bool is_number(const Expr& e, const Rational& value) { return e->op == Op::number && e->value == value; }

Expr operator+(Expr a, Expr b) {
  if (is_number(a, 0)) return b;
  if (is_number(b, 0)) return a;
  if (b->op == Op::negate) return binary(Op::subtract, std::move(a), b->operands[0]);
  if (b->op == Op::number && b->value.sign() < 0)
    return binary(Op::subtract, std::move(a), number(-b->value));
  return binary(Op::add, std::move(a), std::move(b));
}

Expr operator-(Expr a, Expr b) {
  if (is_number(b, 0)) return a;
  if (b->op == Op::negate) return std::move(a) + b->operands[0];
  if (is_number(a, 0)) return negate(std::move(b));
  return binary(Op::subtract, std::move(a), std::move(b));
}

Expr operator*(Expr a, Expr b) {
  if (is_number(a, 0) || is_number(b, 0)) return number(0);
  if (is_number(a, 1)) return b;
  if (is_number(b, 1)) return a;
  if (is_number(a, -1)) return negate(std::move(b));
  if (a->op == Op::negate) return negate(a->operands[0] * std::move(b));
  if (b->op == Op::negate) return negate(std::move(a) * b->operands[0]);
  return binary(Op::multiply, std::move(a), std::move(b));
}

Expr operator/(Expr a, Expr b) {
  if (is_number(b, 1) || is_number(a, 0)) return a;
  if (a->op == Op::negate) return negate(a->operands[0] / std::move(b));
  return binary(Op::divide, std::move(a), std::move(b));
}

Expr power(Expr a, int exponent) {
  if (exponent == 0) return number(1);
  if (exponent == 1) return a;
  return binary(Op::power, std::move(a), number(exponent));
}

bool same(const Expr& a, const Expr& b) {
  if (a == b) return true;
  return a->op == b->op && a->value == b->value && a->name == b->name &&
         std::ranges::equal(a->operands, b->operands,
                            [](const Expr& p, const Expr& q) { return same(p, q); });
}

Expr replace(const Expr& e, const std::string& from, const Expr& to) {
  if (e->op == Op::name) return e->name == from ? to : e;
  if (e->operands.empty() || (e->op == Op::sum && e->name == from)) return e;
  Expression copy = *e;
  for (Expr& operand : copy.operands) operand = replace(operand, from, to);
  return std::make_shared<const Expression>(std::move(copy));
}

Place beginning(const Expr& e) {
  const bool inside = e->op != Op::force && e->op != Op::call && e->op != Op::negate && !e->operands.empty();
  return inside ? beginning(e->operands[0]) : e->place;
}

bool mentions(const Expr& e, const std::string& name) {
  if (e->op == Op::name && e->name == name) return true;
  return std::ranges::any_of(e->operands, [&](const Expr& o) { return mentions(o, name); });
}

}  // namespace shortfall
