// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_jump.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"
#include "notebooks-export/figure_labels.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr std::array<Ink, 5> kFlightInks{Ink::vermillion, Ink::blue, Ink::green, Ink::purple, Ink::orange};
constexpr int kFine = 200;           // points of a smooth curve
constexpr int kMostFrames = 2000;    // beyond that there is no picture
constexpr int kMostFrameMarks = 60;  // beyond that frames are a line

std::string rate_text(const Rational& dt) { return general_text(1 / dt.to_double(), 6) + " Hz"; }

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
    const Ink ink = kFlightInks[f % kFlightInks.size()];
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
      if (last <= kMostFrameMarks) {
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
  arcs.y.high = rounded_up(top * 1.02);
  arcs.y.low = bottom < 0 ? -rounded_up(-bottom * 1.05) : 0;
  errors.y.high = worst > 0 ? rounded_up(worst * 1.05) : best < 0 ? 0 : 1;
  errors.y.low = best < 0 ? -rounded_up(-best * 1.05) : 0;
  place_apart(arcs, std::move(names));
  place_apart(errors, std::move(error_names));
  figure.panels = {std::move(arcs), std::move(errors)};
  return figure;
}

}  // namespace shortfall
