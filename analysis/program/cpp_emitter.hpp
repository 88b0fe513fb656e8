// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/program.hpp"

namespace shortfall {

/// An integrator as a class template of C++.
struct CppClass {
  std::string name;  ///< VelocityVerlet
  std::string text;  ///< a whole header
};

/// The class template that does what an integrator's program says, operation by operation, in its order.
///
/// `template <class S, class V, class Force> class VelocityVerlet`: S is a number, V a vector of such numbers
/// (or S itself) and Force a function V(const V& x, const V& v, const S& t). It is made from h, a zero
/// vector, the force, a function that turns the text of an exact number into an S, and parameters; then
/// begin(x, v, t), step(), run(n), read_out(). Scalars that do not change from step to step are computed
/// once. The header includes analysis/native/stepping.hpp for what is the same in all of them.
///
/// throws  Unable  for a program that cannot be written, with the reason
CppClass cpp_class(const Program& program);

}  // namespace shortfall
