// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

namespace shortfall {

/// a + b e1 + c e2 + d e1 e2 + ..., the e being numbers whose squares are 0: the coefficient of e1 e2 ... ek
/// of f(x + e1 u1 + ... + ek uk) is the kth derivative of f in the directions u1, ..., uk.
///
/// part(s) belongs to the product of those e whose bit is set in s.
template <class T>
class Nilpotent {
 public:
  Nilpotent() = default;
  Nilpotent(int directions, const T& value) : parts_(std::size_t{1} << directions, value - value) {
    parts_[0] = value;
  }

  T& part(std::size_t s) { return parts_[s]; }
  const T& part(std::size_t s) const { return parts_[s]; }
  std::size_t size() const { return parts_.size(); }

  Nilpotent operator-() const {
    Nilpotent r = *this;
    for (T& p : r.parts_) p = -p;
    return r;
  }
  friend Nilpotent operator+(Nilpotent a, const Nilpotent& b) {
    for (std::size_t s = 0; s < a.size(); ++s) a.parts_[s] = a.parts_[s] + b.parts_[s];
    return a;
  }
  friend Nilpotent operator-(Nilpotent a, const Nilpotent& b) {
    for (std::size_t s = 0; s < a.size(); ++s) a.parts_[s] = a.parts_[s] - b.parts_[s];
    return a;
  }
  friend Nilpotent operator*(const Nilpotent& a, const Nilpotent& b) {
    Nilpotent r = a;
    for (std::size_t s = 0; s < a.size(); ++s) {
      T sum = a.parts_[0] * b.parts_[s];
      for (std::size_t u = s; u != 0; u = (u - 1) & s) sum = sum + a.parts_[u] * b.parts_[s ^ u];
      r.parts_[s] = sum;
    }
    return r;
  }
  friend Nilpotent operator/(const Nilpotent& a, const Nilpotent& b) {
    Nilpotent r = a;
    for (std::size_t s = 0; s < a.size(); ++s) {
      T rest = a.parts_[s];
      for (std::size_t u = s; u != 0; u = (u - 1) & s) rest = rest - b.parts_[u] * r.parts_[s ^ u];
      r.parts_[s] = rest / b.parts_[0];
    }
    return r;
  }

  /// f(a) from the derivatives f, f', f'', ... at its value: as many as it has directions, and one.
  Nilpotent composed(const std::vector<T>& derivatives) const {
    // The sum of f^(k) n^k / k!, where n is the nilpotent part.
    Nilpotent n = *this;
    n.parts_[0] = parts_[0] - parts_[0];
    Nilpotent result = constant(derivatives[0]), power = constant(derivatives[0] - derivatives[0] + one());
    T factorial = one();
    for (std::size_t k = 1; k < derivatives.size(); ++k) {
      power = power * n;
      T whole = one();
      for (std::size_t i = 1; i < k; ++i) whole = whole + one();
      factorial = factorial * whole;
      for (std::size_t s = 0; s < size(); ++s)
        result.parts_[s] = result.parts_[s] + derivatives[k] / factorial * power.parts_[s];
    }
    return result;
  }

 private:
  static T one() { return T(1.0); }
  Nilpotent constant(const T& value) const {
    Nilpotent r = *this;
    for (T& p : r.parts_) p = value - value;
    r.parts_[0] = value;
    return r;
  }

  std::vector<T> parts_;
};

/// How many directions.
template <class T>
std::size_t degree(const Nilpotent<T>& a) {
  std::size_t d = 0;
  while ((std::size_t{1} << d) < a.size()) ++d;
  return d;
}

template <class T>
Nilpotent<T> exp(const Nilpotent<T>& a) {
  return a.composed(std::vector<T>(degree(a) + 1, exp(a.part(0))));
}

template <class T>
Nilpotent<T> sin(const Nilpotent<T>& a) {
  const T s = sin(a.part(0)), c = cos(a.part(0));
  std::vector<T> d;
  for (std::size_t k = 0; k <= degree(a); ++k)
    d.push_back(k % 4 == 0 ? s : k % 4 == 1 ? c : k % 4 == 2 ? -s : -c);
  return a.composed(d);
}

template <class T>
Nilpotent<T> cos(const Nilpotent<T>& a) {
  const T s = sin(a.part(0)), c = cos(a.part(0));
  std::vector<T> d;
  for (std::size_t k = 0; k <= degree(a); ++k)
    d.push_back(k % 4 == 0 ? c : k % 4 == 1 ? -s : k % 4 == 2 ? -c : s);
  return a.composed(d);
}

/// value^exponent, whose value is given: r x^(r-1), r (r-1) x^(r-2), ...
template <class T>
Nilpotent<T> with_power(const Nilpotent<T>& a, const T& exponent, const T& value) {
  std::vector<T> d{value};
  T r = exponent;
  for (std::size_t k = 1; k <= degree(a); ++k) {
    d.push_back(d.back() * r / a.part(0));
    r = r - T(1.0);
  }
  return a.composed(d);
}

template <class T>
Nilpotent<T> sqrt(const Nilpotent<T>& a) {
  return with_power(a, T(0.5), T(sqrt(a.part(0))));
}

template <class T>
Nilpotent<T> log(const Nilpotent<T>& a) {
  std::vector<T> d{log(a.part(0))};
  T next = T(1.0) / a.part(0);
  for (std::size_t k = 1; k <= degree(a); ++k) {
    d.push_back(next);
    next = -(next * T(static_cast<double>(k)) / a.part(0));
  }
  return a.composed(d);
}

template <class T>
Nilpotent<T> abs(const Nilpotent<T>& a) {
  return a.part(0) < T(0.0) ? -a : a;
}

}  // namespace shortfall
