// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/near_root.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/program/function.hpp"

namespace shortfall {

/// What a program's function makes of exact numbers, where that is a number of the same kind.
///
/// throws  Unable  where it is none;  Undefined  for the square root of a negative number
Rational value_of(Function f, const Rational& a, const Rational& b);
Surd value_of(Function f, const Surd& a, const Surd& b);

/// The same in numbers that round: the C library's functions, one rounding each as far as it rounds
/// correctly.
template <class T>
T value_of(Function f, const T& a, const T& b) {
  using std::exp;
  using std::log;
  using std::pow;
  using std::sqrt;
  switch (f) {
    case Function::sqrt:
      return sqrt(a);
    case Function::exp:
      return exp(a);
    case Function::pow:
      return pow(a, b);
    case Function::log:
      return log(a);
    case Function::max:
      return a < b ? b : a;
    case Function::min:
      return b < a ? b : a;
    default:
      throw Unable("the function " + std::string(name_of(f)) + " does not stand in programs");
  }
}

}  // namespace shortfall
