// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the written classes of all integrators share: the functions of numbers that they call, and the
// branches of `limit` and `when`. Vector types of which one value holds many trajectories overload them.

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "analysis/problems/stage_solver.hpp"

#ifdef __FAST_MATH__
#error "steps mean nothing with -ffast-math"
#endif

namespace shortfall::native {

/// Stands between the stores of two numbers after a loop. Compilers that see them side by side put both into
/// one register, and carry that through the loop: a step of symplectic Euler then takes half as long again.
inline void apart() {
#ifdef __GNUC__
  asm volatile("" ::: "memory");
#endif
}

template <class S>
S larger(const S& a, const S& b) {
  return a < b ? b : a;
}
template <class S>
S smaller(const S& a, const S& b) {
  return b < a ? b : a;
}

/// The size of a number.
template <class S>
S length(const S& value) {
  return value < S() ? S(-value) : value;
}

/// Whether something is longer than a size: a bool, or one for each trajectory.
template <class V, class S>
bool longer(const V& measured, const S& size) {
  return size < length(measured);
}
inline bool any(bool condition) { return condition; }
template <class V>
V chosen(bool condition, const V& yes, const V& no) {
  return condition ? yes : no;
}

/// v, scaled by size over the length of what is measured where that is longer.
template <class V, class S>
V limited(const V& v, const V& measured, const S& size) {
  const auto beyond = longer(measured, size);
  if (!any(beyond)) return v;
  return chosen(beyond, V(size / length(measured) * v), v);
}

}  // namespace shortfall::native
