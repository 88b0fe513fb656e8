// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/trade/scene_run.hpp"

namespace shortfall {

/// What a force does to the observables: how much they change when it is left out of the true motion.
struct ForceEffect {
  std::string name;
  std::vector<double> changes;  ///< of each observable, absolute; empty when the motion without it has none
  std::string without;          ///< then: why
  bool dropped = false;
};

/// The error of one observable of the advice: exact minus computed is the sum of the parts for an observable
/// that is one number; for places and paths each part is a distance.
struct AdviceError {
  double total = 0;      ///< against the true motion of the whole scene
  double modelling = 0;  ///< by the forces that are dropped
  double method = 0;     ///< of the same steps in pairs of binary64 (106 bits)
  double rounding = 0;   ///< what the format adds
};

struct AdviceQuestion {
  double margin = 2;                       ///< errors are at most the tolerance over this
  double modelling_share = 0.1;            ///< of a tolerance, that dropped forces may use up
  std::vector<std::string> integrators{};  ///< to choose from; empty: a usual choice
  int repeats = 10;                        ///< of time measurements
};

/// The cheapest thing that is good enough.
struct Advice {
  Scene scene;
  SceneReference reference;
  double margin = 2;
  std::vector<ForceEffect> effects;
  ForceChoice kept;                  ///< the forces to model
  std::vector<double> dropped;       ///< what all dropped ones together change, per observable
  std::optional<SceneOutcome> best;  ///< stepped with the kept forces, held to the whole scene
  std::vector<AdviceError> errors;   ///< of the best
  std::vector<SceneOutcome>
      considered;  ///< of each way of stepping the cheapest within the tolerances, cheapest first
  std::optional<SceneOutcome>
      naive;  ///< the scene's naive integrator with the longest step that is good enough
  std::optional<SceneOutcome> closest;  ///< when nothing meets the tolerances: what comes nearest
  int tried = 0;                        ///< runs
};

/// throws  as scene_reference
Advice advise(const Scene& scene, const AdviceQuestion& question, const Progress& progress = {});

/// Of an outcome, the largest error over its tolerance.
double worst_share(const Scene& scene, const SceneOutcome& outcome);

/// What forces do, and which can be left out: those that change the observables least, as long as all of them
/// together use up no more than a share of any tolerance.
std::vector<ForceEffect> force_effects(const Scene& scene, const SceneReference& reference, double share,
                                       ForceChoice& kept, std::vector<double>& dropped,
                                       const Progress& progress);

}  // namespace shortfall
