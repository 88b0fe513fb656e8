// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/near_root.hpp"

#include <algorithm>
#include <vector>

namespace shortfall {

namespace {

/// Every run of a method asks for its few constants again, and each costs some hundred halvings.
struct Remembered {
  RealRoot root;
  int digits;
  Rational value;
};
constexpr std::size_t kMostRemembered = 64;

bool same_interval(const RealRoot& a, const RealRoot& b) {
  return a.low() == b.low() && a.high() == b.high() && a.polynomial() == b.polynomial();
}

}  // namespace

Rational near(const RealRoot& root, int digits) {
  if (root.is_rational()) return root.rational();
  thread_local std::vector<Remembered> memory;
  const auto found = std::ranges::find_if(
      memory, [&](const Remembered& m) { return m.digits == digits && same_interval(m.root, root); });
  if (found != memory.end()) return found->value;
  const RealRoot fine = root.refined(Rational(1) / Rational(10).pow(root.places(digits)));
  if (memory.size() == kMostRemembered) memory.clear();
  memory.push_back({root, digits, (fine.low() + fine.high()) / Rational(2)});
  return memory.back().value;
}

}  // namespace shortfall
