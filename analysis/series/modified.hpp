// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/series/order.hpp"

namespace shortfall {

/// One term of a modified equation: coefficient * h^power * differential, in the derivative of a component.
struct FieldTerm {
  std::string component;  ///< whose derivative: "x", "v" or "y"
  int power;              ///< of h; one less than the order of the tree
  std::string tree;
  std::string differential;
  std::string latex;
  Fraction coefficient;  ///< in front of the differential: b(t)/sigma(t)
};

/// The equation that a step really solves (backward error analysis), or the equation that it has to be given
/// so that it solves the right one (a modifying integrator).
///
/// Sources: Hairer, Lubich & Wanner (2006), IX; Chartier, Hairer & Vilmart (2007), Numerical integrators
/// based on modified differential equations, Mathematics of Computation 76.
struct ModifiedEquation {
  std::string integrator;
  const ForceClass* forces = nullptr;  ///< null for y' = f(y)
  int order = 0;                       ///< trees up to this order
  bool modifying = false;
  std::vector<FieldTerm> terms;  ///< by power of h, zero terms left out
  Fraction checksum;             ///< plain sum of b(t) over all trees, not divided by sigma(t)
  std::size_t trees = 0;
  /// Why there is no modifying equation of the form asked for; empty when there is one.
  std::string obstruction;
  int digits = 0;  ///< 0: exact; otherwise of the coefficients of the integrator
  std::vector<std::string> notes;
};

/// The modified equation up to trees of an order, for y' = f(y) (forces null: a tableau is needed) or for a
/// class of forces.
///
/// throws  Unable  when there is no series, or the trees would take more than the limits allow
ModifiedEquation modified_equation(const SeriesSource& source, const ForceClass* forces, int order,
                                   const OrderLimits& limits = {});

/// What the step must be given instead of f (a tableau), or instead of the force (other steps: where no force
/// helps, the first condition that cannot be met is the obstruction).
ModifiedEquation modifying_equation(const SeriesSource& source, const ForceClass* forces, int order,
                                    const OrderLimits& limits = {});

}  // namespace shortfall
