// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_residuals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/residuals.hpp"
#include "notebooks-export/figure_labels.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr std::array<Ink, 5> kMatchInks{Ink::blue, Ink::green, Ink::purple, Ink::orange, Ink::vermillion};
constexpr std::size_t kMostCurves = kMatchInks.size();
constexpr std::size_t kMostResidualMarks = 300;

/// Without its folder, and short enough for a title.
std::string file_name(const std::string& path) {
  constexpr std::size_t kMost = 34;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.size() <= kMost ? name : name.substr(0, kMost - 3) + "...";
}

/// Powers of a thousand below a metre.
struct ResidualScale {
  double factor = 1;
  std::string unit;
};

ResidualScale scale_for(double largest, const Log& log) {
  if (log.unit != "m") return {1, log.unit};
  if (!(largest > 0)) return {1e3, "mm"};
  double factor = 1;
  for (const char* unit : {"m", "mm", "µm", "nm", "pm"}) {
    if (largest * factor >= 1) return {factor, unit};
    factor *= 1000;
  }
  return {1e15, "fm"};
}

/// The component that is missed most, row by row.
double shown(const Residual& r) {
  return *std::ranges::max_element(r.missing, {}, [](double x) { return std::fabs(x); });
}

Figure::Panel panel(const Log& log, const Identification& found, const std::vector<const Match*>& matches) {
  Figure::Panel p;
  std::vector<std::vector<Residual>> rows;
  double largest = 0, end = 0;
  for (const Match* m : matches) {
    rows.push_back(residuals(log, found, *m));
    for (const Residual& r : rows.back()) largest = std::max(largest, std::fabs(shown(r)));
    if (!rows.back().empty()) end = std::max(end, rows.back().back().time);
  }
  const ResidualScale scale = scale_for(largest, log);
  p.x.label = "time";
  p.x.unit = "s";
  p.y.label = "recorded minus computed";
  p.y.unit = scale.unit;
  const double half = log.position_rounding.exact() ? 0 : log.position_rounding.half(0) * scale.factor;
  const double top = std::max(largest * scale.factor, half);
  p.y.high = top > 0 ? rounded_up(1.05 * top) : 1;
  p.y.low = -p.y.high;
  p.x.low = 0;
  p.x.high = end * 1.4;
  if (half > 0) p.regions.push_back({{{{0, -half}, {end, -half}, {end, half}, {0, half}}}, Ink::sky, 0.25});
  std::vector<Figure::Label> names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Figure::Path path;
    for (const Residual& r : rows[i]) path.push_back({r.time, scale.factor * shown(r)});
    if (path.empty()) continue;
    if (path.size() <= kMostResidualMarks)
      for (const Figure::Point& at : path) p.marks.push_back({at, kMatchInks[i]});
    names.push_back({{end * 1.02, path.back().y}, matches[i]->candidate.str(), kMatchInks[i]});
    p.curves.push_back({{std::move(path)}, kMatchInks[i], 1, false});
  }
  place_apart(p, std::move(names));
  return p;
}

}  // namespace

Figure residual_figure(const Log& log, const Identification& found) {
  std::vector<const Match*> listed, refuted;
  std::set<int> groups;
  for (const Match& m : found.matches)
    if (listed.size() < kMostCurves && groups.insert(m.group).second) listed.push_back(&m);
  for (const Match& m : found.nearest)
    if (refuted.size() < kMostCurves) refuted.push_back(&m);
  Figure figure;
  figure.title = "What is left of " + file_name(log.file);
  if (!listed.empty()) {
    figure.panels.push_back(panel(log, found, listed));
    figure.panels.back().title = "Maps that reproduce it";
    figure.panels.back().note =
        log.position_rounding.exact() ? "0 everywhere: every bit" : "blue: the rounding of the log";
  }
  if (!refuted.empty()) {
    figure.panels.push_back(panel(log, found, refuted));
    figure.panels.back().title = "The nearest of the others";
    figure.panels.back().note = "what is left has a shape: refuted";
  }
  if (figure.panels.empty()) throw Unable("no map was held against this log, so there is nothing to draw");
  return figure;
}

}  // namespace shortfall
