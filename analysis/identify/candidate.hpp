// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/identify/frame_map.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// An integrator with everything fixed but the numbers that a log must tell: one map of the family.
struct Candidate {
  const Program* program = nullptr;
  std::shared_ptr<const Tape> tape;
  Values fixed;               ///< parameters that are not the default: N, flags
  std::optional<int> counts;  ///< the value of the integrator's own number of substeps
  int substeps = 1;           ///< whole steps in a frame, of integrators that count none themselves
  bool own_damping = false;   ///< it has a parameter c; otherwise a drag is a force

  const std::string& name() const { return program->name; }
  int substep_count() const { return counts.value_or(substeps); }
  /// "jolt, N = 2", "symplectic-euler, 4 substeps", "mujoco-euler, d = 0".
  std::string str() const;
  /// A frame of it under a damping number and a spring.
  Circumstances circumstances(double dt, double c, double k) const;
};

/// Every integrator of the catalogue, engines included, with each number of substeps that it may have.
const std::vector<Candidate>& known_candidates();
std::vector<Candidate> candidates_of(const Program& program);

/// One of them: with a number of substeps, otherwise the default.
Candidate candidate(const Program& program, std::optional<int> substeps, const Values& values = {});

}  // namespace shortfall
