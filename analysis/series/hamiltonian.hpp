// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/series/order.hpp"

namespace shortfall {

/// One term of a modified Hamiltonian: coefficient * h^power * a contraction of derivatives of the potential
/// V(x) (or V(x, t)) and of the velocity, such as V''(v, v), V' V' or V'''(V', v, v).
struct EnergyTerm {
  int power;  ///< of h
  std::string contraction;
  std::string latex;
  /// In one dimension: how often v and each derivative of V occur, [0] v, [1] V', [2] V'', ...; empty when
  /// the force reads the time.
  std::vector<int> in_one_dimension;
  Fraction coefficient;
};

/// The energy that a step conserves up to every power of h, for x'' = -V'(x) (mass 1): v^2/2 + V + h ....
///
/// A field is Hamiltonian if and only if its coefficients agree, up to sign, at all roots of a free tree.
/// Source: Hairer, Lubich & Wanner (2006), IX.9.3 and IX.10.
struct ModifiedHamiltonian {
  int order = 0;                  ///< terms up to h^(order - 1)
  std::vector<EnergyTerm> terms;  ///< without v^2/2 + V
  /// The first tree where there is none; empty when there is one.
  std::string obstruction;
  int obstructed_at = 0;  ///< the power of h in the equation

  bool exists() const { return obstruction.empty(); }
};

/// The Hamiltonian of a field of x' = v, v' = a(x) or a(x, t).
///
/// param   field  of the modified equation, sigma-normalised (OneStep::field)
template <class K>
ModifiedHamiltonian hamiltonian(const SeriesSource& source, const TreeTable& table,
                                const TreeSeries<K>& field);

/// A tree with the force at its root as a contraction of derivatives of V and velocities, without its sign.
std::string contraction(const TreeTable& table, TreeId t, bool latex = false);

/// That of a step, for a(x), up to trees of an order.
ModifiedHamiltonian modified_hamiltonian(const SeriesSource& source, int order,
                                         const OrderLimits& limits = {});

}  // namespace shortfall
