// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

/// A function of the step count n in closed form: the sum of coefficient(n) * base^n.
///
/// Coefficients are polynomials in n over the rational functions of the other letters; bases are such
/// functions without n. Invariant: bases differ and are not 0, coefficients are not 0; so equality of
/// sequences (as functions of all n) is structural.
class Sequence {
 public:
  struct Term {
    Fraction base;
    Fraction coefficient;
    bool operator==(const Term&) const = default;
  };

  Sequence() = default;
  Sequence(const Fraction& polynomial) : Sequence(1, polynomial) {}
  Sequence(const Fraction& base, const Fraction& coefficient);

  const std::vector<Term>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  /// Whether it is a polynomial in n: no base but 1.
  bool is_polynomial() const;
  /// The coefficient of 1^n.
  Fraction polynomial() const;

  Sequence operator-() const;
  Sequence& operator+=(const Sequence&);
  Sequence& operator-=(const Sequence&);
  Sequence& operator*=(const Fraction& factor);
  friend Sequence operator+(Sequence a, const Sequence& b) { return a += b; }
  friend Sequence operator-(Sequence a, const Sequence& b) { return a -= b; }
  friend Sequence operator*(const Sequence& a, const Sequence& b);
  bool operator==(const Sequence& other) const { return (*this - other).is_zero(); }

  /// Its value after so many steps, exact.
  Fraction at(int n) const;
  /// The sequence n -> this(n + by).
  Sequence shifted(int by) const;

 private:
  void add(const Fraction& base, const Fraction& coefficient);
  std::vector<Term> terms_;
};

}  // namespace shortfall
