// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "analysis/algebra/lie_element.hpp"
#include "analysis/algebra/word_series.hpp"

namespace shortfall {

/// A kick v += weight h a(x), or a drift x += weight h v.
template <class Field>
struct SplittingPart {
  bool kick = false;
  Field weight;
};

/// Kicks and drifts in the order in which they are done. As an operator: the product of exp(weight h B) and
/// exp(weight h A), leftmost applied first.
template <class Field>
using SplittingParts = std::vector<SplittingPart<Field>>;

/// What undoes it: backwards, with the opposite signs.
template <class Field>
SplittingParts<Field> inverse(SplittingParts<Field> parts) {
  std::ranges::reverse(parts);
  for (SplittingPart<Field>& p : parts) p.weight = -p.weight;
  return parts;
}

/// The same kicks and drifts backwards: the inverse with -h for h.
template <class Field>
SplittingParts<Field> adjoint(SplittingParts<Field> parts) {
  std::ranges::reverse(parts);
  return parts;
}

/// One after the other.
template <class Field>
SplittingParts<Field> composed(SplittingParts<Field> first, const SplittingParts<Field>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Neighbours of one kind as one, and none of weight 0.
template <class Field>
SplittingParts<Field> merged(const SplittingParts<Field>& parts) {
  SplittingParts<Field> result;
  for (const SplittingPart<Field>& p : parts) {
    if (p.weight.is_zero()) continue;
    if (result.empty() || result.back().kick != p.kick) {
      result.push_back(p);
      continue;
    }
    result.back().weight += p.weight;
    if (result.back().weight.is_zero()) result.pop_back();
  }
  return result;
}

/// The series of the step in words of h A and h B.
template <class Field>
WordSeries<Field> word_series(const SplittingParts<Field>& parts, int degree) {
  WordSeries<Field> result(degree);
  for (const SplittingPart<Field>& p : parts) result.multiply_by_exponential(p.kick, p.weight);
  return result;
}

/// The logarithm of the step, in Lyndon brackets of h A and h B: h times the modified vector field.
///
/// source  Hairer, Lubich & Wanner (2006), Geometric Numerical Integration, III.5 and IX.4
template <class Field>
LieElement<Field> splitting_logarithm(const SplittingParts<Field>& parts, int degree) {
  return log(word_series(parts, degree));
}

}  // namespace shortfall
