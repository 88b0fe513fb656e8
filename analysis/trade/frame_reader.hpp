// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/trade/reference.hpp"

namespace shortfall {

struct SceneOutcome;

/// Reads the observables of a scene off the frames of a run, whoever steps it, and holds them to the true
/// ones.
class FrameReader {
 public:
  /// param  longest  the longest time between two frames
  FrameReader(const Scene& scene, const SceneReference& reference, double longest);

  /// false when the frame is not finite (or beyond 1e100, where squares overflow).
  bool frame(const DoubleDouble& t, const std::vector<DoubleDouble>& x, const std::vector<DoubleDouble>& v);
  bool is_done() const { return observer_.is_done(); }
  /// The errors; or the failure, when an observable has no value.
  void finish(SceneOutcome& outcome) const;

 private:
  const Scene& scene_;
  const SceneReference& reference_;
  TaylorFlow<DoubleDouble> flow_;
  SceneObserver<DoubleDouble> observer_;
};

/// Where a scene begins: the positions, or the velocities.
std::vector<DoubleDouble> initial_positions(const Scene& scene);
std::vector<DoubleDouble> initial_velocities(const Scene& scene);

}  // namespace shortfall
