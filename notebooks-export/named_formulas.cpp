// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/named_formulas.hpp"

#include <algorithm>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/program/arithmetic.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;

constexpr std::size_t kLongestFactor = 8;        // of a multiple of a piece: characters
constexpr std::size_t kLongestCoefficient = 12;  // in the beginning of a piece: characters
constexpr int kCoefficientDigits = 6;            // of a coefficient that is longer
constexpr std::size_t kBeginning = 3;            // terms

/// Names that are no letters of a step: what the motion starts from, and what it is counted by.
bool is_vector(const std::string& name) {
  static const std::vector<std::string> kVectors{"x0", "v0", "x_n", "v_n", "n", "t", "x", "v", "a"};
  return std::ranges::find(kVectors, name) != kVectors.end() ||
         (name.starts_with("f") && name.find_first_not_of("0123456789'", 1) == std::string::npos);
}

/// Whether it is a rational function of letters; or of letters and vectors, by which nothing divides.
bool is_plain(const Expr& e, bool with_vectors = false) {
  const auto plain = [with_vectors](const Expr& operand) { return is_plain(operand, with_vectors); };
  switch (e->op) {
    case Op::number:
      return true;
    case Op::name:
      return !is_vector(e->name) || (with_vectors && e->name != "n" && e->name != "t");
    case Op::power: {
      const auto exponent = literal_value(e->operands[1]);
      return exponent && exponent->is_integer() && plain(e->operands[0]);
    }
    case Op::call:
      return (e->name == "sqrt" || e->name == "exp" || e->name == "pow") &&
             std::ranges::all_of(e->operands, [](const Expr& operand) { return is_plain(operand); });
    case Op::force:
    case Op::sum:
      return false;
    default:
      return std::ranges::all_of(e->operands, plain);
  }
}

std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The terms of a sum, with their signs.
void flatten(const Expr& e, bool minus, std::vector<std::pair<Expr, bool>>& terms) {
  if (e->op == Op::negate) return flatten(e->operands[0], !minus, terms);
  if (e->op == Op::add || e->op == Op::subtract) {
    flatten(e->operands[0], minus, terms);
    return flatten(e->operands[1], e->op == Op::subtract ? !minus : minus, terms);
  }
  terms.emplace_back(e, minus);
}

/// The same with every long number rounded; whether there was one.
///
/// param   decimals  gets what these become; in the expression stands a character that counts them from 1,
/// which the text is then
///                   searched for: no writer of formulas knows decimals
Expr rounded(const Expr& e, std::vector<std::string>& decimals) {
  if (e->op == Op::number && e->value.str().size() > kLongestCoefficient) {
    decimals.push_back(e->value.significant(kCoefficientDigits));
    return name(std::string(1, static_cast<char>(decimals.size())));
  }
  if (e->op == Op::divide) {
    const auto quotient = literal_value(e);
    if (quotient && quotient->str().size() > kLongestCoefficient) return rounded(number(*quotient), decimals);
  }
  if (e->operands.empty()) return e;
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = rounded(operand, decimals);
  return copy;
}

}  // namespace

NamedFormulas::NamedFormulas(Style style, bool full, const std::vector<std::string>& taken)
    : style_(style), full_(full), stem_("p") {
  const auto used = [&](const std::string& stem) {
    return std::ranges::any_of(taken, [&](const std::string& name) {
      return name.starts_with(stem) && name.find_first_not_of("0123456789", stem.size()) == std::string::npos;
    });
  };
  while (used(stem_)) stem_ += "p";
}

std::vector<std::pair<std::string, Expr>> NamedFormulas::named_values() const {
  std::vector<std::pair<std::string, Expr>> values;
  for (const Piece& p : pieces_) values.emplace_back(p.name, p.value);
  return values;
}

std::string NamedFormulas::print(const Expr& e) { return shortfall::print(full_ ? e : shortened(e), style_); }

/// As formulas have them: h first, then n, then the others.
Letter NamedFormulas::letter(const std::string& name) {
  if (const auto found = letters_.find(name); found != letters_.end()) return found->second;
  const Letter next =
      name == "h" ? kStepLetter : std::max(kStiffness, static_cast<Letter>(wording_.letters.size()));
  if (next >= kLetters) throw Unable("a formula of more than 16 letters");
  if (next >= static_cast<Letter>(wording_.letters.size()))
    wording_.letters.resize(static_cast<std::size_t>(next) + 1);
  wording_.letters[static_cast<std::size_t>(next)] = name;
  return letters_[name] = next;
}

/// A sum in which every term has one vector, as coefficients times vectors; null when it is none.
Expr NamedFormulas::gathered(const Expr& e) {
  try {
    const Fraction f = fraction(e);
    Fraction rest = f;
    Expr total = number(0);
    for (std::size_t i = 0; i < wording_.letters.size(); ++i) {
      const std::string vector = wording_.letters[i];
      const auto of = static_cast<Letter>(i);
      if (!is_vector(vector) || !f.contains(of)) continue;
      if (f.denominator().contains(of)) return nullptr;
      const Fraction coefficient(f.numerator().coefficient(of, 1), f.denominator());
      rest -= coefficient * Fraction::letter(of);
      const bool minus =
          coefficient.numerator().is_zero() || coefficient.numerator().terms().back().coefficient.sign() < 0;
      const Expr part = shortened(formula(minus ? -coefficient : coefficient, wording_)) * name(vector);
      total = is_number(total, 0) ? (minus ? negate(part) : part) : minus ? total - part : total + part;
    }
    return rest.is_zero() ? total : nullptr;
  } catch (const Unable&) {
    return nullptr;
  }
}

