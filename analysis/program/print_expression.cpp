// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>

#include "analysis/program/print.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

/// How tightly a printed piece binds: sum < product < sign < power < atom.
enum Binding { kSum, kProduct, kSign, kPower, kAtom };

constexpr int kMostPlaces = 40;  // more zeros than this are written as a power of ten

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

/// The character of a fraction, "" when it has none.
std::string vulgar_fraction(const std::string& text) {
  static const std::map<std::string, std::string> characters{
      {"1/2", "½"}, {"1/3", "⅓"}, {"2/3", "⅔"}, {"1/4", "¼"}, {"3/4", "¾"}, {"1/5", "⅕"},
      {"1/6", "⅙"}, {"5/6", "⅚"}, {"1/8", "⅛"}, {"3/8", "⅜"}, {"5/8", "⅝"}, {"7/8", "⅞"}};
  const auto found = characters.find(text);
  return found == characters.end() ? "" : found->second;
}

/// The Greek letter that a name spells, "" when it spells none.
std::string greek_letter(const std::string& name) {
  static const std::map<std::string, std::string> letters{
      {"alpha", "α"},  {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"rho", "ρ"},   {"theta", "θ"},
      {"lambda", "λ"}, {"phi", "φ"},  {"xi", "ξ"},    {"chi", "χ"},   {"omega", "ω"}, {"mu", "μ"}};
  const auto found = letters.find(name);
  return found == letters.end() ? "" : found->second;
}

class Printer {
 public:
  Printer(Style style, bool in_program) : style_(style), in_program_(in_program) {}

