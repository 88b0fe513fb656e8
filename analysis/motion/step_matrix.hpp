// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/motion/numeric_motion.hpp"
#include "analysis/motion/step_map.hpp"

namespace shortfall {

/// One step in numbers as a matrix: z(n+1) = step z(n), where z holds the carried vectors and, for a force of
/// time, the binomial coefficients (n choose 0), ..., (n choose D) of the step count.
///
/// Binomials instead of powers of n: the next ones are sums of two, and no denominators come in. Entries are
/// rational, or contain roots, exp and pow as letters (see `map`), which need the NumberField of the
/// map's generators to be open.
struct StepMatrix {
  StepMap map;
  std::vector<std::vector<Fraction>> step;
  std::vector<Fraction> start;  ///< z(0)
  std::vector<Fraction> position;
  std::vector<Fraction> velocity;

  int size() const { return static_cast<int>(step.size()); }
  /// Whether no letter occurs.
  bool rational() const;
};

/// param   question  of which force (the true one), parameters, substeps, h, x0 and v0 are looked at; the
///                   force's letters must have numbers
/// throws  Unable  when coefficients of the step depend on t;  Undefined  when a stage is singular
StepMatrix step_matrix(const Program& program, const NumericQuestion& question);

}  // namespace shortfall
