// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall {

/// A letter of rational functions that stands for one real algebraic number: the root of 2 = w^3 in Forest's
/// and Ruth's method.
struct AlgebraicLetter {
  Letter letter = 0;
  RealRoot value;
};

/// The same function of the other letters: each algebraic letter below the degree of its number, and in no
/// denominator.
///
/// With one algebraic letter equal functions have equal forms.
///
/// throws  Undefined  when the denominator is zero once the letters have their values
Fraction reduced(const Fraction& f, const std::vector<AlgebraicLetter>& letters);
SquareMatrix<Fraction> reduced(SquareMatrix<Fraction> matrix, const std::vector<AlgebraicLetter>& letters);

/// Several algebraic numbers as numbers of one field.
struct CommonField {
  Algebraic::Generator generator;
  std::vector<Algebraic> values;  ///< of the letters, in their order
};

/// The field that all these numbers generate together.
///
/// source  Cohen (1993), A Course in Computational Algebraic Number Theory, 4.5.1: r + k s generates Q(r, s)
/// for almost every integer k
CommonField common_field(const std::vector<AlgebraicLetter>& letters);

/// A polynomial in one letter and in algebraic ones, over the field of these.
///
/// throws  Error  when it contains another letter
Univariate<Algebraic> over_field(const Polynomial& p, Letter letter,
                                 const std::vector<AlgebraicLetter>& letters, const CommonField& field);

/// The norm: a rational polynomial that is zero wherever p is, the product of p over all conjugates of its
/// field's generator.
///
/// throws  Undefined  for the zero polynomial
Univariate<Rational> norm(const Univariate<Algebraic>& p, const Algebraic::Generator& generator);

/// A positive real root of polynomials over a field K of real algebraic numbers.
struct RootOver {
  RealRoot root;                     ///< as a number over Q
  Univariate<Algebraic> polynomial;  ///< over K, monic, with no other root in the root's interval
};

/// All of them, in increasing order, in intervals that touch neither each other nor 0.
///
/// Roots of the norm belong to the polynomial or to one of its conjugates: a change of sign tells, or Sturm's
/// sequence over K.
std::vector<RootOver> positive_roots(const std::vector<Univariate<Algebraic>>& polynomials,
                                     const Algebraic::Generator& generator);

}  // namespace shortfall
