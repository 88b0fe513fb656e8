// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analysis/stability/windows.hpp"

namespace shortfall {

/// Windows from what is decided at every critical value and once between any two of them, from 0 upwards.
///
/// param   roots   the critical values, positive and in increasing order, in intervals that do not touch
/// param   edge    what happens at the critical value of this index
/// param   inside  how the powers grow at a number that is no critical value
Windows walked(const std::vector<RealRoot>& roots, const std::function<WindowEdge(std::size_t)>& edge,
               const std::function<PowerGrowth(const Rational&)>& inside);

}  // namespace shortfall
