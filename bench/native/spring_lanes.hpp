// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace shortfall::bench {

/// -k x in numbers or in lanes of them.
struct Spring {
  double k;
  template <class V>
  V operator()(const V& x, const V&, const double&) const {
    return -(k * x);
  }
};

/// Steps many springs by symplectic Euler in lanes, with the force compiled into the loop. For processors
/// with AVX2.
void spring_lanes(std::span<double> x, std::span<double> v, double k, double h, std::int64_t steps);

}  // namespace shortfall::bench
