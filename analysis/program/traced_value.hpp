// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// The number that a floating-point literal means: the short decimal that prints it.
///
/// throws  BadInput  where there is none, as for 1.0/3: the number was rounded; with what to write instead
Rational meant_number(double value);
Rational meant_number(float value);

/// A scalar of a step that is being traced: no number, but how it was computed. It converts to nothing and
/// compares with nothing, since a step that branches is not one formula.
class TracedScalar {
 public:
  TracedScalar() = default;
  template <class T>
  requires std::is_arithmetic_v<T> TracedScalar(T value) : TracedScalar(from(value)) {}
  TracedScalar(const Rational& value);  ///< 1/3 is a division of whole numbers
  explicit TracedScalar(Expr e) : e_(std::move(e)) {}

  /// How it was computed.
  ///
  /// throws  BadInput  when it was never given a value
  const Expr& expression() const;

  template <class T>
  requires(!std::same_as<T, TracedScalar>) explicit operator T() const {
    static_assert(
        kNever<T>,
        "a traced scalar has no number: a step may not branch on it (if, while, &&) nor convert it; "
        "use sqrt, exp, pow, max and min of shortfall");
    return T();
  }

  friend TracedScalar operator+(const TracedScalar& a, const TracedScalar& b);
  friend TracedScalar operator-(const TracedScalar& a, const TracedScalar& b);
  friend TracedScalar operator*(const TracedScalar& a, const TracedScalar& b);
  friend TracedScalar operator/(const TracedScalar& a, const TracedScalar& b);
  TracedScalar operator-() const;
  TracedScalar operator+() const { return *this; }
  TracedScalar& operator+=(const TracedScalar& o) { return *this = *this + o; }
  TracedScalar& operator-=(const TracedScalar& o) { return *this = *this - o; }
  TracedScalar& operator*=(const TracedScalar& o) { return *this = *this * o; }
  TracedScalar& operator/=(const TracedScalar& o) { return *this = *this / o; }

  // Each comparison names what is wrong, instead of a page of candidates.
  template <class T>
  friend bool operator<(const TracedScalar&, const T&) {
    return compared<T>();
  }
  template <class T>
  friend bool operator>(const TracedScalar&, const T&) {
    return compared<T>();
  }
  template <class T>
  friend bool operator<=(const TracedScalar&, const T&) {
    return compared<T>();
  }
  template <class T>
  friend bool operator>=(const TracedScalar&, const T&) {
    return compared<T>();
  }
  template <class T>
  friend bool operator==(const TracedScalar&, const T&) {
    return compared<T>();
  }

 private:
  template <class>
  static constexpr bool kNever = false;
  template <class T>
  static bool compared() {
    static_assert(kNever<T>,
                  "a step may not compare traced values: it is one formula for all of them; use max and min "
                  "of shortfall, or `when` and `limit` of an .integrator file");
    return false;
  }
  template <class T>
  static TracedScalar from(T value) {
    static_assert(!std::same_as<T, bool>, "true and false are no numbers: write 1 or 0");
    if constexpr (std::same_as<T, float>)
      return TracedScalar(number(meant_number(value)));
    else if constexpr (std::is_floating_point_v<T>)
      return TracedScalar(number(meant_number(static_cast<double>(value))));
    else
      return TracedScalar(Rational(value));
  }

  Expr e_;
};

/// A vector of a step that is being traced.
class TracedVector {
 public:
  TracedVector() = default;
  explicit TracedVector(Expr e) : e_(std::move(e)) {}

  const Expr& expression() const;

  friend TracedVector operator+(const TracedVector& a, const TracedVector& b);
  friend TracedVector operator-(const TracedVector& a, const TracedVector& b);
  friend TracedVector operator*(const TracedScalar& a, const TracedVector& b);
  friend TracedVector operator*(const TracedVector& a, const TracedScalar& b);
  friend TracedVector operator/(const TracedVector& a, const TracedScalar& b);
  TracedVector operator-() const;
  TracedVector operator+() const { return *this; }
  TracedVector& operator+=(const TracedVector& o) { return *this = *this + o; }
  TracedVector& operator-=(const TracedVector& o) { return *this = *this - o; }
  TracedVector& operator*=(const TracedScalar& s) { return *this = *this * s; }
  TracedVector& operator/=(const TracedScalar& s) { return *this = *this / s; }

  template <class T>
  requires(!std::same_as<T, TracedVector>) explicit operator T() const {
    static_assert(kNever<T>, "a traced vector has no components: write the step for the whole vector");
    return T();
  }
  template <class T>
  TracedVector& operator[](const T&) {
    static_assert(kNever<T>, "a traced vector has no components: write the step for the whole vector");
    return *this;
  }
  template <class T>
  requires std::same_as<T, TracedVector>
  friend TracedVector operator*(const TracedVector& a, const T&) {
    static_assert(kNever<T>, "two vectors may not be multiplied: a step multiplies a vector by a scalar");
    return a;
  }

 private:
  template <class>
  static constexpr bool kNever = false;
  Expr e_;
};

/// The force of a step that is being traced, divided by the mass: a(x, v, t).
class TracedForce {
 public:
  TracedVector operator()(const TracedVector& x, const TracedVector& v, const TracedScalar& t) const {
    return TracedVector(force(x.expression(), v.expression(), t.expression()));
  }
};

TracedScalar sqrt(const TracedScalar& s);
TracedScalar exp(const TracedScalar& s);
TracedScalar pow(const TracedScalar& base, int exponent);  ///< a product
TracedScalar pow(const TracedScalar& base, const TracedScalar& exponent);
TracedScalar max(const TracedScalar& a, const TracedScalar& b);
TracedScalar min(const TracedScalar& a, const TracedScalar& b);

}  // namespace shortfall