Fraction NamedFormulas::fraction(const Expr& e) {
  return arithmetic<Fraction>(e, [this](const Expr& leaf) -> Fraction {
    if (leaf->op == Op::number) return leaf->value;
    if (leaf->op == Op::power) {
      std::int64_t exponent = 0;
      if (const auto value = literal_value(leaf->operands[1]);
          value && value->fits_int64(exponent) && std::abs(exponent) <= 1000)
        return fraction(leaf->operands[0]).pow(static_cast<int>(exponent));
      throw Unable("a power that is no small whole number");
    }
    return Fraction::letter(letter(shortfall::print(leaf)));
  });
}

Expr NamedFormulas::named(const Expr& e) {
  try {
    Fraction f = fraction(e);
    const Rational factor = f.numerator().terms().front().coefficient;
    f /= Fraction(factor);
    for (const Piece& p : pieces_) {
      if (p.primitive != f) continue;
      const Rational ratio = factor / p.factor;
      if (ratio.str().size() <= kLongestFactor) return number(ratio) * name(p.name);
    }
    pieces_.push_back({f, factor, stem_ + std::to_string(pieces_.size() + 1), e});
    return name(pieces_.back().name);
  } catch (const Unable&) {
    return e;  // more letters than polynomials have: it stays as it is
  }
}

Expr NamedFormulas::shortened(const Expr& e) {
  if (is_plain(e)) {
    if (columns(shortfall::print(e, style_ == Style::latex ? Style::language : style_)) <= kLongestPiece)
      return e;
    // A sign in front is no part of a piece.
    if (e->op == Op::negate) return negate(named(e->operands[0]));
    return named(e);
  }
  if (e->operands.empty()) return e;
  if (is_plain(e, true) && columns(shortfall::print(e)) > kLongestPiece)
    if (Expr sum = gathered(e)) return sum;
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = shortened(operand);
  if (copy->operands == e->operands) return e;
  // A name may have brought a sign to the front.
  const std::vector<Expr>& o = copy->operands;
  switch (e->op) {
    case Op::add:
      return joined(o[0], o[1]);
    case Op::subtract:
      return o[1]->op == Op::negate ? joined(o[0], o[1]->operands[0]) : o[0] - o[1];
    case Op::multiply:
      return o[0] * o[1];
    case Op::divide:
      return o[0] / o[1];
    default:
      return copy;
  }
}

std::string NamedFormulas::description(const Piece& piece) const {
  return digest(piece.value, piece.primitive, letters_, style_);
}

std::string NamedFormulas::introduced() {
  std::string text;
  for (const auto& [name, value] : introduced_pairs()) text += "    " + name + " = " + value + "\n";
  return text;
}

std::vector<std::pair<std::string, std::string>> NamedFormulas::introduced_pairs() {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (; told_ < pieces_.size(); ++told_)
    pairs.emplace_back(shortfall::print(name(pieces_[told_].name), style_), description(pieces_[told_]));
  return pairs;
}

std::string digest(const Expr& e, const Fraction& f, const std::map<std::string, Letter>& letters,
                   Style style) {
  const auto degrees = [&](const Polynomial& p) {
    std::string text;
    for (const auto& [name, letter] : letters)
      if (p.contains(letter))
        text += (text.empty() ? "" : ", ") + std::to_string(p.degree(letter)) + " in " + name;
    return text;
  };
  const auto count = [](const Polynomial& p) {
    return std::to_string(p.terms().size()) + (p.terms().size() == 1 ? " term" : " terms");
  };
  const bool latex = style == Style::latex;
  const auto words = [&](const std::string& text) { return latex ? "\\text{" + text + "}" : text; };
  if (f.is_constant())
    return (latex ? "" : "about ") + literal_value(e).value_or(Rational()).significant(kCoefficientDigits) +
           words(" (a fraction of " + std::to_string(print(e).size()) + " characters; --full prints it)");
  if (!f.is_polynomial())
    return words("(a quotient of polynomials of " + count(f.numerator()) + " and " + count(f.denominator()) +
                 "; degree " + degrees(f.numerator()) + " over " + degrees(f.denominator()) +
                 "; --full prints it)");
  std::string text;
  std::vector<std::pair<Expr, bool>> terms;
  flatten(e, false, terms);
  std::vector<std::string> decimals;
  if (terms.size() > kBeginning) {
    Expr beginning = number(0);
    for (std::size_t i = 0; i < kBeginning; ++i) {
      const Expr term = rounded(terms[i].first, decimals);
      beginning = terms[i].second ? beginning - term : beginning + term;
    }
    for (const char c : print(beginning, style))
      text += c > 0 && c <= static_cast<char>(decimals.size()) ? decimals[static_cast<std::size_t>(c) - 1]
                                                               : std::string(1, c);
    text += (latex ? " + \\dots \\quad " : " + ... ");
  }
  return text + words("(a polynomial of " + count(f.numerator()) + ", degree " + degrees(f.numerator()) +
                      (decimals.empty() ? "" : "; rounded here") + "; --full prints it)");
}

}  // namespace shortfall
