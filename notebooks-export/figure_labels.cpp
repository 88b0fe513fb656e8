// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_labels.hpp"

#include <algorithm>
#include <cmath>

namespace shortfall {

double rounded_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double m : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (m * power >= value) return m * power;
  return 10 * power;
}

void place_apart(Figure::Panel& panel, std::vector<Figure::Label> labels) {
  std::ranges::sort(labels, [](const auto& a, const auto& b) { return a.at.y < b.at.y; });
  const double line = (panel.y.high - panel.y.low) / 22;
  for (std::size_t i = 1; i < labels.size(); ++i)
    labels[i].at.y = std::max(labels[i].at.y, labels[i - 1].at.y + line);
  for (Figure::Label& l : labels) panel.labels.push_back(std::move(l));
}

}  // namespace shortfall