  Piece of(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return of_number(e->value);
      case Op::name:
        return {of_name(e->name), kAtom};
      case Op::negate:
        // -a*b is (-a)*b to the parser: the same value, so formulas go without the parentheses of -(a*b).
        return {minus() + bound(e->operands[0], in_program_ ? kPower : kProduct, true), kSign};
      case Op::add:
        return {bound(e->operands[0], kSum) + " + " + bound(e->operands[1], kProduct, true), kSum};
      case Op::subtract:
        return {bound(e->operands[0], kSum) + (style_ == Style::unicode ? " − " : " - ") +
                    bound(e->operands[1], kProduct, true),
                kSum};
      case Op::multiply: {
        const std::string right = bound(e->operands[1], kSign, true);
        return {bound(e->operands[0], kProduct) + times(right) + right, kProduct};
      }
      case Op::divide:
        return of_quotient(e);
      case Op::power:
        return of_power(e);
      case Op::force:
        return {"a" + open() + of(e->operands[0]).text + ", " + of(e->operands[1]).text + ", " +
                    of(e->operands[2]).text + close(),
                kAtom};
      case Op::call:
        return of_call(e);
      case Op::sum:
        return of_sum(e);
    }
    return {"", kAtom};
  }

 private:
  std::string minus() const { return style_ == Style::unicode ? "−" : "-"; }
  /// The sign of a product; a blank does for letters, but not before a digit.
  std::string times(const std::string& right) const {
    const bool digit = right[0] >= '0' && right[0] <= '9';
    switch (style_) {
      case Style::unicode:
        return digit ? "·" : " ";
      case Style::latex:
        return digit ? " \\cdot " : " \\, ";
      case Style::language:
        break;
    }
    return "*";
  }
  std::string open() const { return style_ == Style::latex ? "\\left(" : "("; }
  std::string close() const { return style_ == Style::latex ? "\\right)" : ")"; }

  /// The operand, in parentheses when it binds more loosely than its place asks for. To the right of an
  /// operator a sign needs them too.
  std::string bound(const Expr& e, Binding least, bool right = false) const {
    const Piece piece = of(e);
    const bool signed_right = right && piece.text.starts_with(minus());
    const bool product_right = right && least == kSign && piece.binding == kProduct;
    if (piece.binding < least || signed_right || product_right) return open() + piece.text + close();
    return piece.text;
  }

  Piece of_number(const Rational& value) const {
    const bool negative = value.sign() < 0;
    const std::string sign = negative ? minus() : "";
    const Rational size = value.abs();
    if (in_program_)
      if (const std::string decimal = exact_decimal(size); !decimal.empty())
        return {sign + decimal, negative ? kSign : kAtom};
    if (size.is_integer()) return {sign + size.str(), negative ? kSign : kAtom};
    if (style_ == Style::latex)
      return {sign + "\\frac{" + size.numerator().str() + "}{" + size.denominator().str() + "}",
              negative ? kSign : kPower};
    if (style_ == Style::unicode)
      if (const std::string vulgar = vulgar_fraction(size.str()); !vulgar.empty())
        return {sign + vulgar, negative ? kSign : kPower};
    return {sign + size.str(), negative ? kSign : kProduct};
  }

  /// The finite decimal that a positive rational is, "0.25" or "1e-400"; "" when it is none.
  static std::string exact_decimal(const Rational& value) {
    if (value.is_zero()) return "0";
    // A power of 2 or 5 that divides d is at most log2(d), and that is less than four times the digits of d.
    const int shift = value.is_integer() ? 0 : 4 * static_cast<int>(value.denominator().digits());
    const Rational whole = value * Rational(10).pow(shift);
    if (!whole.is_integer()) return "";
    std::string digits = whole.str();
    const std::size_t zeros = digits.size() - 1 - digits.find_last_not_of('0');
    const int exponent = static_cast<int>(zeros) - shift;
    if (std::abs(exponent) <= kMostPlaces) return value.decimal(std::max(0, -exponent));
    return digits.substr(0, digits.size() - zeros) + "e" + std::to_string(exponent);
  }

  /// A stem that gets an index of its own: a0 becomes a^{(0)}, so that it does not carry two indices below.
  std::string indexed_stem(const std::string& stem) const {
    const std::string plain = of_name(stem);
    const std::size_t bar = plain.find('_');
    return bar == std::string::npos
               ? plain
               : plain.substr(0, bar) + "^{(" +
                     stem.substr(stem.find_first_of("_0123456789") + (stem.find('_') != std::string::npos)) +
                     ")}";
  }

  std::string of_name(const std::string& name) const {
    if (style_ == Style::language || name.find('(') != std::string::npos) return name;  // x(t) stays as it is
    if (const std::size_t bar = name.rfind('_'); bar != std::string::npos && bar > 0) {
      // The indices of a derivation: x_n, x_k, x_{k+1}.
      std::string index = name.substr(bar + 1);
      std::erase_if(index, [](char c) { return c == '{' || c == '}'; });
      if (index == "n" || index == "k" || index == "k+1") {
        const std::string stem = name.substr(0, bar);
        if (style_ == Style::latex) return indexed_stem(stem) + "_{" + index + "}";
        return of_name(stem) + (index == "n" ? "ₙ" : index == "k" ? "ₖ" : "ₖ₊₁");
      }
    }
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
    const std::string greek = greek_letter(stem);
    if (style_ == Style::latex) {
      if (!greek.empty())
        stem = "\\" + stem;
      else if (stem.size() > 1)
        stem = "\\mathrm{" + stem + "}";
      if (index.empty()) return stem;
      const bool words = index.size() > 1 && (index[0] < '0' || index[0] > '9');
      return stem + "_{" + (words ? "\\mathrm{" + index + "}" : index) + "}";
    }
    if (!greek.empty()) stem = greek;
    const bool all_digits = index.find_first_not_of("0123456789") == std::string::npos;
    return stem + (index.empty() ? "" : all_digits ? subscript(index) : "_" + index);
  }

  Piece of_quotient(const Expr& e) const {
    if (style_ == Style::latex)
      return {"\\frac{" + of(e->operands[0]).text + "}{" + of(e->operands[1]).text + "}", kPower};
    return {bound(e->operands[0], kProduct) + "/" + bound(e->operands[1], kSign, true), kProduct};
  }

  Piece of_power(const Expr& e) const {
    const std::string base = bound(e->operands[0], kAtom);
    const std::string exponent = of(e->operands[1]).text;
    if (style_ == Style::latex) return {base + "^{" + exponent + "}", kPower};
    const Expr& raw = e->operands[1];
    const bool minus_number = raw->op == Op::negate && raw->operands[0]->op == Op::number;
    const bool whole = (minus_number ? raw->operands[0] : raw)->value.is_integer() &&
                       (minus_number || raw->op == Op::number);
    if (style_ == Style::unicode && whole)
      return {base + superscript(minus_number ? (-raw->operands[0]->value).str() : raw->value.str()), kPower};
    if (style_ == Style::unicode && exponent == "n") return {base + "ⁿ", kPower};
    const bool plain = whole || raw->op == Op::name;
    return {base + "^" + (plain ? exponent : "(" + exponent + ")"), kPower};
  }

  std::string listed(const std::vector<Expr>& operands) const {
    std::string text;
    for (const Expr& operand : operands) text += (text.empty() ? "" : ", ") + of(operand).text;
    return text;
  }

  Piece of_call(const Expr& e) const {
    const std::string& f = e->name;
    if (style_ == Style::language) return {f + "(" + listed(e->operands) + ")", kAtom};
    if (f == "pow") {
      const std::string exponent = of(e->operands[1]).text;
      const std::string base = bound(e->operands[0], kAtom);
      if (style_ == Style::latex) return {base + "^{" + exponent + "}", kPower};
      return {base + "^" + (exponent.find(' ') == std::string::npos ? exponent : "(" + exponent + ")"),
              kPower};
    }
    if (style_ == Style::unicode) {
      if (f != "sqrt") return {f + "(" + listed(e->operands) + ")", kAtom};
      const bool bare = of(e->operands[0]).binding == kAtom;
      return {"√" + (bare ? listed(e->operands) : "(" + listed(e->operands) + ")"), kPower};
    }
    if (f == "sqrt") return {"\\sqrt{" + listed(e->operands) + "}", kAtom};
    if (f == "exp") return {"e^{" + listed(e->operands) + "}", kPower};
    return {latex_function(f) + open() + listed(e->operands) + close(), kAtom};
  }

  static std::string latex_function(const std::string& f) {
    if (f == "acosh") return "\\operatorname{arcosh}";
    return f[0] == 'a' ? "\\arc" + f.substr(1) : "\\" + f;
  }

  Piece of_sum(const Expr& e) const {
    const std::string from = of(e->operands[0]).text;
    const std::string to = of(e->operands[1]).text;
    const std::string body = bound(e->operands[2], kProduct, true);
    switch (style_) {
      case Style::latex:
        return {"\\sum_{" + e->name + "=" + from + "}^{" + to + "} " + body, kPower};
      case Style::unicode:
        if (e->name == "k" && to == "n − 1" && from.find_first_not_of("0123456789") == std::string::npos)
          return {"Σₖ₌" + subscript(from) + "ⁿ⁻¹ " + body, kPower};
        return {"Σ[" + e->name + "=" + from + ".." + to + "] " + body, kPower};
      case Style::language:
        break;
    }
    return {"sum(" + e->name + ", " + from + ", " + to + ", " + of(e->operands[2]).text + ")", kAtom};
  }

  Style style_;
  bool in_program_;  ///< every operation as it stands, decimals kept
};

}  // namespace

std::string print(const Expr& e, Style style) { return Printer(style, false).of(e).text; }

std::string print_decimals(const Expr& e) { return Printer(Style::language, true).of(e).text; }

}  // namespace shortfall
