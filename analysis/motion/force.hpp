// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

/// Of a polynomial in t that a user may ask for.
inline constexpr int kHighestForceDegree = 1000;

/// The accelerations for which motions are known exactly: f0 + f1 t + ... + fD t^D - k x - c v.
struct Force {
  int degree = 0;                ///< D; -1 when nothing depends on time alone
  bool spring = false;           ///< - k x
  bool damper = false;           ///< - c v
  std::optional<Rational> k;     ///< 1/s^2; a letter when not given
  std::optional<Rational> c;     ///< 1/s; a letter when not given
  std::map<int, Rational> push;  ///< f0 (= a), f1, ... as far as they are given as numbers
  bool nothing = false;          ///< k and c were given as 0: a free body, whose f0 is 0
  std::string text = "constant";
  /// Of an integrator that has a spring or a damper itself, see own_equation.hpp: k and c in its letters.
  std::optional<Fraction> own_k;
  std::optional<Fraction> own_c;
  bool own_open = false;  ///< whether a parameter in them has no number

  bool linear() const { return spring || damper; }
  Fraction stiffness() const;  ///< the letter k, the number, or 0
  Fraction damping() const;
  /// Whether k and c are known as numbers, or as functions of numbers.
  bool numeric() const;
};

/// The force that a user means: constant, poly:D, spring, damped-spring, drag (a - c v), and sums such as
/// constant+spring; spring:k=4, damped-spring:k=4,c=1/2, constant:a=-9.81 and poly:1:f0=1,f1=2 fix letters.
///
/// throws  BadInput  with a suggestion; k and c given as 0 mean that there is none
Force force_named(std::string_view text);

}  // namespace shortfall
