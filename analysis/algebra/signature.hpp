// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// Which functions a differential equation is made of, which components they read, and how often each can be
/// differentiated: what the nodes of rooted trees may be, and what may hang from them.
///
/// Source: Hairer, Lubich & Wanner (2006), Geometric Numerical Integration, III.1 and III.2 (trees of one
/// colour and of several); Nystroem trees: Hairer, Norsett & Wanner (1993), II.14.
struct Signature {
  static constexpr int kAny = 1'000'000;  ///< differentiable as often as one likes

  struct Slot {
    int component;
    int most = kAny;  ///< derivatives of a higher order by this component vanish
  };
  struct Function {
    std::string name;
    int component;  ///< the one whose derivative it is (or a part of it)
    std::vector<Slot> reads;
    int most = kAny;  ///< derivatives of a higher total order vanish
  };
  std::vector<std::string> components;
  std::vector<Function> functions;

  /// The slot by which a function reads a component; nullptr when it does not.
  const Slot* slot(int function, int component) const;
  bool operator==(const Signature& other) const;

  static Signature first_order();            ///< y' = f(y)
  static Signature first_order_with_time();  ///< y' = f(y, t)
  static Signature additive();               ///< y' = f(y) + g(y)
  static Signature separable();              ///< q' = f(p), p' = g(q): T(p) + V(q)
  /// x' = v, v' = a(x), and of v and t as asked. Function 0 is a, function 1 the drift v, function 2 the
  /// clock t' = 1.
  static Signature mechanical(bool reads_velocity, bool reads_time);
};

/// How many rooted trees with this function at the root there are of each order 1..orders (entry 0 is 0),
/// counted without making them: the number of multisets of children.
std::vector<Rational> tree_counts(const Signature& signature, int function, int orders);

}  // namespace shortfall
