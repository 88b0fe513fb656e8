// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// A derivation as a person reads it: the answer first, then the steps with reasons, the corrections, the
/// proofs.
std::string as_text(const Derivation& derivation, const CorrectionKit* kit, Style style);

/// " >= 1" where formulas hold from n = 1 on, since the start is felt before; empty where they always hold.
std::string from_words(const Derivation& derivation);

/// The correction kit alone.
std::string as_text(const CorrectionKit& kit, const Derivation& derivation, Style style);

/// The force as a sentence names it: "a constant acceleration".
std::string force_words(const Derivation& derivation);

/// A formula for a terminal or a file, with its quantity in front: "x(n) = x₀ + v₀ t + ½ a t²".
std::string line(const std::string& left, const Expr& right, Style style);

/// What is said of formulas whose coefficients are exact (0), or known to so many digits.
std::string exactness(int digits);

/// "3 random cases stepped in rational numbers for 6 steps: equal."
std::string sentence(const RandomCheck& check);

/// How many lines of formulas a terminal should show before the rest is left to --json or --latex.
inline constexpr int kLongestFormula = 2000;

}  // namespace shortfall
