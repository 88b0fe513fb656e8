// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/series/known_digits.hpp"
#include "analysis/series/splitting_parts.hpp"

namespace shortfall {

/// An integrator's step as kicks and drifts, with what it does before the first step and at read-out.
template <class Field>
struct KicksAndDrifts {
  SplittingParts<Field> start;
  SplittingParts<Field> step;
  SplittingParts<Field> finish;
  /// Every kick takes the force at the time that the drifts have reached; if not, the step is a splitting for
  /// forces a(x) that do not depend on time.
  bool time_follows_drifts = true;
};

/// What an integrator is as a splitting, for forces that do not read the velocity.
struct SplittingReading {
  /// Numbers of three kinds that are never mixed: rational, algebraic with one generator, known to digits.
  std::variant<std::monostate, KicksAndDrifts<Rational>, KicksAndDrifts<Algebraic>,
               KicksAndDrifts<KnownDigits>>
      parts;
  std::string why_not;    ///< a clause, "it solves for a stage, ..."; empty when it is a splitting
  std::string generator;  ///< the algebraic numbers' generator as an expression: "r", "sqrt(471)"
  std::shared_ptr<const RealRoot> generator_value;

  bool is_splitting() const { return why_not.empty(); }
};

/// Reads kicks and drifts off what a step does, however it is written: velocity Verlet with its carried
/// acceleration is kick 1/2, drift 1, kick 1/2.
///
/// A step with x1 = x + c h v + h^2 sum of b_j (c - c_j) f_j and v1 = v + h sum of b_j f_j, where f_j is the
/// force at x + c_j h v + h^2 sum over earlier i of b_i (c_j - c_i) f_i, is the composition of drifts by the
/// differences of the c_j and kicks b_j.
///
/// param   given  values of parameters; defaults for the others
/// source  Okunbor & Skeel (1992), Explicit canonical methods for Hamiltonian systems, Mathematics of
/// Computation 59; Suris (1990), Hamiltonian methods of Runge-Kutta type and their variational interpretation
SplittingReading splitting_reading(const Program& program, const Values& given = {});

}  // namespace shortfall
