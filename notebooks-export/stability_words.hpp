// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/print.hpp"
#include "analysis/stability/letter_formula.hpp"
#include "analysis/stability/stability.hpp"

namespace shortfall {

/// In which letters formulas about stability are written.
enum class StabilityLetters {
  products,  ///< z = h w, d = c h: for people
  factors,   ///< h^2*w^2 and h*c: as a step would write them, for programs
};

/// Of a limit of stability that has no short formula.
inline constexpr int kStabilityDigits = 50;

/// A rational function of y = h^2 w^2 and d = c h, see Amplification.
Expr stability_formula(const Fraction& f, const Amplification& a, StabilityLetters letters);

/// The characteristic polynomial in lambda, without the eigenvalue 0.
Expr characteristic_formula(const Amplification& a, StabilityLetters letters);

/// p/q in z.
Expr stability_function_formula(const StabilityFunction& r);

/// "2 √2 = 2.8284271247461900976"; a number without a short formula shows its decimals and its polynomial.
std::string exact_number(const RealRoot& r, Style style, int digits);

/// The same without the polynomial.
std::string value_words(const RealRoot& r, Style style, int digits);

/// "1/2", "≈ 0.4142135624".
std::string algebraic_text(const Algebraic& a, Style style);

/// A rational parameter: 1/4, or the decimal -0.06626458266981849 where that is shorter.
std::string parameter_text(const Rational& value);

/// "the only root of x² − 8 between 2.8 and 2.9"; for an irrational number.
std::string isolation_words(const RealRoot& r, Style style);

/// A number inside a sentence: a short formula, or eight digits.
std::string short_exact(const RealRoot& r, Style style);

/// "0 < z < 2", "z = 3", "2 ≤ z".
std::string window_text(const Window& w, const std::string& letter, Style style);

/// One sentence on what the powers do.
std::string growth_sentence(const PowerGrowth& growth, const LimitMotion* motion, Style style);

/// Why: "eigenvalue −1 twice, in one Jordan block".
std::string growth_reason(const PowerGrowth& growth, Style style);

}  // namespace shortfall
