// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>

#include "analysis/native/stepping.hpp"

namespace shortfall::native {

// Which registers a file is compiled for. It is a part of the type, so that no function compiled for one
// processor can stand in for that of another when a program is linked.
struct Sse2 {
  static constexpr std::size_t kBytes = 16;
};
struct Avx2 {
  static constexpr std::size_t kBytes = 32;
};

/// The numbers of K trajectories side by side, in vector registers. Every operation is done lane by lane,
/// with one rounding each: a lane has the bits that it would have alone.
template <class S, std::size_t K, class Registers>
class Lanes {
 public:
  static constexpr std::size_t kLanes = K;
  static constexpr std::size_t kWidth = Registers::kBytes / sizeof(S);
  static constexpr std::size_t kPacks = K / kWidth;
  static_assert(K % kWidth == 0 && kPacks > 0, "lanes fill whole registers");
  typedef S Pack __attribute__((vector_size(Registers::kBytes)));
  using Truth = decltype(Pack{} < Pack{});
  struct Mask {
    Truth packs[kPacks];
  };

  Lanes() = default;
  /// The same number in every lane.
  explicit Lanes(const S& s) : Lanes(made([&](std::size_t) { return s - Pack{}; })) {}

  S operator[](std::size_t lane) const { return data()[lane]; }
  S& operator[](std::size_t lane) { return data()[lane]; }
  S* data() { return reinterpret_cast<S*>(packs_); }  // GCC lets a vector alias its elements
  const S* data() const { return reinterpret_cast<const S*>(packs_); }

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return made([&](std::size_t i) { return a.packs_[i] + b.packs_[i]; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return made([&](std::size_t i) { return a.packs_[i] - b.packs_[i]; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return made([&](std::size_t i) { return a.packs_[i] * b.packs_[i]; });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return made([&](std::size_t i) { return a.packs_[i] / b.packs_[i]; });
  }
  friend Lanes operator-(const Lanes& a) {
    return made([&](std::size_t i) { return -a.packs_[i]; });
  }
  // A scalar is one number for all lanes.
  friend Lanes operator*(const S& s, const Lanes& a) {
    return made([&](std::size_t i) { return s * a.packs_[i]; });
  }
  friend Lanes operator/(const Lanes& a, const S& s) {
    return made([&](std::size_t i) { return a.packs_[i] / s; });
  }
  friend Lanes operator/(const S& s, const Lanes& a) {
    return made([&](std::size_t i) { return s / a.packs_[i]; });
  }
  friend Lanes operator+(const S& s, const Lanes& a) {
    return made([&](std::size_t i) { return s + a.packs_[i]; });
  }
  friend Lanes operator+(const Lanes& a, const S& s) { return s + a; }
  friend Lanes operator-(const S& s, const Lanes& a) {
    return made([&](std::size_t i) { return s - a.packs_[i]; });
  }

  friend Lanes length(const Lanes& a) {
    return made([&](std::size_t i) { return a.packs_[i] < Pack{} ? -a.packs_[i] : a.packs_[i]; });
  }
  friend Mask longer(const Lanes& measured, const S& size) {
    const Lanes l = length(measured);
    Mask result;
    for (std::size_t i = 0; i < kPacks; ++i) result.packs[i] = size < l.packs_[i];
    return result;
  }
  friend bool any(const Mask& mask) {
    Truth all = mask.packs[0];
    for (std::size_t i = 1; i < kPacks; ++i) all |= mask.packs[i];
    bool found = false;
    for (std::size_t lane = 0; lane < kWidth; ++lane) found |= all[lane] != 0;
    return found;
  }
  friend Lanes chosen(const Mask& mask, const Lanes& yes, const Lanes& no) {
    return made([&](std::size_t i) { return mask.packs[i] ? yes.packs_[i] : no.packs_[i]; });
  }

 private:
  template <class Of>
  static Lanes made(const Of& of) {
    return made(of, std::make_index_sequence<kPacks>());
  }
  template <class Of, std::size_t... I>
  static Lanes made(const Of& of, std::index_sequence<I...>) {
    Lanes result;
    ((result.packs_[I] = of(I)), ...);
    return result;
  }

  Pack packs_[kPacks];
};

}  // namespace shortfall::native

namespace shortfall {

template <class S, std::size_t K, class Registers>
struct VectorParts<native::Lanes<S, K, Registers>> {
  using V = native::Lanes<S, K, Registers>;
  using Scalar = S;
  static constexpr std::size_t kLanes = K;
  static std::size_t components(const V&) { return 1; }
  static S& at(V& v, std::size_t, std::size_t lane) { return v.data()[lane]; }
  static const S& at(const V& v, std::size_t, std::size_t lane) { return v.data()[lane]; }
};

}  // namespace shortfall
