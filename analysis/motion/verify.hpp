// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "analysis/motion/derivation.hpp"
#include "analysis/motion/formula.hpp"

namespace shortfall {

/// A number of steps at which a formula is wrong, with the simplest numbers that show it.
struct CounterExample {
  int n = 0;
  std::map<std::string, Rational> values;  ///< of h, x0, v0, the force's letters, parameters
  Rational computed;                       ///< what the integrator gives
  Rational claimed;                        ///< what the formula gives
};

/// Whether a formula for the position (or the velocity) after n steps is right for every n >= 0 and all
/// values of the letters at which it does not divide by zero.
struct Verdict {
  bool proved = false;
  std::optional<CounterExample> counter_example;  ///< the smallest n that refutes it
  std::optional<int> holds_from;                  ///< refuted, but proved for every n from this one on
  FormulaGaps gaps;    ///< where the formula itself has no value; said, not refuted
  Expr found;          ///< the right formula
  int found_from = 0;  ///< the smallest n for which it is: before, the start is felt
};

/// Proves or refutes a formula in x0, v0, a (or f0..fD), h, t = n h, n, parameters.
///
/// throws  Unable  when the formula uses something that sequences cannot carry
Verdict verdict(const Derivation& derivation, const Program& program, const Values& given,
                const Expr& claimed, bool position);

}  // namespace shortfall
