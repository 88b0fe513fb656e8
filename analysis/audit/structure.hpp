// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/audit/method.hpp"

namespace shortfall {

/// A tree, or a pair of trees, that shows a tableau not to be symmetric (its adjoint has another
/// coefficient there), or not symplectic.
///
/// The equations for the entries are enough, and needed only of tableaus that have no stage too many; trees
/// decide about every tableau. none  when there is no such tree up to the order
///
/// source  Calvo & Sanz-Serna (1994); Hairer, Lubich & Wanner (2006), II.3 and VI.7.1, Theorem 7.1
template <class K>
std::optional<std::string> not_symmetric(const Method<K>& m, int order);
template <class K>
std::optional<std::string> not_symplectic(const Method<K>& m, int order);

}  // namespace shortfall
