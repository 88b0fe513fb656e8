// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/tree_series.hpp"
#include "analysis/problems/smooth_force.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// One step of an integrator for every smooth force, as a map of (x, v, t).
///
/// An integrator that carries states of its own, or that starts and finishes in a special way, has an
/// underlying one-step method: the map of what it reports from step to step, once what the start got wrong
/// has died out. Source: Kirchgraber (1986), Multi-step methods are essentially one-step methods; Hairer,
/// Lubich & Wanner (2006), XV.2.
template <class K>
struct OneStep {
  TreeSeries<K> map;    ///< of the one-step method
  TreeSeries<K> field;  ///< its logarithm: h times the modified equation
  /// What the start puts instead of the states that belong to (x0, v0), seen as a change of x0 and v0.
  TreeSeries<K> start;
  bool carries = false;  ///< states, or a start or finish: the above are not just one run of the step
};

/// Runs the step of a tape in the trees of a table.
///
/// throws  Unable     when the step does not move a free body along a line at its velocity (no order at all),
///                    or when its own states are not determined by x and v
///         Undefined  when a stage is singular
template <class K>
OneStep<K> one_step(const Tape& tape, SmoothForce<K>& problem, const TreeTable& table);

}  // namespace shortfall

#include "analysis/series/one_step_impl.hpp"
