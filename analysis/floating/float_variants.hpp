// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "analysis/floating/wrapped_number.hpp"

namespace shortfall {

/// A number whose products wait: added to something they are fused into one rounding, as compilers contract
/// a * b + c where they may. Any other use rounds them first.
///
/// T has fma(a, b, c). Where both sides of a sum wait, the left one is fused.
template <class T>
class Fused {
 public:
  using Inner = T;
  Fused() = default;
  explicit Fused(T value) : a_(std::move(value)) {}

  T value() const { return waits_ ? a_ * b_ : a_; }

  Fused operator-() const {
    Fused result = *this;
    result.a_ = -result.a_;
    return result;
  }
  friend Fused operator+(const Fused& p, const Fused& q) {
    using std::fma;
    if (p.waits_) return Fused(fma(p.a_, p.b_, q.value()));
    if (q.waits_) return Fused(fma(q.a_, q.b_, p.a_));
    return Fused(p.a_ + q.a_);
  }
  friend Fused operator-(const Fused& p, const Fused& q) {
    using std::fma;
    if (p.waits_) return Fused(fma(p.a_, p.b_, -q.value()));
    if (q.waits_) return Fused(fma(-q.a_, q.b_, p.a_));
    return Fused(p.a_ - q.a_);
  }
  friend Fused operator*(const Fused& p, const Fused& q) {
    Fused result(p.value());
    result.b_ = q.value();
    result.waits_ = true;
    return result;
  }
  friend Fused operator/(const Fused& p, const Fused& q) { return Fused(p.value() / q.value()); }
  friend bool operator==(const Fused& p, const Fused& q) { return p.value() == q.value(); }
  friend bool operator<(const Fused& p, const Fused& q) { return p.value() < q.value(); }

 private:
  T a_{};
  T b_{};
  bool waits_ = false;
};

/// A number that carries what its last addition rounded off, and gives it to the next: Kahan's compensated
/// summation wherever a value is added to. Scaled or given to a force, the number alone counts.
///
/// Source: Kahan (1965), Further remarks on reducing truncation errors, Communications of the ACM 8.
template <class T>
class Compensated {
 public:
  using Inner = T;
  Compensated() = default;
  explicit Compensated(T value) : value_(std::move(value)) {}

  const T& value() const { return value_; }

  Compensated operator-() const {
    Compensated result(-value_);
    result.carry_ = -carry_;
    return result;
  }
  /// The larger of two numbers is rarely known before; two-sum needs no order.
  friend Compensated operator+(const Compensated& p, const Compensated& q) {
    const T increment = q.value_ + (p.carry_ + q.carry_);
    Compensated result(p.value_ + increment);
    const T part = result.value_ - p.value_;
    result.carry_ = (p.value_ - (result.value_ - part)) + (increment - part);
    return result;
  }
  friend Compensated operator-(const Compensated& p, const Compensated& q) { return p + -q; }
  friend Compensated operator*(const Compensated& p, const Compensated& q) {
    return Compensated(p.value_ * q.value_);
  }
  friend Compensated operator/(const Compensated& p, const Compensated& q) {
    return Compensated(p.value_ / q.value_);
  }
  friend bool operator==(const Compensated& p, const Compensated& q) { return p.value_ == q.value_; }
  friend bool operator<(const Compensated& p, const Compensated& q) { return p.value_ < q.value_; }

 private:
  T value_{};
  T carry_{};
};

/// A binary32 number beside a binary64 origin: what large worlds hold positions in. Sums are of the offsets
/// in binary32; an offset of 1 or more is moved into the origin.
class OffsetFloat {
 public:
  using Inner = float;
  OffsetFloat() = default;
  explicit OffsetFloat(float value) : OffsetFloat(0, value) {}
  OffsetFloat(double origin, float offset) : origin_(origin), offset_(offset) { settle(); }

  double origin() const { return origin_; }
  float offset() const { return offset_; }
  /// What a force or a product sees: one number in binary32.
  float value() const { return static_cast<float>(origin_ + static_cast<double>(offset_)); }

  OffsetFloat operator-() const { return {-origin_, -offset_}; }
  friend OffsetFloat operator+(const OffsetFloat& a, const OffsetFloat& b) {
    return {a.origin_ + b.origin_, a.offset_ + b.offset_};
  }
  friend OffsetFloat operator-(const OffsetFloat& a, const OffsetFloat& b) { return a + -b; }
  friend OffsetFloat operator*(const OffsetFloat& a, const OffsetFloat& b) {
    return {0, a.value() * b.value()};
  }
  friend OffsetFloat operator/(const OffsetFloat& a, const OffsetFloat& b) {
    return {0, a.value() / b.value()};
  }
  friend bool operator==(const OffsetFloat& a, const OffsetFloat& b) {
    return a.origin_ == b.origin_ && a.offset_ == b.offset_;
  }
  friend bool operator<(const OffsetFloat& a, const OffsetFloat& b) {
    return a.origin_ + static_cast<double>(a.offset_) < b.origin_ + static_cast<double>(b.offset_);
  }

 private:
  void settle() {
    if (!(std::abs(offset_) >= 1) || !std::isfinite(offset_)) return;
    const float whole = std::trunc(offset_);
    origin_ += static_cast<double>(whole);
    offset_ -= whole;
  }
  double origin_ = 0;
  float offset_ = 0;
};

}  // namespace shortfall
