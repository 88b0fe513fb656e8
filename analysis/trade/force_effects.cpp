// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/advice.hpp"

namespace shortfall {

namespace {

/// The changes of all observables when only the chosen forces act; empty with the reason when one has no
/// value.
std::vector<double> changes(const Scene& scene, const SceneReference& reference, const ForceChoice& chosen,
                            std::string& why) {
  try {
    const SceneReference other = scene_reference(scene, 30, chosen, {}, reference.end);
    std::vector<double> result;
    for (std::size_t i = 0; i < scene.observables.size(); ++i)
      // Every true motion keeps its energy.
      result.push_back(scene.observables[i].kind == SceneObservable::Kind::energy_drift
                           ? 0
                           : std::fabs(reading_error(scene, i, reference.readings[i], other.readings[i])));
    return result;
  } catch (const Error& e) {
    why = e.what();
    return {};
  }
}

double share_of(const Scene& scene, const std::vector<double>& change) {
  if (change.empty()) return INFINITY;
  double largest = 0;
  for (std::size_t i = 0; i < change.size(); ++i)
    largest = std::max(largest, change[i] / scene.observables[i].tolerance.to_double());
  return largest;
}

}  // namespace

std::vector<ForceEffect> force_effects(const Scene& scene, const SceneReference& reference, double share,
                                       ForceChoice& kept, std::vector<double>& dropped,
                                       const Progress& progress) {
  const std::size_t count = scene.forces.size();
  kept.assign(count, true);
  dropped.assign(scene.observables.size(), 0);
  std::vector<ForceEffect> effects;
  for (std::size_t f = 0; f < count; ++f) {
    if (progress)
      progress("leaving out one force after the other", static_cast<int>(f), static_cast<int>(count));
    ForceEffect effect{scene.forces[f].name, {}, {}};
    ForceChoice without(count, true);
    without[f] = false;
    effect.changes = changes(scene, reference, without, effect.without);
    effects.push_back(std::move(effect));
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return share_of(scene, effects[a].changes) < share_of(scene, effects[b].changes);
  });
  for (std::size_t f : order) {
    if (share_of(scene, effects[f].changes) > share) break;
    // What an engine does by itself costs nothing and is not ours to leave out.
    if (scene.forces[f].by_engine) continue;
    ForceChoice fewer = kept;
    fewer[f] = false;
    if (std::ranges::none_of(fewer, [](bool is_kept) { return is_kept; })) break;
    std::string why;
    const std::vector<double> together = changes(scene, reference, fewer, why);
    if (share_of(scene, together) > share) continue;
    kept = fewer;
    dropped = together;
    effects[f].dropped = true;
  }
  return effects;
}

}  // namespace shortfall
