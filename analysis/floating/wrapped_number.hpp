// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace shortfall {

/// A number type around another one, which its functions are left to.
template <class W>
concept WrappedNumber = requires(const W& w) {
  typename W::Inner;
  W(typename W::Inner(w.value()));
};

template <WrappedNumber W>
W sqrt(const W& a) {
  using std::sqrt;
  return W(sqrt(typename W::Inner(a.value())));
}
template <WrappedNumber W>
W exp(const W& a) {
  using std::exp;
  return W(exp(typename W::Inner(a.value())));
}
template <WrappedNumber W>
W log(const W& a) {
  using std::log;
  return W(log(typename W::Inner(a.value())));
}
template <WrappedNumber W>
W pow(const W& a, const W& b) {
  using std::pow;
  return W(pow(typename W::Inner(a.value()), typename W::Inner(b.value())));
}

}  // namespace shortfall
