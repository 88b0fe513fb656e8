// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/trade/smooth_tape.hpp"

namespace shortfall {

/// How many values a tape is run on side by side.
inline constexpr std::size_t kTapeLanes = 16;

/// A tape of one coordinate (inputs x, v, t; one output) on kTapeLanes values at once, each with the bits
/// that run_tape would give it: an operation is done for all of them before the next, so that the compiler
/// has loops of known length to put into vector registers.
///
/// S is float or double. `rows` holds kTapeLanes numbers for each node, those of constants already in place.
template <class S>
void run_tape_lanes(const SmoothTape& tape, const S* x, const S* v, S t, S* rows, S* out) {
  using Op = SmoothTape::Op;
  constexpr std::size_t n = kTapeLanes;
  for (std::size_t l = 0; l < n; ++l) rows[l] = x[l];
  for (std::size_t l = 0; l < n; ++l) rows[n + l] = v[l];
  for (std::size_t l = 0; l < n; ++l) rows[2 * n + l] = t;
  for (std::size_t i = 3; i < tape.nodes.size(); ++i) {
    const SmoothTape::Node node = tape.nodes[i];
    S* const w = rows + i * n;
    const S* const a = rows + static_cast<std::size_t>(node.a) * n;
    const S* const b = rows + static_cast<std::size_t>(node.b) * n;
    const auto each = [&](auto&& f) {
      // Neither operand overlaps the result: a node reads earlier ones.
      S result[n];
      for (std::size_t l = 0; l < n; ++l) result[l] = f(l);
      for (std::size_t l = 0; l < n; ++l) w[l] = result[l];
    };
    switch (node.op) {
      case Op::input:
      case Op::constant:
        break;
      case Op::add:
        each([&](std::size_t l) { return a[l] + b[l]; });
        break;
      case Op::subtract:
        each([&](std::size_t l) { return a[l] - b[l]; });
        break;
      case Op::multiply:
        each([&](std::size_t l) { return a[l] * b[l]; });
        break;
      case Op::divide:
        each([&](std::size_t l) { return a[l] / b[l]; });
        break;
      case Op::negate:
        each([&](std::size_t l) { return -a[l]; });
        break;
      case Op::absolute:
        each([&](std::size_t l) { return std::abs(a[l]); });
        break;
      case Op::sqrt:
        each([&](std::size_t l) { return std::sqrt(a[l]); });
        break;
      case Op::exp:
        each([&](std::size_t l) { return std::exp(a[l]); });
        break;
      case Op::log:
        each([&](std::size_t l) { return std::log(a[l]); });
        break;
      case Op::sin:
        each([&](std::size_t l) { return std::sin(a[l]); });
        break;
      case Op::cos:
        each([&](std::size_t l) { return std::cos(a[l]); });
        break;
      case Op::power:
        each([&](std::size_t l) { return std::pow(a[l], b[l]); });
        break;
    }
  }
  const S* const result = rows + static_cast<std::size_t>(tape.outputs[0]) * n;
  for (std::size_t l = 0; l < n; ++l) out[l] = result[l];
}

}  // namespace shortfall
