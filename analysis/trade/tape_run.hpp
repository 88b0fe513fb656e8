// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "analysis/trade/nilpotent.hpp"
#include "analysis/trade/smooth_tape.hpp"

namespace shortfall {

template <class S>
S power_of(const S& base, const S& exponent) {
  using std::pow;
  return pow(base, exponent);
}
template <class T>
Nilpotent<T> power_of(const Nilpotent<T>& base, const Nilpotent<T>& exponent) {
  return with_power(base, exponent.part(0), T(pow(base.part(0), exponent.part(0))));
}

/// A tape of x (m), v (m) and t, run in numbers of any kind.
///
/// param  number  makes a constant; nullptr when `work` holds them already
///        work    one number for each node
template <class S, class MakeNumber>
void run_tape(const SmoothTape& tape, const S* x, const S* v, const S& t, int m, const MakeNumber& number,
              std::vector<S>& work, S* out) {
  using Op = SmoothTape::Op;
  using std::abs;
  using std::cos;
  using std::exp;
  using std::log;
  using std::sin;
  using std::sqrt;
  S* const w = work.data();
  for (int i = 0; i < m; ++i) w[i] = x[i];
  for (int i = 0; i < m; ++i) w[m + i] = v[i];
  w[2 * m] = t;
  const int count = static_cast<int>(tape.nodes.size());
  for (int i = 2 * m + 1; i < count; ++i) {
    const SmoothTape::Node n = tape.nodes[static_cast<std::size_t>(i)];
    switch (n.op) {
      case Op::input:
        break;
      case Op::constant:
        if constexpr (!std::is_same_v<MakeNumber, std::nullptr_t>)
          w[i] = number(tape.constants[static_cast<std::size_t>(n.a)]);
        break;
      case Op::add:
        w[i] = w[n.a] + w[n.b];
        break;
      case Op::subtract:
        w[i] = w[n.a] - w[n.b];
        break;
      case Op::multiply:
        w[i] = w[n.a] * w[n.b];
        break;
      case Op::divide:
        w[i] = w[n.a] / w[n.b];
        break;
      case Op::negate:
        w[i] = -w[n.a];
        break;
      case Op::absolute:
        w[i] = abs(w[n.a]);
        break;
      case Op::sqrt:
        w[i] = sqrt(w[n.a]);
        break;
      case Op::exp:
        w[i] = exp(w[n.a]);
        break;
      case Op::log:
        w[i] = log(w[n.a]);
        break;
      case Op::sin:
        w[i] = sin(w[n.a]);
        break;
      case Op::cos:
        w[i] = cos(w[n.a]);
        break;
      case Op::power:
        w[i] = power_of(w[n.a], w[n.b]);
        break;
    }
  }
  for (std::size_t o = 0; o < tape.outputs.size(); ++o) out[o] = w[tape.outputs[o]];
}

}  // namespace shortfall
