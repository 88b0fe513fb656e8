// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "analysis/trade/scene_run.hpp"

namespace shortfall {

/// Why a scene cannot be stepped many times side by side; nothing when it can: one coordinate, no force held
/// over a frame, an integrator with lanes, f32 or f64, no launch.
std::optional<std::string> why_no_lanes(const Scene& scene, const StepChoice& choice);

/// One scene many times, side by side in the lanes of native_many: what a step costs a trajectory when there
/// are many of them. Each has the bits that SceneStepping would give it.
class SceneLanes {
 public:
  /// param   count  how many; their starts differ in the last places, so that none is computed twice
  /// throws  Unable  with why_no_lanes
  SceneLanes(const Scene& scene, const StepChoice& choice, int count);
  ~SceneLanes();
  SceneLanes(SceneLanes&&) noexcept;

  /// So many frames of all of them from the start.
  void run(std::int64_t frames);
  /// Position and velocity of one after that; the first starts where the scene does.
  std::pair<double, double> state(int index) const;

 private:
  struct Machine;
  template <class S>
  struct MachineOf;
  std::unique_ptr<Machine> machine_;
};

}  // namespace shortfall
