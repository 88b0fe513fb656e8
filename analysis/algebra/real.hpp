// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"

namespace shortfall {

/// A binary floating-point number of MPFR whose precision is chosen at run time.
///
/// A result has the larger precision of its operands; with a newer Boost (1.83, not 1.74) it has no fewer
/// digits than Precision::current(), so numbers of few digits are computed with inside a Precision of theirs.
/// Expression templates are off: with them x += h*v would be fused into one rounding. A heavy header: only
/// files that compute with such numbers include it.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                           boost::multiprecision::et_off>;

/// The Real nearest to an exact number, with the precision of so many decimal digits, ties to even.
///
/// throws  Error  when digits is not in 1..1,000,000
Real real(const Rational& value, int digits);
Real real(const Surd& value, int digits);

/// While it lives, numbers made from plain literals (Real(2)) have so many decimal digits; then all is as
/// before.
///
/// The default belongs to the thread, but to the whole process with a Boost (such as 1.74) that keeps only
/// one: there, threads at work together must use the same precision.
class Precision {
 public:
  /// throws  Error  when digits is not in 1..1,000,000
  explicit Precision(int digits);
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;
  ~Precision();

  static int current();  ///< decimal digits

 private:
  int saved_;
};

}  // namespace shortfall
