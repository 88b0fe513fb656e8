// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/native/stepping.hpp"

namespace shortfall::native {

/// A vector of D components; each operation is done component by component, with one rounding each.
template <class S, std::size_t D>
class FixedVector {
 public:
  FixedVector() = default;
  explicit FixedVector(std::size_t) {}
  static constexpr std::size_t size() { return D; }
  S* data() { return parts_.data(); }
  const S* data() const { return parts_.data(); }
  S& operator[](std::size_t i) { return parts_[i]; }
  const S& operator[](std::size_t i) const { return parts_[i]; }

 private:
  std::array<S, D> parts_{};
};

/// A vector of up to Most components, how many is known at run time; it needs no memory but its own.
template <class S, std::size_t Most>
class BoundedVector {
 public:
  BoundedVector() = default;
  explicit BoundedVector(std::size_t size) : size_(size) { std::fill_n(data(), size, S()); }
  BoundedVector(const BoundedVector& other) : size_(other.size_) { std::copy_n(other.data(), size_, data()); }
  BoundedVector& operator=(const BoundedVector& other) {
    size_ = other.size_;
    std::copy_n(other.data(), size_, data());
    return *this;
  }
  ~BoundedVector() = default;
  std::size_t size() const { return size_; }
  S* data() { return parts_.data(); }
  const S* data() const { return parts_.data(); }
  S& operator[](std::size_t i) { return parts_[i]; }
  const S& operator[](std::size_t i) const { return parts_[i]; }

  /// Without values yet: whoever asks for one fills it.
  static BoundedVector unfilled(std::size_t size) {
    BoundedVector result;
    result.size_ = size;
    return result;
  }

 private:
  std::size_t size_ = 0;
  std::array<S, Most> parts_;
};

template <class V>
struct ComponentsOf {};
template <class S, std::size_t D>
struct ComponentsOf<FixedVector<S, D>> {
  using Scalar = S;
  static FixedVector<S, D> made(std::size_t) { return {}; }
};
template <class S, std::size_t Most>
struct ComponentsOf<BoundedVector<S, Most>> {
  using Scalar = S;
  static BoundedVector<S, Most> made(std::size_t size) { return BoundedVector<S, Most>::unfilled(size); }
};
template <class V>
concept Dense = requires {
  typename ComponentsOf<V>::Scalar;
};

// Long steps are too much for the compiler's own choice: called instead of inlined, these cost a step of many
// stages five times its time.
template <Dense V, class Operation>
[[gnu::always_inline]] inline V by_component(const V& like, const Operation& operation) {
  V result = ComponentsOf<V>::made(like.size());
  for (std::size_t i = 0; i < like.size(); ++i) result[i] = operation(i);
  return result;
}
template <Dense V>
[[gnu::always_inline]] inline V operator+(const V& a, const V& b) {
  return by_component(a, [&](std::size_t i) { return a[i] + b[i]; });
}
template <Dense V>
[[gnu::always_inline]] inline V operator-(const V& a, const V& b) {
  return by_component(a, [&](std::size_t i) { return a[i] - b[i]; });
}
template <Dense V>
[[gnu::always_inline]] inline V operator-(const V& a) {
  return by_component(a, [&](std::size_t i) { return -a[i]; });
}
template <Dense V>
[[gnu::always_inline]] inline V operator*(const typename ComponentsOf<V>::Scalar& s, const V& a) {
  return by_component(a, [&](std::size_t i) { return s * a[i]; });
}
template <Dense V>
[[gnu::always_inline]] inline V operator/(const V& a, const typename ComponentsOf<V>::Scalar& s) {
  return by_component(a, [&](std::size_t i) { return a[i] / s; });
}

/// The Euclidean length; of one component its size, as of a number.
template <Dense V>
auto length(const V& v) {
  using S = typename ComponentsOf<V>::Scalar;
  if (v.size() == 1) return length<S>(v[0]);
  using std::sqrt;
  S sum = v[0] * v[0];
  for (std::size_t i = 1; i < v.size(); ++i) sum = sum + v[i] * v[i];
  return S(sqrt(sum));
}

}  // namespace shortfall::native

namespace shortfall {

template <native::Dense V>
struct VectorParts<V> {
  using Scalar = typename native::ComponentsOf<V>::Scalar;
  static constexpr std::size_t kLanes = 1;
  static std::size_t components(const V& v) { return v.size(); }
  static Scalar& at(V& v, std::size_t component, std::size_t) { return v[component]; }
  static const Scalar& at(const V& v, std::size_t component, std::size_t) { return v[component]; }
};

}  // namespace shortfall
