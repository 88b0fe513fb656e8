// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/trees.hpp"

namespace shortfall {

/// The elementary differential of a tree as a person writes it: f'f'f, f''(f, f), a_x a, a_xv(v, a), a_t.
std::string differential(const TreeTable& table, TreeId t, bool latex = false);

/// The tree itself: a node's function, its children in brackets: f[f, f[f]].
std::string tree_text(const TreeTable& table, TreeId t);

}  // namespace shortfall
