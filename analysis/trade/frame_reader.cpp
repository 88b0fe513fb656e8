// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/frame_reader.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/trade/scene_run.hpp"

namespace shortfall {

namespace {

TaylorFlow<DoubleDouble> between_frames(const Scene& scene, double longest) {
  TaylorFlow<DoubleDouble>::Settings settings;
  settings.order = 18;
  settings.tolerance = 1e-26;
  settings.longest = std::max((scene.until / Rational(2)).to_double(), longest);
  settings.number = double_double;
  return {acceleration_tape(scene), settings};
}

std::vector<DoubleDouble> initial(const Scene& scene, std::vector<Rational> SceneBody::*part) {
  std::vector<DoubleDouble> result;
  for (const SceneBody& b : scene.bodies)
    for (const Rational& c : b.*part) result.push_back(double_double(c));
  return result;
}

bool is_in_range(const std::vector<DoubleDouble>& values) {
  return std::ranges::all_of(values, [](const DoubleDouble& d) { return std::fabs(d.high()) < 1e100; });
}

}  // namespace

std::vector<DoubleDouble> initial_positions(const Scene& scene) {
  return initial(scene, &SceneBody::position);
}
std::vector<DoubleDouble> initial_velocities(const Scene& scene) {
  return initial(scene, &SceneBody::velocity);
}

FrameReader::FrameReader(const Scene& scene, const SceneReference& reference, double longest)
    : scene_(scene),
      reference_(reference),
      flow_(between_frames(scene, longest)),
      observer_(scene, flow_, double_double, reference.end) {}

bool FrameReader::frame(const DoubleDouble& t, const std::vector<DoubleDouble>& x,
                        const std::vector<DoubleDouble>& v) {
  if (!is_in_range(x) || !is_in_range(v)) return false;
  observer_.frame(t, x, v);
  return true;
}

void FrameReader::finish(SceneOutcome& outcome) const {
  const std::vector<SceneReading<DoubleDouble>> seen = observer_.readings();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].found) {
      outcome.failed = true;
      outcome.why = scene_.observables[i].name + ": " + seen[i].why;
      outcome.errors.clear();
      return;
    }
    outcome.errors.push_back(reading_error(scene_, i, reference_.readings[i], seen[i]));
  }
}

}  // namespace shortfall
