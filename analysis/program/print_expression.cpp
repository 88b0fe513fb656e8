// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "analysis/program/print.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

/// How tightly a printed piece binds: sum < product < sign < power < atom.
enum Binding { kSum, kProduct, kSign, kPower, kAtom };

struct Piece {
  std::string text;
  Binding binding;
};

std::string in_characters(std::string_view digits, const std::array<std::string_view, 11>& characters) {
  std::string text;
  for (char c : digits) text += characters[c == '-' ? 10 : c - '0'];
  return text;
}

std::string superscript(std::string_view digits) {
  return in_characters(digits, {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻"});
}

std::string subscript(std::string_view digits) {
  return in_characters(digits, {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉", "₋"});
}

const std::map<std::string, std::string> kVulgar{{"1/2", "½"}, {"1/3", "⅓"}, {"2/3", "⅔"}, {"1/4", "¼"},
                                                 {"3/4", "¾"}, {"1/5", "⅕"}, {"1/6", "⅙"}, {"5/6", "⅚"},
                                                 {"1/8", "⅛"}, {"3/8", "⅜"}, {"5/8", "⅝"}, {"7/8", "⅞"}};

const std::map<std::string, std::string> kGreek{
    {"alpha", "α"},  {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"rho", "ρ"}, {"theta", "θ"},
    {"lambda", "λ"}, {"xi", "ξ"},   {"chi", "χ"},   {"omega", "ω"}, {"mu", "μ"}};

class Printer {
 public:
  Printer(Style style, bool decimals) : style_(style), decimals_(decimals) {}

  Piece of(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return of_number(e->value);
      case Op::name:
        return {of_name(e->name), kAtom};
      case Op::negate:
        return {minus() + bound(e->operands[0], kProduct, true), kSign};
      case Op::add:
        return {bound(e->operands[0], kSum) + " + " + bound(e->operands[1], kProduct, true), kSum};
      case Op::subtract:
        return {bound(e->operands[0], kSum) + (style_ == Style::unicode ? " − " : " - ") +
                    bound(e->operands[1], kProduct, true),
                kSum};
      case Op::multiply:
        return {bound(e->operands[0], kProduct) + times() + bound(e->operands[1], kSign, true), kProduct};
      case Op::divide:
        return of_quotient(e);
      case Op::power:
        return of_power(e);
      case Op::force:
        return {"a" + open() + of(e->operands[0]).text + ", " + of(e->operands[1]).text + ", " +
                    of(e->operands[2]).text + close(),
                kAtom};
      case Op::sum:
        return of_sum(e);
    }
    return {"", kAtom};
  }

 private:
  std::string minus() const { return style_ == Style::unicode ? "−" : "-"; }
  std::string times() const {
    return style_ == Style::unicode ? " " : style_ == Style::latex ? " \\, " : "*";
  }
  std::string open() const { return style_ == Style::latex ? "\\left(" : "("; }
  std::string close() const { return style_ == Style::latex ? "\\right)" : ")"; }

  /// The operand, in parentheses when it binds more loosely than its place asks for. To the right of an
  /// operator a sign needs them too.
  std::string bound(const Expr& e, Binding least, bool right = false) const {
    const Piece piece = of(e);
    const bool signed_right = right && piece.binding == kSign;
    const bool product_right = right && least == kSign && piece.binding == kProduct;
    if (piece.binding < least || signed_right || product_right) return open() + piece.text + close();
    return piece.text;
  }

  Piece of_number(const Rational& value) const {
    const std::string sign = value.sign() < 0 ? minus() : "";
    const Rational size = value.abs();
    const Binding binding = value.sign() < 0 ? kSign : size.is_integer() ? kAtom : kProduct;
    if (size.is_integer()) return {sign + size.str(), binding};
    if (style_ == Style::latex)
      return {sign + "\\frac{" + size.numerator().str() + "}{" + size.denominator().str() + "}",
              value.sign() < 0 ? kSign : kAtom};
    if (style_ == Style::unicode) {
      const auto vulgar = kVulgar.find(size.str());
      if (vulgar != kVulgar.end()) return {sign + vulgar->second, value.sign() < 0 ? kSign : kAtom};
    }
    // A decimal of a program stays one: 0.1 must not come back as the division 1/10, which may round
    // differently.
    if (const std::string decimal = exact_decimal(size); decimals_ && !decimal.empty())
      return {sign + decimal, value.sign() < 0 ? kSign : kAtom};
    return {sign + size.str(), binding};
  }

  /// The finite decimal a rational is, or "" when it is none.
  static std::string exact_decimal(const Rational& value) {
    Rational scaled = value;
    for (int places = 0; places <= 400; ++places, scaled *= 10)
      if (scaled.is_integer()) return value.decimal(places);
    return "";
  }

  std::string of_name(const std::string& name) const {
    if (style_ == Style::language) return name;
    std::size_t digits = name.size();
    while (digits > 0 && name[digits - 1] >= '0' && name[digits - 1] <= '9') --digits;
    std::string stem = name.substr(0, digits);
    std::string index = name.substr(digits);
    if (const std::size_t bar = stem.find('_');
        bar != std::string::npos && bar + 1 < stem.size() && bar > 0) {
      index = stem.substr(bar + 1) + index;
      stem = stem.substr(0, bar);
    } else if (stem.ends_with('_')) {
      stem.pop_back();
    }
    const auto greek = kGreek.find(stem);
    if (style_ == Style::latex) {
      if (greek != kGreek.end())
        stem = "\\" + stem;
      else if (stem.size() > 1)
        stem = "\\mathrm{" + stem + "}";
      if (index.empty()) return stem;
      const bool words = index.size() > 1 && (index[0] < '0' || index[0] > '9');
      return stem + "_{" + (words ? "\\mathrm{" + index + "}" : index) + "}";
    }
    if (greek != kGreek.end()) stem = greek->second;
    const bool all_digits = index.find_first_not_of("0123456789") == std::string::npos;
    return stem + (index.empty() ? "" : all_digits ? subscript(index) : "_" + index);
  }

  Piece of_quotient(const Expr& e) const {
    if (style_ == Style::latex)
      return {"\\frac{" + of(e->operands[0]).text + "}{" + of(e->operands[1]).text + "}", kAtom};
    return {bound(e->operands[0], kProduct) + "/" + bound(e->operands[1], kSign, true), kProduct};
  }

  Piece of_power(const Expr& e) const {
    const std::string base = bound(e->operands[0], kAtom);
    const std::string exponent = of(e->operands[1]).text;
    if (style_ == Style::latex) return {base + "^{" + exponent + "}", kPower};
    const Expr& raw = e->operands[1];
    if (style_ == Style::unicode && raw->op == Op::number && raw->value.is_integer())
      return {base + superscript(raw->value.str()), kPower};
    if (style_ == Style::unicode && exponent == "n") return {base + "ⁿ", kPower};
    const bool plain = raw->op == Op::name || (raw->op == Op::number && raw->value.is_integer()) ||
                       (raw->op == Op::negate && raw->operands[0]->op == Op::number);
    return {base + "^" + (plain ? exponent : "(" + exponent + ")"), kPower};
  }

  Piece of_sum(const Expr& e) const {
    const std::string from = of(e->operands[0]).text;
    const std::string to = of(e->operands[1]).text;
    const std::string body = bound(e->operands[2], kProduct, true);
    switch (style_) {
      case Style::latex:
        return {"\\sum_{" + e->name + "=" + from + "}^{" + to + "} " + body, kProduct};
      case Style::unicode:
        return {"Σ[" + e->name + "=" + from + ".." + to + "] " + body, kProduct};
      case Style::language:
        break;
    }
    return {"sum(" + e->name + ", " + from + ", " + to + ", " + of(e->operands[2]).text + ")", kAtom};
  }

  Style style_;
  bool decimals_;
};

}  // namespace

std::string print(const Expr& e, Style style) { return Printer(style, false).of(e).text; }

std::string print_decimals(const Expr& e) { return Printer(Style::language, true).of(e).text; }

}  // namespace shortfall
