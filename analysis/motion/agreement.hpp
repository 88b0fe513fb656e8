// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// To how many digits after the point the coefficients of a program are known: the smallest number printed in
/// its `approx` lines; 0 when all are exact.
int printed_digits(const Program& program);

/// What is to be said of results about a program with `approx` coefficients; empty when all are exact.
std::string about_printed_decimals(const Program& program);

/// Whether differences between what is claimed and what is found are zero: exactly when a program's
/// coefficients are exact, otherwise as far as the digits printed can tell.
///
/// A coefficient of a result inherits the error of the decimals times how strongly it depends on them; two of
/// the digits printed are allowed for that. The units of what is compared do not matter: only numbers in
/// front of letters are measured.
class Agreement {
 public:
  explicit Agreement(const Program& program) : printed_(printed_digits(program)) {}

  /// One more difference that should be zero.
  void add(const Fraction& difference);
  void add(const Sequence& difference);

  bool holds() const { return holds_; }
  /// To how many digits all of them are zero, at most as many as are printed; 0 when it is exact.
  int digits() const;

 private:
  static constexpr int kLost = 2;
  int printed_;
  bool holds_ = true;
  Rational largest_;
};

}  // namespace shortfall
