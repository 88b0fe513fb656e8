// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/lie_quotient.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// A coefficient for readers: exact, or as many digits as are known.
struct SplittingCoefficient {
  std::string exact;    ///< "1/24", "1/4 - 1/6*r"; empty when only digits are known
  std::string decimal;  ///< 20 significant digits, rounded; when only digits are known, those
  /// Digits after the point that are certain; for exact ones 0, and meaningless.
  int digits = 0;
};

struct SplittingWeight {
  bool kick = false;
  SplittingCoefficient weight;
};

/// coefficient * h^degree * bracket, in drifts A and kicks B.
struct BracketTerm {
  int degree = 0;
  std::string bracket;  ///< "[A,[A,B]]"
  SplittingCoefficient coefficient;
};

/// What the logarithm of a splitting says about one class of problems.
struct SplittingClass {
  VectorFields kind = VectorFields::any;
  std::vector<BracketTerm> modified;  ///< the modified vector field times h
  int order = 0;
  bool order_is_exact = false;  ///< the next order's error was found; otherwise the order is this or more
  int effective_order = 0;      ///< that of launch, steps, read-out
  bool effective_order_is_exact = false;
  /// When numbers are known to digits only: to so many digits after the point, at least, all error terms
  /// below the order are 0; the same for the processed method, whose terms lose some.
  std::optional<int> zero_to_digits;
  std::optional<int> effective_zero_to_digits;
  std::vector<std::vector<BracketTerm>> corrections;  ///< c_1, c_2, ...; see SplittingProcessing
  std::vector<BracketTerm> corrector;                 ///< the logarithm of P, the launch
  struct Obstruction {
    std::vector<BracketTerm> functional;  ///< whole numbers: which coefficients are added up
    SplittingCoefficient value;
  };
  int obstruction_degree = 0;             ///< 0 when there is none up to the degree asked for
  std::vector<Obstruction> obstructions;  ///< those that are not 0
};

/// An integrator's step as a splitting: its error in brackets, and what processing can do about it.
struct SplittingReport {
  std::string why_not;    ///< a clause; when not empty, the rest is empty
  bool proved = false;    ///< by exact numbers; otherwise to digits
  std::string generator;  ///< of the algebraic numbers, as an expression; empty for rational ones
  bool time_follows_drifts = true;
  std::vector<SplittingWeight> start, step, finish;
  int degree = 0;
  SplittingClass any;         ///< for x' = v, v' = a(x) and every other pair of fields
  SplittingClass mechanical;  ///< for x'' = a(x) alone, where more brackets vanish
};

/// A position-only force in place of a, with launch and read-out, for x'' = a(x); see
/// SplittingForceCorrection.
struct SplittingForceReport {
  std::string why_not;  ///< a clause; when not empty, the rest is empty
  bool proved = false;
  std::string generator;
  std::vector<BracketTerm> kick;  ///< in place of B; [[A,B],B] is -2 a_x[a]
  SplittingClass processed;       ///< the step with that kick
  /// Why no further position-only kick helps; none when the degree asked for was reached.
  struct Limit {
    int degree = 0;
    int conditions = 0;
    int unknowns = 0;
    SplittingCoefficient residual;
    bool conclusive = true;  ///< it holds for every position-only correction
  };
  std::optional<Limit> limit;
};

/// throws  Unable  when the degree is not from 2 to 12
SplittingForceReport splitting_force_report(const Program& program, int degree, const Values& given = {});

/// throws  Unable  when the degree is not from 2 to 12
SplittingReport splitting_report(const Program& program, int degree, const Values& given = {});

}  // namespace shortfall
