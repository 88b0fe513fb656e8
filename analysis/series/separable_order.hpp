// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/series/order.hpp"
#include "analysis/series/splitting_parts.hpp"

namespace shortfall {

/// q' = f(p), p' = g(q): every T(p) + V(q), where x' = v of the other classes has T = p^2/2. Trees whose
/// nodes f and g alternate; there are more of them than with f(p) = p, so that Nystroem splittings lose order
/// here.
const ForceClass& separable_forces();

/// Drifts q += w h f(p) and kicks p += w h g(q), one after the other, as a series of Signature::separable().
///
/// Source: Hairer, Lubich & Wanner (2006), III.2.1 (bicoloured trees) and III.2.2 (partitioned methods).
template <class K>
TreeSeries<K> separable_series(const TreeTable& table, const std::vector<SplittingPart<K>>& parts);

struct SeparableOrder {
  std::optional<OrderOfClass> order;
  std::string why_not;  ///< a sentence, when there is none
};

/// Of a step of kicks and drifts, however it is written, or of a tableau (which has the order that it has for
/// y' = f(y): every rooted tree is one with alternating nodes).
SeparableOrder separable_order(const SeriesSource& source, const OrderLimits& limits = {});

}  // namespace shortfall
