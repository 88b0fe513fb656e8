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

class PythonWriter {
 public:
  explicit PythonWriter(const PythonWording& wording) : wording_(wording) {}

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
      case Op::sum:
        return of_sum(e);
      default:  // a function of scalars
        return of_call(e);
    }
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
    return {"sum(" + PythonWriter(inside).of(e->operands[2]).text + " for " + wording_.name(e->name) +
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

/// Where a text may be broken: before the signs of sums, but not within short parentheses.
std::vector<std::size_t> signs(const std::string& text) {
  constexpr std::size_t kShort = 40;
  std::vector<std::size_t> open;
  std::vector<std::size_t> closing(text.size(), 0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') open.push_back(i);
    if (text[i] != ')' || open.empty()) continue;
    closing[open.back()] = i;
    open.pop_back();
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + 2 < text.size(); ++i) {
    if (text[i] == '(' && closing[i] - i < kShort) i = closing[i];
    if (text[i] == ' ' && (text[i + 1] == '+' || text[i + 1] == '-') && text[i + 2] == ' ')
      found.push_back(i);
  }
  return found;
}

}  // namespace

std::string python(const Expr& e, const PythonWording& wording) { return PythonWriter(wording).of(e).text; }

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
    case Op::sum: {
      PythonWording inside = wording;
      inside.whole.insert(e->name);
      return is_whole(e->operands[2], inside);
    }
    default:
      return false;
  }
}

std::string wrapped(int indent, const std::string& head, const std::string& text) {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  const std::vector<std::size_t> breaks = signs(text);
  if (blanks.size() + head.size() + text.size() <= kWidth || breaks.empty()) return blanks + head + text;
  std::string result = blanks + head + "(";
  const std::string next(static_cast<std::size_t>(indent) + 4, ' ');
  std::size_t column = result.size();
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= breaks.size(); ++i) {
    const std::size_t end = i < breaks.size() ? breaks[i] : text.size();
    const std::string piece = text.substr(begin, end - begin);
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

std::string wrapped_call(int indent, const std::string& head, const Expr& e, const PythonWording& wording) {
  const std::string text = python(e, wording);
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  if (e->op != Op::force || blanks.size() + head.size() + text.size() <= kWidth)
    return wrapped(indent, head, text);
  std::string result = blanks + head + "a(\n";
  for (const Expr& argument : e->operands)
    result += wrapped(indent + 4, "", python(argument, wording)) + ",\n";
  return result + blanks + ")";
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
