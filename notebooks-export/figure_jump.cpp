// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_jump.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr std::array<Ink, 5> kInks{Ink::vermillion, Ink::blue, Ink::green, Ink::purple, Ink::orange};
constexpr int kFine = 200;         // points of a smooth curve
constexpr int kMostFrames = 2000;  // beyond that there is no picture
constexpr int kMostMarks = 60;     // beyond that frames are a line

std::string rate_text(const Rational& dt) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g Hz", 1 / dt.to_double());
  return text.data();
}

/// A round number above.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double m : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (m * power >= value) return m * power;
  return 10 * power;
}

/// Names at the right end, apart by at least a line.
void place(Figure::Panel& panel, std::vector<Figure::Label> labels) {
  std::ranges::sort(labels, [](const auto& a, const auto& b) { return a.at.y < b.at.y; });
  const double line = (panel.y.high - panel.y.low) / 22;
  for (std::size_t i = 1; i < labels.size(); ++i)
    labels[i].at.y = std::max(labels[i].at.y, labels[i - 1].at.y + line);
  for (Figure::Label& l : labels) panel.labels.push_back(std::move(l));
}

}  // namespace

Figure jump_figure(const std::vector<Flight>& flights, const Rational& height, const Rational& g) {
  const Surd launch = Surd::sqrt(Rational(2) * g * height);
  const double u = launch.to_double(), fall = g.to_double(), end = 2 * u / fall;
  Figure figure;
  if (!flights.empty()) figure.title = flights.front().program().name + ": a jump, frame by frame";
  Figure::Panel arcs, errors;
  arcs.title = "Height";
  arcs.note = "black: the true parabola; dots: frames";
  errors.title = "Shortfall";
  errors.note = "exact minus computed: positive is too low";
  arcs.x.label = errors.x.label = "time";
  arcs.x.unit = errors.x.unit = "s";
  arcs.y.label = "height";
  arcs.y.unit = "m";
  errors.y.label = "shortfall";
  errors.y.unit = "cm";
  Figure::Path parabola;
  for (int i = 0; i <= kFine; ++i) {
    const double t = end * i / kFine;
    parabola.push_back({t, u * t - fall * t * t / 2});
  }
  arcs.curves.push_back({{parabola}, Ink::black, 2, false});
  double worst = 0, best = 0, top = height.to_double(), bottom = 0;
  std::vector<Figure::Label> names, error_names;
  for (std::size_t f = 0; f < flights.size(); ++f) {
    const Flight& flight = flights[f];
    const Ink ink = kInks[f % kInks.size()];
    const double dt = flight.dt().to_double();
    const auto last = static_cast<std::int64_t>(std::floor(end / dt * (1 + 1e-12)));
    if (last > kMostFrames)
      throw Unable("a picture of " + std::to_string(last) + " frames shows nothing; up to " +
                   std::to_string(kMostFrames) + " are drawn");
    Figure::Path path, shortfall;
    for (std::int64_t n = 0; n <= last; ++n) {
      const Rational time = flight.dt() * Rational(n);
      const Surd computed = flight.height(launch, g, Rational(n));
      const Surd exact = launch * Surd(time) - Surd(g * time * time / Rational(2));
      const double t = time.to_double(), x = computed.to_double(), s = 100 * (exact - computed).to_double();
      path.push_back({t, x});
      shortfall.push_back({t, s});
      worst = std::max(worst, s);
      best = std::min(best, s);
      top = std::max(top, x);
      bottom = std::min(bottom, x);
      if (last <= kMostMarks) {
        arcs.marks.push_back({path.back(), ink});
        errors.marks.push_back({shortfall.back(), ink});
      }
    }
    arcs.curves.push_back({{path}, ink, 1, false});
    errors.curves.push_back({{shortfall}, ink, 1.5, false});
    names.push_back({{path.back().x + end * 0.03, path.back().y}, rate_text(flight.dt()), ink});
    error_names.push_back(
        {{shortfall.back().x + end * 0.03, shortfall.back().y}, rate_text(flight.dt()), ink});
  }
  arcs.x.high = errors.x.high = end * 1.25;
  arcs.y.high = round_up(top * 1.02);
  arcs.y.low = bottom < 0 ? -round_up(-bottom * 1.05) : 0;
  errors.y.high = worst > 0 ? round_up(worst * 1.05) : best < 0 ? 0 : 1;
  errors.y.low = best < 0 ? -round_up(-best * 1.05) : 0;
  place(arcs, std::move(names));
  place(errors, std::move(error_names));
  figure.panels = {std::move(arcs), std::move(errors)};
  return figure;
}

}  // namespace shortfall
