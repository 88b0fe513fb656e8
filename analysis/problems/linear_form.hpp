// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

/// A vector as a linear combination of unknown vectors (columns), with rational functions as coefficients.
///
/// Columns past the end are 0; what a column stands for is the problem's business.
class LinearForm {
 public:
  LinearForm() = default;
  static LinearForm column(int index, Fraction coefficient = 1);

  const Fraction& operator[](int column) const;
  Fraction& at(int column);
  int columns() const { return static_cast<int>(coefficients_.size()); }
  bool is_zero() const;

  LinearForm operator-() const;
  LinearForm& operator+=(const LinearForm&);
  LinearForm& operator-=(const LinearForm&);
  LinearForm& operator*=(const Fraction&);
  friend LinearForm operator+(LinearForm a, const LinearForm& b) { return a += b; }
  friend LinearForm operator-(LinearForm a, const LinearForm& b) { return a -= b; }
  friend LinearForm operator*(const Fraction& factor, LinearForm a) { return a *= factor; }
  friend LinearForm operator/(LinearForm a, const Fraction& divisor) { return a *= Fraction(1) / divisor; }
  friend bool operator==(const LinearForm& a, const LinearForm& b);

  LinearForm substitute(Letter letter, const Fraction& value) const;

 private:
  std::vector<Fraction> coefficients_;
};

}  // namespace shortfall
