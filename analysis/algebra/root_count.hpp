// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/univariate.hpp"

namespace shortfall {

/// The sign of a polynomial at rational numbers, exact: by Horner's rule in whole numbers, of which none is
/// reduced.
class ExactSign {
 public:
  explicit ExactSign(const Univariate<Rational>& p);
  int operator()(const Rational& x) const;

 private:
  struct Coefficients;
  std::shared_ptr<const Coefficients> coefficients_;  ///< times a positive number
};

/// Counts the real roots of a square-free polynomial, exactly: each is isolated in a ball once, and where a
/// number lies in the ball of a root the polynomial's sign there tells on which side.
///
/// source  Johansson, Arb, arb_fmpz_poly_complex_roots: disjoint enclosures, those of real roots real
class RootCount {
 public:
  /// throws  Error  when p is 0 or has a multiple root
  explicit RootCount(const Univariate<Rational>& p);

  /// Roots x with low < x <= high.
  int roots_between(const Rational& low, const Rational& high) const;
  int roots() const { return static_cast<int>(enclosures_.size()); }

 private:
  /// How many roots are greater than this.
  int above(const Rational& low) const;
  ExactSign sign_;
  std::vector<std::pair<Rational, Rational>> enclosures_;  ///< in increasing order, disjoint
};

}  // namespace shortfall
