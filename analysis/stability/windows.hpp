// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/stability/algebraic_letter.hpp"
#include "analysis/stability/power_growth.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall {

/// One value of the letter at which a window begins or ends, and what the powers do exactly there.
struct WindowEdge {
  RealRoot at;
  bool pole = false;   ///< the matrix does not exist there: an implicit stage is singular
  PowerGrowth growth;  ///< meaningful without a pole
};

/// A largest interval of the letter, above 0, on which the powers of the matrix stay bounded.
struct Window {
  std::optional<WindowEdge> from;  ///< none: from 0 on
  std::optional<WindowEdge> to;    ///< none: without end
  bool from_included = false;
  bool to_included = false;
  bool decays =
      false;  ///< inside, every eigenvalue lies inside the unit circle (but for single values of the letter)
  bool keeps = false;  ///< inside, every eigenvalue but 0 lies on it

  bool is_point() const { return from && to && from->at == to->at; }
};

/// Where the powers of a matrix stay bounded, for every positive value of a letter.
struct Windows {
  std::vector<Window> windows;  ///< in increasing order
  int cells = 0;   ///< open intervals between critical values, each decided at one rational number
  int points = 0;  ///< critical values, each decided in its own number field

  bool always() const { return windows.size() == 1 && !windows[0].from && !windows[0].to; }
  /// Bounded for all small values of the letter.
  bool from_zero() const { return !windows.empty() && !windows[0].from; }
  /// The end of the window at 0; nullptr when there is no such window, or no end.
  const WindowEdge* limit() const { return from_zero() && windows[0].to ? &*windows[0].to : nullptr; }
};

/// Finds them, exactly.
///
/// Eigenvalues reach or leave the unit circle, meet on it, or cease to exist only at roots of polynomials in
/// the letter: the resultant of each factor of the characteristic polynomial and its reversal, or its
/// discriminant when it is its own reversal, resultants of two such factors, denominators. Between two
/// neighbouring roots nothing changes, so that one rational number decides; at a root the same decision is
/// made in the number field of that root.
///
/// param   matrix  contains no other letter
Windows bounded_windows(const SquareMatrix<Fraction>& matrix, Letter letter);
/// The same for entries that contain algebraic letters, too.
Windows bounded_windows(const SquareMatrix<Fraction>& matrix, Letter letter,
                        const std::vector<AlgebraicLetter>& letters);

/// A matrix of rational functions of one letter at a number.
SquareMatrix<Rational> matrix_at(const SquareMatrix<Fraction>& matrix, Letter letter, const Rational& value);
/// throws  Undefined  when a denominator vanishes there
SquareMatrix<Algebraic> matrix_at(const SquareMatrix<Fraction>& matrix, Letter letter, const RealRoot& value);

/// One rational number in each open interval between neighbouring roots (all positive, in increasing order),
/// from 0 to infinity.
std::vector<Rational> samples_between(const std::vector<RealRoot>& roots);

}  // namespace shortfall
