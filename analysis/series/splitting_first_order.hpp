// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/series/splitting_parts.hpp"

namespace shortfall {

/// A splitting for A + eps B, to first order in eps: drifts along a dominant motion, kicks by a small
/// perturbation.
///
/// The product of the exponentials is (1 + eps k(x) B) exp(s A) and its logarithm s A + eps l(x) B, where x
/// is ad A; so no degree is too high. Shape: k and l lowest power first, as many entries as asked for.
template <class Field>
struct FirstOrderInKick {
  Field drift;                   ///< s
  std::vector<Field> kick;       ///< k: the sum of weight * exp(covered * x) over the kicks
  std::vector<Field> logarithm;  ///< l = k s x / (exp(s x) - 1)
};

/// source  Wisdom, Holman & Touma (1996), Symplectic correctors; Laskar & Robutel (2001), High order
/// symplectic integrators for perturbed Hamiltonian systems, section 3
template <class Field>
FirstOrderInKick<Field> first_order_in_kick(const SplittingParts<Field>& parts, int powers) {
  if (powers < 1) throw Error("a series needs at least one coefficient");
  const auto size = static_cast<std::size_t>(powers);
  FirstOrderInKick<Field> result{Field(0), std::vector<Field>(size, Field(0)), {}};
  for (const SplittingPart<Field>& p : parts) {
    if (!p.kick) {
      result.drift += p.weight;
      continue;
    }
    Field term = p.weight;
    for (std::size_t k = 0; k < size; ++k) {
      result.kick[k] += term;
      term *= result.drift / Field(static_cast<int>(k) + 1);
    }
  }
  // l * (1 + s x / 2! + (s x)^2 / 3! + ...) = k, from the lowest power up.
  std::vector<Field> divisor{Field(1)};
  for (std::size_t k = 1; k < size; ++k)
    divisor.push_back(divisor.back() * result.drift / Field(static_cast<int>(k) + 1));
  for (std::size_t k = 0; k < size; ++k) {
    Field value = result.kick[k];
    for (std::size_t j = 0; j < k; ++j) value -= result.logarithm[j] * divisor[k - j];
    result.logarithm.push_back(std::move(value));
  }
  return result;
}

}  // namespace shortfall
