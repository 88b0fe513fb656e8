// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/surd.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// The motion that an integrator is meant to follow after a launch straight up: x'' = -g - drag x', with
/// drag 0 unless the program says otherwise by `solves`.
///
/// With drag, exponentials and logarithms are rounded to 100 digits.
class IntendedMotion {
 public:
  /// throws  Unable  when `solves` is not gravity with a linear drag of one rate, 0 or more
  IntendedMotion(const Program& program, const Values& parameters);

  const Rational& drag() const { return drag_; }  ///< per second
  bool damped() const { return !drag_.is_zero(); }

  /// (launch + g/drag)(1 - e^(-drag t))/drag - g t/drag, or launch t - g t^2/2.
  Surd height(const Surd& launch, const Rational& g, const Rational& t) const;
  /// Its greatest height: launch/drag - g/drag^2 log(1 + drag launch/g), or launch^2/(2 g).
  Surd top(const Surd& launch, const Rational& g) const;
  /// When it is there, seconds: log(1 + drag launch/g)/drag, or launch/g.
  Surd time_of_top(const Surd& launch, const Rational& g) const;

 private:
  Rational drag_;
};

}  // namespace shortfall
