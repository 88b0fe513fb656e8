// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/python_expression.hpp"

#include <algorithm>
#include <vector>

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr std::size_t kWidth = 92;

/// How tightly a piece binds in Python: a sign binds more loosely than a power.
enum Binding { kSum, kProduct, kSign, kPower, kAtom };

struct Piece {
  std::string text;
  Binding binding;
};

class Writer {
 public:
  explicit Writer(const PythonWording& wording) : wording_(wording) {}

  Piece of(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return of_number(e->value);
      case Op::name:
        return {wording_.name(e->name), kAtom};
      case Op::negate:
        return {"-" + bound(e->operands[0], kProduct, true), kSign};
      case Op::add:
        return {bound(e->operands[0], kSum) + " + " + bound(e->operands[1], kProduct, true), kSum};
      case Op::subtract:
        return {bound(e->operands[0], kSum) + " - " + bound(e->operands[1], kProduct, true), kSum};
      case Op::multiply:
        return {bound(e->operands[0], kProduct) + " * " + bound(e->operands[1], kPower, true), kProduct};
      case Op::divide:
        return of_quotient(e);
      case Op::power:
        return of_power(e);
      case Op::force:
        return {"a(" + of(e->operands[0]).text + ", " + of(e->operands[1]).text + ", " +
                    of(e->operands[2]).text + ")",
                kAtom};
      case Op::call:
        return of_call(e);
      case Op::sum:
        return of_sum(e);
    }
    return {"", kAtom};
  }

 private:
  /// The operand, in parentheses when it binds more loosely than its place asks for.
  std::string bound(const Expr& e, Binding least, bool right = false) const {
    const Piece piece = of(e);
    const bool loose = piece.binding < least || (right && piece.binding == kSign);
    return loose ? "(" + piece.text + ")" : piece.text;
  }

  static Piece of_number(const Rational& value) {
    const bool negative = value.sign() < 0;
    const Rational size = value.abs();
    const std::string text =
        size.is_integer() ? size.str()
                          : "Fraction(" + size.numerator().str() + ", " + size.denominator().str() + ")";
    return negative ? Piece{"-" + text, kSign} : Piece{text, kAtom};
  }

  Piece of_quotient(const Expr& e) const {
    if (is_whole(e->operands[0], wording_) && is_whole(e->operands[1], wording_))
      return {"Fraction(" + of(e->operands[0]).text + ", " + of(e->operands[1]).text + ")", kAtom};
    return {bound(e->operands[0], kProduct) + " / " + bound(e->operands[1], kPower, true), kProduct};
  }

  Piece of_power(const Expr& e) const {
    const Piece exponent = of(e->operands[1]);
    const bool negative = exponent.binding == kSign;
    std::string base = bound(e->operands[0], kAtom);
    if (negative && is_whole(e->operands[0], wording_)) base = "Fraction(" + of(e->operands[0]).text + ")";
    return {base + "**" + (exponent.binding < kSign ? "(" + exponent.text + ")" : exponent.text), kPower};
  }

  /// Functions of a linear motion, by their names in Python's math and in mpmath alike.
  Piece of_call(const Expr& e) const {
    if (e->name == "pow") return {bound(e->operands[0], kAtom) + "**" + bound(e->operands[1], kAtom), kPower};
    std::string text;
    for (const Expr& operand : e->operands) text += (text.empty() ? "" : ", ") + of(operand).text;
    return {e->name + "(" + text + ")", kAtom};
  }

  Piece of_sum(const Expr& e) const {
    PythonWording inside = wording_;
    inside.whole.insert(e->name);
    const Expr& to = e->operands[1];
    // Python's ranges stop before their end: a sum up to n - 1 is a range up to n.
    const bool before = to->op == Op::subtract && is_number(to->operands[1], 1);
    const std::string end = before ? of(to->operands[0]).text : of(to).text + " + 1";
    const std::string begin = is_number(e->operands[0], 0) ? "" : of(e->operands[0]).text + ", ";
    return {"sum(" + Writer(inside).of(e->operands[2]).text + " for " + wording_.name(e->name) +
                " in range(" + begin + end + "))",
            kAtom};
  }

  const PythonWording& wording_;
};

/// The terms of a sum with their signs, and those of the sums that they add.
void collect(const Expr& e, bool minus, std::vector<std::pair<bool, Expr>>& terms) {
  if (e->op == Op::add || e->op == Op::subtract) {
    collect(e->operands[0], minus, terms);
    collect(e->operands[1], minus != (e->op == Op::subtract), terms);
  } else if (e->op == Op::negate) {
    collect(e->operands[0], !minus, terms);
  } else if (e->op == Op::number && e->value.sign() < 0) {
    terms.emplace_back(!minus, number(-e->value));
  } else {
    terms.emplace_back(minus, e);
  }
}

}  // namespace

std::string python(const Expr& e, const PythonWording& wording) { return Writer(wording).of(e).text; }

bool is_whole(const Expr& e, const PythonWording& wording) {
  const auto all = [&](std::size_t from) {
    return std::all_of(e->operands.begin() + static_cast<std::ptrdiff_t>(from), e->operands.end(),
                       [&](const Expr& o) { return is_whole(o, wording); });
  };
  switch (e->op) {
    case Op::number:
      return e->value.is_integer();
    case Op::name:
      return wording.whole.contains(e->name);
    case Op::negate:
    case Op::add:
    case Op::subtract:
    case Op::multiply:
      return all(0);
    case Op::power:
      return is_whole(e->operands[0], wording) && e->operands[1]->op == Op::number &&
             e->operands[1]->value.sign() >= 0;
    case Op::divide:
    case Op::force:
    case Op::call:
      return false;
    case Op::sum: {
      PythonWording inside = wording;
      inside.whole.insert(e->name);
      return is_whole(e->operands[2], inside);
    }
  }
  return false;
}

std::string wrapped(int indent, const std::string& head, const std::string& text) {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  if (blanks.size() + head.size() + text.size() <= kWidth || text.find(' ') == std::string::npos)
    return blanks + head + text;
  std::string result = blanks + head + "(";
  const std::string next(static_cast<std::size_t>(indent) + 4, ' ');
  std::size_t column = result.size();
  for (std::size_t begin = 0; begin < text.size();) {
    // A piece goes up to the next sign of a sum.
    std::size_t end = begin + 1;
    while (end < text.size() && !(text[end] == ' ' && end + 2 < text.size() && text[end + 2] == ' ' &&
                                  (text[end + 1] == '+' || text[end + 1] == '-')))
      ++end;
    std::string piece = text.substr(begin, end - begin);
    if (begin > 0 && column + piece.size() + 1 > kWidth) {
      result += "\n" + next + piece.substr(1);
      column = next.size() + piece.size() - 1;
    } else {
      result += piece;
      column += piece.size();
    }
    begin = end;
  }
  return result + ")";
}

Expr flattened(const Expr& e) {
  std::vector<std::pair<bool, Expr>> terms;
  collect(e, false, terms);
  Expr total;
  for (const auto& [minus, term] : terms) {
    Expr part = term;
    if (part->op == Op::sum)
      part = sum(part->name, part->operands[0], part->operands[1], flattened(part->operands[2]));
    if (!total)
      total = minus ? negate(part) : part;
    else
      total = binary(minus ? Op::subtract : Op::add, total, part);
  }
  return total;
}

}  // namespace shortfall
