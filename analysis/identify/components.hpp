// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace shortfall {

/// When an engine adds gravity and the user's force. In exact arithmetic it makes no difference, and so an
/// integrator's file knows only their sum a; but each way rounds elsewhere.
enum class Adding {
  at_once,        ///< a = g + F/m, rounded, then scaled
  after_scaling,  ///< h g + h F/m
  gravity_first,  ///< (v + h g) + h F/m
  force_first,    ///< (v + h F/m) + h g
};

/// A vector in space: computed in S, stored in C, as engines do that keep binary32 and compute in binary64.
///
/// An acceleration is two summands until its `adding` says that they be added.
template <class S, class C>
class Components {
 public:
  using Parts = std::array<C, 3>;

  Components() = default;
  explicit Components(const Parts& parts) : parts_(parts) {}
  Components(const Parts& gravity, const Parts& force, Adding adding)
      : parts_(gravity), force_(force), apart_(true), adding_(adding) {
    if (adding == Adding::at_once) *this = sum();
  }

  const Parts& parts() const { return parts_; }

  friend Components operator-(const Components& a) {
    return a.each([](S x) { return -x; });
  }
  friend Components operator*(S s, const Components& a) {
    return a.each([s](S x) { return s * x; });
  }
  friend Components operator/(const Components& a, S s) {
    return a.each([s](S x) { return x / s; });
  }
  friend Components operator+(const Components& a, const Components& b) {
    const Components left = a.sum();
    if (!b.apart_) return left.plus(b.parts_);
    if (b.adding_ == Adding::gravity_first) return left.plus(b.parts_).plus(b.force_);
    if (b.adding_ == Adding::force_first) return left.plus(b.force_).plus(b.parts_);
    return left.plus(b.sum().parts_);
  }
  friend Components operator-(const Components& a, const Components& b) {
    return a.sum().plus((-b.sum()).parts_);
  }

  /// The length, in S.
  friend S norm(const Components& a) {
    const Components whole = a.sum();
    S square = 0;
    for (const C part : whole.parts_) square = square + S(part) * S(part);
    return std::sqrt(square);
  }

 private:
  Components sum() const { return apart_ ? Components(parts_).plus(force_) : *this; }

  Components plus(const Parts& other) const {
    Components result = *this;
    for (std::size_t i = 0; i < 3; ++i) result.parts_[i] = C(S(parts_[i]) + S(other[i]));
    return result;
  }

  template <class F>
  Components each(F f) const {
    Components result = *this;
    for (C& part : result.parts_) part = C(f(S(part)));
    for (C& part : result.force_) part = C(f(S(part)));
    return adding_ == Adding::after_scaling ? result.sum() : result;
  }

  Parts parts_{};
  Parts force_{};
  bool apart_ = false;
  Adding adding_ = Adding::at_once;
};

}  // namespace shortfall
