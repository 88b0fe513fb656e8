// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_portrait.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "notebooks-export/figure_contour.hpp"
#include "notebooks-export/figure_labels.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr int kGrid = 241;
constexpr std::size_t kMostDots = 2000;  // of a motion; more are one smear

/// A little more than what the motions need.
void fit(Figure::Axis& axis, const std::vector<std::vector<double>>& values) {
  double low = 0, high = 0;
  for (const std::vector<double>& row : values)
    for (const double value : row) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  const double margin = std::max(0.12 * (high - low), 1e-9);
  axis.low = low - margin;
  axis.high = high + margin;
}

Figure::Panel plane(const Portrait& p, EnergySurfaces& surfaces) {
  const bool modified = p.hamiltonian.exists();
  Figure::Panel panel;
  panel.title = "Phase portrait";
  panel.note = modified ? "dots: the steps; green: modified energy; grey, dashed: true energy"
                        : "dots: the steps; grey, dashed: true energy";
  panel.x = {"x", "m", 0, 1};
  panel.y = {"v", "m/s", 0, 1};
  std::vector<std::vector<double>> xs, vs;
  for (const PortraitOrbit& o : p.orbits) {
    xs.push_back(o.x);
    vs.push_back(o.v);
  }
  fit(panel.x, xs);
  fit(panel.y, vs);
  Grid grid{panel.x.low, panel.x.high, panel.y.low, panel.y.high, kGrid, kGrid, {}};
  Grid other = grid;
  grid.values.resize(std::size_t{kGrid} * kGrid);
  other.values.resize(grid.values.size());
  for (int column = 0; column < kGrid; ++column)
    for (int row = 0; row < kGrid; ++row) {
      const auto at = static_cast<std::size_t>(row * kGrid + column);
      const EnergySurfaces::Values e = surfaces.at(grid.x(column), grid.y(row));
      grid.values[at] = std::isfinite(e.energy) ? e.energy : 1e300;
      other.values[at] = std::isfinite(e.modified) ? e.modified : 1e300;
    }
  for (const PortraitOrbit& o : p.orbits) {
    panel.curves.push_back({level_region(grid, o.energy.front()).lines, Ink::grey, 1.5, true});
    if (modified)
      panel.curves.push_back({level_region(other, o.modified.front()).lines, Ink::green, 2, false});
  }
  for (const PortraitOrbit& o : p.orbits) {
    const std::size_t every = o.x.size() / kMostDots + 1;
    for (std::size_t n = 0; n < o.x.size(); n += every)
      panel.marks.push_back({{o.x[n], o.v[n]}, Ink::blue, 0.6});
  }
  return panel;
}

Figure::Path change(const std::vector<double>& values, double h) {
  Figure::Path path;
  for (std::size_t n = 0; n < values.size(); ++n)
    path.push_back({static_cast<double>(n) * h, values[n] - values.front()});
  return path;
}

Figure::Panel drift(const Portrait& p) {
  const bool modified = p.hamiltonian.exists();
  const double h = p.question.h.to_double();
  Figure::Panel panel;
  panel.title = "Energy less that at the start";
  panel.note = modified ? "blue: true energy; green: modified energy" : "blue: true energy; mass 1";
  panel.x = {"time", "s", 0, h * p.question.steps};
  panel.y = {"change of energy", "J/kg", 0, 0};
  double low = 0, high = 0;
  for (const PortraitOrbit& o : p.orbits) {
    panel.curves.push_back({{change(o.energy, h)}, Ink::blue, 1.2, false});
    if (modified) panel.curves.push_back({{change(o.modified, h)}, Ink::green, 1.8, false});
    for (const Figure::Curve& c : panel.curves)
      for (const Figure::Point& point : c.paths[0]) {
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
  }
  if (low == high) low = -1, high = 1;
  panel.y.low = low < 0 ? -rounded_up(-1.05 * low) : 0;
  panel.y.high = high > 0 ? rounded_up(1.05 * high) : 0;
  return panel;
}

}  // namespace

Figure portrait_figure(const Portrait& p, EnergySurfaces surfaces) {
  Figure figure;
  figure.title = p.integrator + ", dt = " + p.question.h.str() + " s";
  figure.panels = {plane(p, surfaces), drift(p)};
  return figure;
}

}  // namespace shortfall
