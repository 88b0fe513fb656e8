// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A place in a text: line and column from 1; 0 means nowhere.
struct Place {
  int line = 0;
  int column = 0;
};

struct Expression;
/// Expressions are immutable and shared.
using Expr = std::shared_ptr<const Expression>;

/// An expression of the .integrator language; formulas shown to users are the same thing.
struct Expression {
  enum class Op {
    number,    ///< value
    name,      ///< name
    negate,    ///< - operands[0]
    add,       ///< operands[0] + operands[1]
    subtract,  ///< operands[0] - operands[1]
    multiply,  ///< operands[0] * operands[1]
    divide,    ///< operands[0] / operands[1]
    power,     ///< operands[0] ^ operands[1]
    force,     ///< a(operands[0], operands[1], operands[2])
    call,      ///< name(operands...), a function of scalars: sqrt, exp, ...; see function.hpp
    sum,       ///< sum of operands[2] for name = operands[0] .. operands[1]; in derivations only
  };

  Op op = Op::number;
  Rational value;
  std::string name;
  std::vector<Expr> operands;
  Place place;
};

Expr number(Rational value, Place place = {});
Expr name(std::string name, Place place = {});
Expr negate(Expr a, Place place = {});
Expr binary(Expression::Op op, Expr a, Expr b, Place place = {});
Expr force(Expr x, Expr v, Expr t, Place place = {});
/// function(arguments), such as call("exp", {e}).
Expr call(std::string function, std::vector<Expr> arguments, Place place = {});
/// sum of body for index = from .. to
Expr sum(std::string index, Expr from, Expr to, Expr body);

/// These tidy as they build: 0 and 1 vanish, a minus sign comes to the front. For formulas, never for a
/// step's arithmetic.
Expr operator+(Expr a, Expr b);
Expr operator-(Expr a, Expr b);
Expr operator*(Expr a, Expr b);
Expr operator/(Expr a, Expr b);
Expr power(Expr a, int exponent);

bool is_number(const Expr& e, const Rational& value);
/// The value of an expression that is made of numbers, + - * / and whole powers only.
std::optional<Rational> literal_value(const Expr& e);
bool same(const Expr& a, const Expr& b);
/// The expression with every name `from` replaced.
Expr replace(const Expr& e, const std::string& from, const Expr& to);
/// The place of its first value: an expression's own place is that of its operator.
Place beginning(const Expr& e);
/// Whether a name occurs in it.
bool mentions(const Expr& e, const std::string& name);

}  // namespace shortfall
