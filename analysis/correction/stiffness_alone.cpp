// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/stiffness_alone.hpp"

#include <algorithm>

#include "analysis/correction/kit_letters.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

/// A statement about letters says nothing about each of their values.
std::string for_letters(const OpenStep& step, const Fraction& f, const std::vector<std::string>& names) {
  const auto is_extra = [&](Letter letter) {
    return std::ranges::any_of(step.map.extras, [&](const auto& e) { return e.letter == letter; });
  };
  std::string letters;
  for (Letter letter = kFirstParameter; letter < kTrueStiffness; ++letter)
    if (f.contains(letter) && !is_extra(letter)) letters += (letters.empty() ? "" : ", ") + names[letter];
  return letters.empty() ? ""
                         : "; so with " + letters + " left open, a single value is asked for with --param";
}

/// With h = 1: y for h^2 k.
std::string print_in_scaled(const Fraction& f, std::vector<std::string> names) {
  names[kStiffness] = "y";
  return print(formula(f.substitute(kStepLetter, Fraction(1)), {names, "n", true}));
}

}  // namespace

std::string why_not_stiffness_alone(const OpenStep& step, const std::string& obstruction,
                                    const std::vector<std::string>& names) {
  const std::string text = "a stiffness alone does not exist: ";
  if (step.pair.empty())
    return text + obstruction + "; z^2 - 2 cos(w h) z + 1 divides the characteristic polynomial for no k_new";
  if (!step.pair[0].contains(kStiffness)) return text + obstruction;
  return text + "the determinant of the step is " + print_in_scaled(step.pair[0], names) +
         ", y = h^2 k_new, and has to be 1; y would be a root of a polynomial with constant coefficients, so "
         "would not depend on w h, and neither would the trace, which has to be 2 cos(w h)" +
         for_letters(step, step.pair[0], names);
}

}  // namespace shortfall
