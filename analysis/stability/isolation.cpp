// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/isolation.hpp"

#include "analysis/algebra/root_count.hpp"

namespace shortfall {

Isolation isolation(const RealRoot& number) {
  const RootCount roots(number.polynomial());
  for (int places = 1;; ++places) {
    const Rational unit = Rational(10).pow(-places);
    // No decimal is a root of an irreducible polynomial of higher degree: the floors of both ends agree in
    // the end.
    RealRoot narrow = number.refined(unit / 2);
    while ((narrow.low() / unit).floor() != (narrow.high() / unit).floor())
      narrow = narrow.refined((narrow.high() - narrow.low()) / 2);
    const Rational low = (narrow.low() / unit).floor() * unit, high = low + unit;
    if (roots.roots_between(low, high) == 1) return {low.decimal(places), high.decimal(places)};
  }
}

}  // namespace shortfall
