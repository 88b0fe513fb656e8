// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/code_writer.hpp"

#include <cstdint>
#include <cstdlib>

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

CodeWriter::Piece CodeWriter::of(const Expr& e) const {
  using Op = Expression::Op;
  switch (e->op) {
    case Op::number:
      return of_signed(e->value);
    case Op::name:
      return {of_name(e->name), kAtom};
    case Op::negate:
      return of_negative(e->operands[0]);
    case Op::add:
      return {bound(e->operands[0], kSum) + " + " + bound(e->operands[1], kProduct), kSum};
    case Op::subtract:
      return {bound(e->operands[0], kSum) + " - " + bound(e->operands[1], kProduct), kSum};
    case Op::multiply:
      return {bound(e->operands[0], kProduct) + " * " + bound(e->operands[1], kSign), kProduct};
    case Op::divide:
      return {bound(e->operands[0], kProduct) + " / " + bound(e->operands[1], kSign), kProduct};
    case Op::power:
      return of_power(e);
    case Op::call:
      if (const std::string f = function(e->name); !f.empty()) return of_call(f, e);
      break;
    case Op::force:
    case Op::sum:
      break;
  }
  throw Unable("'" + print(e) + "' is no formula of scalars: we cannot write it in " + title());
}

std::string CodeWriter::bound(const Expr& e, Binding least) const {
  const Piece piece = of(e);
  return piece.binding < least ? "(" + piece.text + ")" : piece.text;
}

CodeWriter::Piece CodeWriter::of_call(const std::string& function, const Expr& e) const {
  std::string arguments;
  for (const Expr& operand : e->operands) arguments += (arguments.empty() ? "" : ", ") + of(operand).text;
  return {function + "(" + arguments + ")", function.starts_with("(") ? kSign : kAtom};
}

/// The sign goes to the first factor, which is the same number.
CodeWriter::Piece CodeWriter::of_negative(const Expr& e) const {
  const Piece piece = of(e);
  if (piece.binding < kProduct || piece.text.starts_with("-")) return {"-(" + piece.text + ")", kSign};
  return {"-" + piece.text, piece.binding == kProduct ? kProduct : kSign};
}

CodeWriter::Piece CodeWriter::of_signed(const Rational& value) const {
  if (value.sign() >= 0) return of_number(value);
  const Piece size = of_number(-value);
  return {"-" + size.text, size.binding == kProduct ? kProduct : kSign};
}

/// x x x from the left, as a step that shortfall runs multiplies; a function where the exponent is no number.
CodeWriter::Piece CodeWriter::of_power(const Expr& e) const {
  constexpr std::int64_t kLargest = 32;
  const Expr& raw = e->operands[1];
  const bool negated = raw->op == Expression::Op::negate;
  const Expr& size = negated ? raw->operands[0] : raw;
  if (size->op != Expression::Op::number) {
    if (const std::string f = function("pow"); !f.empty()) return of_call(f, e);
    throw Unable("'" + print(e) + "' is no power that can be written in " + title());
  }
  const Rational exponent = negated ? -size->value : size->value;
  std::int64_t count = 0;
  if (!exponent.fits_int64(count) || std::abs(count) > kLargest)
    throw Unable("the power '" + print(e) + "' is written as a product only up to " +
                 std::to_string(kLargest));
  if (count == 0) return of_number(1);
  const std::string base = bound(e->operands[0], kAtom);
  std::string text = base;
  for (std::int64_t k = 1; k < std::abs(count); ++k) text += " * " + base;
  const bool single = std::abs(count) == 1;
  if (count > 0) return {text, single ? kAtom : kProduct};
  return {of_number(1).text + " / " + (single ? text : "(" + text + ")"), kProduct};
}

}  // namespace shortfall
