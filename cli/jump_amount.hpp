// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/surd.hpp"

namespace shortfall::cli {

/// Writes exact numbers for a person: with their unit, and marked where a decimal had to be rounded.
class Amounts {
 public:
  /// param   unit   of heights; empty: chosen by the size of `typical`
  Amounts(const std::string& unit, const Rational& typical, bool ascii);

  std::string height(const Surd& metres) const;             ///< "≈ 37.23798980 cm"
  std::string difference(const Surd& metres) const;         ///< the same in the unit that suits it
  std::string signed_difference(const Surd& metres) const;  ///< "≈ +2.762010199 cm"
  std::string speed(const Surd& metres_per_second) const;
  std::string time(const Surd& seconds) const;
  std::string time_equals(const Surd& seconds) const;  ///< "= 0.28 s", "≈ 0.2855686246 s"
  std::string acceleration(const Rational& value) const;
  std::string acceleration(const Surd& value) const;
  std::string height_exactly(
      const Rational& metres) const;  ///< never rounded: a fraction where no decimal ends

 private:
  struct Unit {
    std::string name;
    Rational per_metre;
  };
  Unit of_difference(const Surd& metres) const;
  std::string number(const Surd& value, bool with_sign = false) const;
  static Unit unit_named(const std::string& name);

  Unit unit_;
  std::string length_;  ///< m or px
  bool ascii_;
};

/// The finite decimal that a rational is, when it is one of at most so many digits after the point; or p/q.
std::string exact_text(const Rational& value, int places = 12);

}  // namespace shortfall::cli
