// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/series_text.hpp"

namespace shortfall {

void SumByPowers::add(int power, const Fraction& coefficient, const std::string& thing) {
  terms_.push_back({power, coefficient, thing});
}

std::string SumByPowers::step_power(int power) const {
  if (power == 0) return "";
  return print(shortfall::power(name("h"), power), style_) + " ";
}

std::pair<bool, std::string> SumByPowers::weight(const Fraction& coefficient) const {
  const bool rational = coefficient.is_constant();
  const bool minus = rational ? coefficient.constant().sign() < 0 : source_.to_double(coefficient) < 0;
  const Fraction size = minus ? -coefficient : coefficient;
  if (size == Fraction(1)) return {minus, ""};
  if (source_.digits() > 0) return {minus, source_.decimal(size, 10) + " "};
  std::string text = print(source_.formula(size), style_);
  if (!rational) text = style_ == Style::latex ? "\\left(" + text + "\\right)" : "(" + text + ")";
  return {minus, text + " "};
}

std::string SumByPowers::str(const std::string& indent) const {
  std::string text;
  for (std::size_t i = 0; i < terms_.size();) {
    std::size_t end = i;
    while (end < terms_.size() && terms_[end].power == terms_[i].power) ++end;
    const auto [minus, first] = weight(terms_[i].coefficient);
    const std::string lead = indent.empty() ? " " : "\n" + indent;
    if (end == i + 1) {
      text += lead + (minus ? "- " : "+ ") + first + step_power(terms_[i].power) + terms_[i].thing;
    } else {
      // The sign of the first term goes to the front.
      const bool bracket = terms_[i].power > 0;
      text += lead + (minus ? "- " : "+ ") + step_power(terms_[i].power) + (bracket ? "(" : "");
      for (std::size_t j = i; j < end; ++j) {
        const auto [negative, w] = weight(terms_[j].coefficient);
        if (j > i) text += negative != (minus && bracket) ? " - " : " + ";
        text += w + terms_[j].thing;
      }
      if (bracket) text += ")";
    }
    i = end;
  }
  return text;
}

std::string exactness_note(int digits) {
  if (digits == 0) return "coefficients exact";
  return "coefficients rounded: those of the integrator are printed to " + std::to_string(digits) +
         " digits after the point";
}

}  // namespace shortfall
