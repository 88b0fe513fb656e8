// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/force.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

/// A name that a formula uses, and what it stands for.
struct Definition {
  std::string name;
  Expr value;
  std::string note;
};

/// The motion where the roots of lambda^2 + c lambda + k are of one kind.
struct FlowCase {
  std::string condition;  ///< "k > c^2/4, underdamped"
  std::vector<Definition> definitions;
  Expr position;  ///< x(t) in x0, v0, f0.., t, k, c and what is defined
  Expr velocity;
  Expr cosine;  ///< C(t): the motion from x0 = 1, v0 = 0 without other forces
  Expr sine;    ///< S(t): the motion from x0 = 0, v0 = 1
};

/// The true motion under a linear force, in closed form. Where k and c are numbers the case is decided,
/// exactly; otherwise the oscillating one is the motion itself and the others follow in `others`.
///
/// source  any text on linear differential equations with constant coefficients
struct LinearFlow : FlowCase {
  std::vector<FlowCase> others;
};

/// The polynomial p with p'' + c p' + k p = t^d, as coefficients of t^0, t^1, ...; a free constant (k = 0) is
/// 0.
std::vector<Fraction> particular_polynomial(int d, const Fraction& k, const Fraction& c);

/// param   letters  names of the integrator's letters, which must not be taken for w
LinearFlow linear_flow(const Force& force, const std::vector<std::string>& letters);

}  // namespace shortfall
