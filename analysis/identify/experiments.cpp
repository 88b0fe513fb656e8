// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/experiments.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kFrames = 60;

/// What would be recorded; empty where the map cannot do the experiment.
std::vector<double> recorded(const Candidate& candidate, const Experiment& e) {
  constexpr double kDt = 0.02, kLaunch = 5, kGravity = -9.81, kPlace = 1;
  std::vector<double> result;
  try {
    const Responses r =
        responses(frame_map(*candidate.tape, candidate.circumstances(kDt, e.c, e.k)), kFrames);
    const bool impulse = e.impulse && candidate.program->impulse;
    const auto put = [&](const Responses::Row& row) {
      result.push_back(kPlace * row[0] + (impulse ? row[3] : row[1]) * kLaunch + kGravity * row[2]);
    };
    for (std::size_t n = 0; n < kFrames; ++n) {
      put(r.position[n]);
      if (e.velocities) put(r.velocity[n]);
    }
  } catch (const Error&) {
    return {};
  }
  return result;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::fabs(a[i] - b[i]) <= 1e-9 * (1 + std::fabs(a[i])))) return false;
  return true;
}

}  // namespace

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = {
      {"an undamped fall with a launch, with velocities", 0, 0, false, true},
      {"a fall with a damping of 0.5, with velocities", 0.5, 0, false, true},
      {"an undamped spring as your own force (a = -100 x), with velocities", 0, 100, false, true},
      {"a spring as your own force (a = -100 x) with a damping of 0.5, with velocities", 0.5, 100, false,
       true},
      {"a launch by an impulse with a damping of 0.5, with velocities", 0.5, 0, true, true},
  };
  return all;
}

std::vector<int> groups(const std::vector<Candidate>& candidates, const Experiment& experiment) {
  std::vector<int> result;
  std::vector<std::vector<double>> seen;
  for (const Candidate& c : candidates) {
    const std::vector<double> motion = recorded(c, experiment);
    auto found = std::ranges::find_if(seen, [&](const auto& other) { return same(other, motion); });
    if (found == seen.end()) found = seen.insert(seen.end(), motion);
    result.push_back(static_cast<int>(found - seen.begin()));
  }
  return result;
}

std::vector<int> groups(const std::vector<Candidate>& candidates) {
  std::vector<std::vector<int>> keys(candidates.size());
  for (const Experiment& e : experiments()) {
    const std::vector<int> g = groups(candidates, e);
    for (std::size_t i = 0; i < g.size(); ++i) keys[i].push_back(g[i]);
  }
  std::map<std::vector<int>, int> numbers;
  std::vector<int> result;
  for (const auto& key : keys)
    result.push_back(numbers.emplace(key, static_cast<int>(numbers.size())).first->second);
  return result;
}

int group_count(const std::vector<int>& groups) {
  return groups.empty() ? 0 : *std::ranges::max_element(groups) + 1;
}

const Experiment* best_experiment(const std::vector<Candidate>& candidates) {
  const Experiment* best = nullptr;
  int most = 1;
  for (const Experiment& e : experiments())
    if (const int count = group_count(groups(candidates, e)); count > most) {
      most = count;
      best = &e;
    }
  return best;
}

}  // namespace shortfall
