// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/near_root.hpp"

namespace shortfall {

Rational near(const RealRoot& root, int digits) {
  if (root.is_rational()) return root.rational();
  const RealRoot fine = root.refined(Rational(1) / Rational(10).pow(root.places(digits)));
  return (fine.low() + fine.high()) / Rational(2);
}

}  // namespace shortfall
