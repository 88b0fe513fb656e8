// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What budgets of different quantities have in common.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/surd.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/motion/numeric_motion.hpp"

namespace shortfall {

inline constexpr int kBudgetDigits = 60;  ///< of every exact answer, at least
inline constexpr int kMostBudgetDigits = 4000;
/// The digits of a budget's exact answers at first: enough to show what a format rounds off.
int first_digits(const FloatFormat& format);
/// Steps between two calls of progress: about a millisecond or less.
std::int64_t report_steps(const FloatFormat& format);

/// The precision that so many digits are computed in.
inline int bits_for(int digits) { return digits * 4 + 64; }

/// What exact answers are asked for; the question's own numbers are those that are meant.
NumericQuestion exact_question(const FloatQuestion& q, std::int64_t steps, int digits);
Ball ball_of(const CertainNumber& n, int bits);
Ball ball_of(const Surd& s, int bits);

/// observed = again - computed, where both come from computations of their own; the residual is what is left
/// without the terms.
BudgetLine budget_line(const std::string& quantity, const std::string& unit, const FloatNumber& computed,
                       const Ball& truth, const Ball& again, std::vector<BudgetTerm> terms, int bits);

void put_first_difference(Budget& b);

/// How a term of the first line is found for another question.
struct RemedyParts {
  std::function<Ball(const FloatQuestion& half)> method;  ///< with half the step
  std::function<Ball(const FloatQuestion& kept)> representation;
  std::function<std::optional<Ball>(const FloatFormat&)> rounding;  ///< none when that run is not finite
  /// With half the step, or with what the text says.
  std::function<std::pair<std::string, Ball>(const FloatQuestion& half)> sampling{};
};
/// For each term of the first line that is not 0, something that can be changed, and what the term is then.
void put_remedies(Budget& b, const RemedyParts& parts);

/// For what is observed: a run of its own, which tracks its rounding where it can.
std::unique_ptr<FloatRun> second_run(const FloatFormat& format, const FloatQuestion& q);

/// throws  BadInput, Unable  for what cannot be run
void check_steps(std::int64_t steps);

/// A jump from the ground under g, such that the exact parabola reaches the height.
struct JumpBudgetQuestion {
  FloatQuestion question;  ///< with v0 to 400 digits where it is irrational
  Surd launch;             ///< sqrt(2 g H)
};
/// throws  BadInput  unless height and g are positive
JumpBudgetQuestion jump_question(const FloatQuestion& question, const Rational& height, const Rational& g);

}  // namespace shortfall
