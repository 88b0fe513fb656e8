// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall {

/// A product of powers of length L and time T.
struct Dimension {
  int length = 0;
  int time = 0;

  bool operator==(const Dimension&) const = default;
  friend Dimension operator*(Dimension a, Dimension b) { return {a.length + b.length, a.time + b.time}; }
  friend Dimension operator/(Dimension a, Dimension b) { return {a.length - b.length, a.time - b.time}; }
  Dimension pow(int exponent) const { return {length * exponent, time * exponent}; }

  /// As a person writes it in a declaration: "L/T^2", "1/T", "1".
  std::string str() const;
  /// As an error message shows it: "[L T^-2]", "[1]".
  std::string bracketed() const;
};

inline constexpr Dimension kPure{0, 0};
inline constexpr Dimension kTime{0, 1};
inline constexpr Dimension kLength{1, 0};
inline constexpr Dimension kVelocity{1, -1};
inline constexpr Dimension kAcceleration{1, -2};

enum class Sort { scalar, vector };

/// What a value is: its sort and its dimension.  The literal 0 fits every type.
struct Type {
  Sort sort = Sort::scalar;
  Dimension dimension;
  bool zero = false;

  bool same_as(const Type& o) const { return sort == o.sort && dimension == o.dimension; }
  /// "vector [L T^-1]".
  std::string str() const;
};

}  // namespace shortfall
