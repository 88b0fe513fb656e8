// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/lie_element.hpp"
#include "tests/algebra/random.hpp"

namespace shortfall {

inline void showValue(const LieElement<Rational>& x, std::ostream& out) { out << text(x); }

namespace random {

/// An element with small coordinates, about half of them 0.
inline rc::Gen<LieElement<Rational>> lie_element(int degree) {
  std::size_t count = 0;
  for (int d = 1; d <= degree; ++d)
    count += static_cast<std::size_t>(LyndonBasis::up_to(degree).dimension(d));
  const auto coordinate = rc::gen::oneOf(rc::gen::just(Rational(0)), small_rational());
  return rc::gen::map(rc::gen::container<std::vector<Rational>>(count, coordinate),
                      [degree](const std::vector<Rational>& coordinates) {
                        LieElement<Rational> x(degree);
                        std::size_t next = 0;
                        for (int d = 1; d <= degree; ++d)
                          for (Rational& c : x.part(d)) c = coordinates[next++];
                        return x;
                      });
}

}  // namespace random
}  // namespace shortfall
