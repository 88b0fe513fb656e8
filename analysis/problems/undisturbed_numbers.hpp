// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>
#include <string>

#include "analysis/problems/numbers.hpp"

namespace shortfall {

/// What a function makes of rational numbers: the value itself where it is rational, otherwise a rational
/// number within 10^-100 of it, relatively.
///
/// param   rounded  gets the function's text, "pow(9/10, 1/50)", when the value had to be rounded
/// throws  Undefined  for a logarithm of what is not positive, a root or power of what is negative
Rational value_to_100_digits(Function f, const Rational& a, const Rational& b,
                             std::set<std::string>* rounded = nullptr);

/// Rational numbers as closed forms take a step: no limit acts and every `when` holds, whatever the speed.
/// Irrational functions and roots are rounded to 100 digits, and what was is remembered.
struct UndisturbedNumbers : Numbers<Rational> {
  std::shared_ptr<std::set<std::string>> rounded = std::make_shared<std::set<std::string>>();

  bool longer(const Rational&, const Rational&, bool assumed) const { return assumed; }
  Rational shortened(const Rational& v, const Rational&, const Rational&) const { return v; }
  Rational function(Function f, const Rational& a, const Rational& b) const {
    return value_to_100_digits(f, a, b, rounded.get());
  }
  Rational root(const RealRoot& root, const std::string& name) const {
    if (!root.is_rational()) rounded->insert(name);
    return near(root, root_digits);
  }
};

/// Under an acceleration that is always this number.
inline UndisturbedNumbers constant_force(int value) {
  return {{.force = [value](const Rational&, const Rational&, const Rational&) { return Rational(value); }}};
}

}  // namespace shortfall
