// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/motion/derivation.hpp"
#include "analysis/motion/linear_flow.hpp"

namespace shortfall {

/// The same motion where the roots of the characteristic polynomial are not a complex pair.
struct RootCase {
  std::string condition;  ///< on the discriminant T^2 - 4 D
  Expr position;
  Expr velocity;
};

/// What is known exactly about an integrator under f0 + ... + fD t^D - k x - c v.
struct LinearDerivation {
  std::string integrator;
  Force force;  ///< of the true motion: with the integrator's own equation, see own_equation.hpp
  int substeps = 1;
  StepMap map;
  ClosedForm form;
  MotionProof proof;
  RandomCheck check;

  std::vector<std::vector<Fraction>>
      amplification;  ///< 2 x 2: (x, v) as reported, without forces that depend on time alone; empty when
                      ///< the reported pair alone does not determine the next one
  int amplified_from = 0;  ///< it takes the pair of step n to that of n + 1 from this n on
  std::optional<Fraction> trace;
  std::optional<Fraction> determinant;
  Fraction discriminant;  ///< T^2 - 4 D

  std::vector<Definition> definitions;  ///< theta, r of the integrator
  Expr position;                        ///< after n steps; nullptr when the recurrence has an order above 2
  Expr velocity;
  std::string condition;        ///< for which values `position` is real
  std::vector<RootCase> cases;  ///< double root, two real roots
  std::vector<DerivationStep> steps;
  LinearFlow exact;
  std::vector<Polynomial> singular;  ///< where one of these is 0 an implicit stage has no solution
  std::vector<std::string> assumptions;
  int digits = 0;  ///< of the coefficients that are known to some digits only (approx); 0 when all are exact

  bool proved() const { return proof.proved && check.agrees; }
  Wording wording() const { return {map.letters, "n", true}; }
};

/// Derives and proves, by the characteristic polynomial of the step.
///
/// throws  Unable  with the reason; Undefined when an implicit stage is singular
LinearDerivation linear_derivation(const Program& program, const Force& asked, const Values& given = {},
                                   int substeps = 1);

}  // namespace shortfall
