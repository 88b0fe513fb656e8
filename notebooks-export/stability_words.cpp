// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/stability_words.hpp"

#include <algorithm>

#include "analysis/algebra/general_text.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/stability/isolation.hpp"
#include "analysis/stability/radicals.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongestRadical = 48;
constexpr std::size_t kLongestPolynomial = 120;

FormulaLetters letters_of(const Amplification& a, StabilityLetters letters) {
  FormulaLetters result;
  if (letters == StabilityLetters::products)
    result.powers = {{kStiffness, "z", 2}, {kDamping, "d"}};
  else
    result.powers = {{kStepLetter, "h"}, {kStiffness, "w", 2}, {kDamping, "c"}};
  for (std::size_t i = kFirstParameter; i < a.letters.size(); ++i)
    result.parameters.push_back({static_cast<Letter>(i), a.letters[i]});
  return result;
}

std::string without_zeros_behind_point(const std::string& decimal) {
  const std::size_t exponent = std::min(decimal.find('e'), decimal.size());
  const std::string digits = decimal.substr(0, exponent);
  if (digits.find('.') == std::string::npos) return decimal;
  const std::size_t last = digits.find_last_not_of('0');
  return digits.substr(0, digits[last] == '.' ? last : last + 1) + decimal.substr(exponent);
}

std::string below(Style style, bool included) {
  return !included ? " < " : style == Style::unicode ? " ≤ " : " <= ";
}

std::string times(int n) { return n == 1 ? "once" : n == 2 ? "twice" : std::to_string(n) + " times"; }

std::string minus(Style style) { return style == Style::unicode ? "−" : "-"; }

std::string polynomial_words(const RealRoot& r, Style style) {
  const std::string text = print(polynomial_formula(r.polynomial(), "x"), style);
  return text.size() <= kLongestPolynomial
             ? text
             : "a polynomial of degree " + std::to_string(r.degree()) + " that --json shows";
}

std::string growth_words(int degree) {
  return degree == 1 ? "grows linearly" : "grows like n^" + std::to_string(degree);
}

}  // namespace

Expr stability_formula(const Fraction& f, const Amplification& a, StabilityLetters letters) {
  if (letters == StabilityLetters::products) return letter_formula(f, letters_of(a, letters));
  const Fraction h = Fraction::letter(kStepLetter);
  const Fraction written = f.substitute(kStiffness, h * h * Fraction::letter(kStiffness))
                               .substitute(kDamping, h * Fraction::letter(kDamping));
  return letter_formula(written, letters_of(a, letters));
}

Expr characteristic_formula(const Amplification& a, StabilityLetters letters) {
  Expr total = number(0);
  for (std::size_t k = a.nonzero.size(); k-- > 0;) {
    if (a.nonzero[k].is_zero()) continue;
    const Expr coefficient = stability_formula(a.nonzero[k], a, letters);
    const Expr term = k == 0 ? coefficient : coefficient * power(name("lambda"), static_cast<int>(k));
    total = total + term;
  }
  return total;
}

Expr stability_function_formula(const StabilityFunction& r) {
  FormulaLetters letters{{{kStiffness, "z"}}, {}};
  for (const AlgebraicLetter& l : r.algebraic)
    letters.parameters.push_back({l.letter, r.letters[static_cast<std::size_t>(l.letter)]});
  return letter_formula(r.formula, letters);
}

std::string algebraic_text(const Algebraic& a, Style style) {
  if (a.is_rational()) return a.rational().str();
  return (style == Style::unicode ? "≈ " : "~ ") + general_text(a.to_double(), 10);
}

std::string value_words(const RealRoot& r, Style style, int digits) {
  std::string decimal =
      r.is_rational() ? without_zeros_behind_point(r.significant(digits)) : r.significant(digits);
  const auto formula = radical_formula(r);
  if (!formula) return decimal;
  const std::string text = print(*formula, style);
  return text == decimal ? text : text.size() <= kLongestRadical ? text + " = " + decimal : decimal;
}

std::string exact_number(const RealRoot& r, Style style, int digits) {
  const std::string value = value_words(r, style, digits);
  const bool told = r.is_rational() || value.find('=') != std::string::npos;
  return told ? value : value + " (a root of " + polynomial_words(r, style) + ")";
}

std::string parameter_text(const Rational& value) {
  std::string fraction = value.str();
  for (int places = 1; places < static_cast<int>(fraction.size()); ++places) {
    std::string decimal = value.decimal(places);
    if (Rational::parse(decimal) == value) return decimal.size() < fraction.size() ? decimal : fraction;
  }
  return fraction;
}

std::string isolation_words(const RealRoot& r, Style style) {
  const Isolation between = isolation(r);
  return "the only root of " + polynomial_words(r, style) + " between " + between.low + " and " +
         between.high;
}

std::string short_exact(const RealRoot& r, Style style) {
  const auto formula = radical_formula(r);
  const std::string text = formula ? print(*formula, style) : "";
  return !text.empty() && text.size() <= 16 ? text : r.significant(8);
}

std::string window_text(const Window& w, const std::string& letter, Style style) {
  const auto edge = [&](const WindowEdge& e) { return short_exact(e.at, style); };
  if (w.is_point()) return letter + " = " + edge(*w.from);
  return (w.from ? edge(*w.from) : "0") + below(style, w.from && w.from_included) + letter +
         (w.to ? below(style, w.to_included) + edge(*w.to) : "");
}

std::string growth_sentence(const PowerGrowth& growth, const LimitMotion* motion, Style style) {
  if (growth.kind == PowerGrowth::Kind::exponential) return "grows exponentially";
  if (growth.bounded()) return growth.decays ? "decays" : "stays bounded";
  std::string grows = growth_words(growth.degree);
  if (!motion) return grows;
  const bool x = !is_number(motion->position_growth, 0), v = !is_number(motion->velocity_growth, 0);
  if (!x && !v) return "stays bounded, though other starting values of what is carried would grow";
  const std::string condition = print(x ? motion->position_growth : motion->velocity_growth, style) + " = 0";
  if (x && v) return grows + ", unless " + condition;
  return (x ? "x " : "v ") + grows + ", unless " + condition + "; " + (x ? "v" : "x") + " stays bounded";
}

std::string growth_reason(const PowerGrowth& growth, Style style) {
  std::string text;
  for (const CircleEigenvalues& e : growth.circle) {
    if (!text.empty()) text += "; ";
    const bool pair = e.kind == CircleEigenvalues::Kind::pairs;
    if (!pair)
      text += "eigenvalue " +
              (e.kind == CircleEigenvalues::Kind::plus_one ? std::string("1") : minus(style) + "1");
    else if (e.cosine)
      text += "a pair of eigenvalues on the unit circle: each step turns by arccos(" +
              print(number(*e.cosine), style) + ")";
    else
      text += std::to_string(e.count) + " eigenvalues on the unit circle";
    if (e.multiplicity > 1)
      text += (pair ? ", each " : " ") + times(e.multiplicity) +
              (e.largest_block == 1 ? ", diagonalisable"
                                    : ", in a Jordan block of size " + std::to_string(e.largest_block));
  }
  return text;
}

}  // namespace shortfall
