// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/suggest.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/algebra/characters.hpp"

namespace shortfall {

namespace {

/// What people write in their own code, and what the language calls it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 25> kHabits{
    {{"dt", "h"},
     {"delta", "h"},
     {"deltaTime", "h"},
     {"delta_time", "h"},
     {"timestep", "h"},
     {"step", "h"},
     {"g", "a"},
     {"gravity", "a"},
     {"acc", "a"},
     {"accel", "a"},
     {"acceleration", "a"},
     {"force", "a"},
     {"time", "t"},
     {"vel", "v"},
     {"velocity", "v"},
     {"pos", "x"},
     {"position", "x"},
     {"y", "x"},
     {"p", "x"},
     {"g", "a(x, v, t)"},
     {"gravity", "a(x, v, t)"},
     {"acc", "a(x, v, t)"},
     {"accel", "a(x, v, t)"},
     {"acceleration", "a(x, v, t)"},
     {"force", "a(x, v, t)"}}};

/// Optimal string alignment distance: insertions, deletions, substitutions, swaps of neighbours.
int distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  for (const std::string& candidate : candidates)
    if (candidate != word && lower_case(candidate) == lower_case(word)) return candidate;
  std::string best;
  int least = std::max<int>(1, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > 64 || word.size() > 64) continue;
    const int d = distance(word, candidate);
    if (d < least && d < static_cast<int>(std::max(word.size(), candidate.size()))) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  for (const auto& [habit, ours] : kHabits)
    if (habit == word && std::ranges::find(candidates, ours) != candidates.end()) best = ours;
  if (best.empty()) best = nearest(word, candidates);
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

}  // namespace shortfall
