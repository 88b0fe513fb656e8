// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/real_roots.hpp"
#include "analysis/correction/matching.hpp"
#include "analysis/motion/linear_flow.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// How far the branch of a single parameter goes: from 0, as long as the step's answer falls strictly.
struct BranchRange {
  bool all = false;                  ///< every value that the exact flow takes is reached
  std::optional<RealRoot> end;       ///< of h^2 k (or h c), where the answer turns round or has a pole
  std::optional<std::string> least;  ///< the smallest value reached there: of cos(w h), or of e^(-c h); exact
                                     ///< where `end` is rational, otherwise 20 digits
};

/// Parameters that are no rational functions of the exact flow: roots of equations.
struct ImplicitParameters {
  std::vector<Letter> unknowns;       ///< of the stiffness, the damping, or both
  std::vector<Polynomial> equations;  ///< each = 0, in the letters of kit_letters.hpp
  /// The determinant of their derivatives where the step is 0; not 0, so there is one solution for small
  /// steps.
  Fraction jacobian;
  std::vector<Fraction>
      leading;  ///< for each unknown, the first power of h by which it differs from the true value
  std::vector<Definition>
      radicals;  ///< the solution by square roots, where the equations are quadratic; in this order
  std::optional<Expr>
      stability_function;  ///< R(u), where one step is R(h A): then R(u) = e^(lambda h) for both roots u
  std::optional<BranchRange> range;  ///< with one unknown and no further letters
};

/// What is known about an algebraic matching.
///
/// param   k, c  the true stiffness and damping, for the leading terms
ImplicitParameters implicit_parameters(const Matching& matching, const BranchPoint& point, const Fraction& k,
                                       const Fraction& c, const Program& program, const Values& given,
                                       int substeps, const std::vector<std::string>& names);

}  // namespace shortfall
