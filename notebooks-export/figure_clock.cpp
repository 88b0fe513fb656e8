// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_clock.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/algebra/error.hpp"
#include "notebooks-export/figure_labels.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

/// Seconds, minutes, hours or days on the axis of time.
struct TimeScale {
  double seconds;
  const char* unit;
};

TimeScale scale_for(double seconds) {
  if (seconds < 300) return {1, "s"};
  if (seconds < 18'000) return {60, "min"};
  if (seconds < 400'000) return {3600, "h"};
  return {86'400, "d"};
}

/// Exact minus computed where the speed changes; between these points it is a line.
Figure::Panel lost(const ClockReport& r, double end, const TimeScale& time, const std::string& unit) {
  const Rational advance = r.question.advance();
  Figure::Path path;
  const auto add = [&](const Rational& n, const Rational& value) {
    path.push_back({(n * r.question.dt.abs()).to_double() / time.seconds,
                    (r.question.start + n * advance - value).to_double()});
  };
  Rational n = 0;
  for (const AccumulatorRun& run : r.path.runs) {
    if (run.before > r.question.additions) break;
    add(run.before, run.from);
    n = std::min(run.before + run.additions, r.question.additions);
    add(n, run.from + (n - run.before) * run.increment);
  }
  if (n < r.question.additions && !path.empty() && r.path.end == AccumulatorPath::End::frozen)
    add(r.question.additions, r.path.last());
  double worst = 0, best = 0;
  for (const Figure::Point& p : path) {
    worst = std::max(worst, p.y);
    best = std::min(best, p.y);
  }
  Figure::Panel p;
  p.title = "Shortfall";
  p.note = "exact minus computed: positive is slow";
  p.x = {"true time", time.unit, 0, end / time.seconds};
  p.y = {"shortfall", unit, best < 0 ? -rounded_up(-1.05 * best) : 0,
         worst > 0 ? rounded_up(1.05 * worst) : 0};
  if (p.y.low == p.y.high) p.y.high = 1;
  p.curves.push_back({{std::move(path)}, Ink::blue, 2, false});
  return p;
}

/// How far its speed is off, in parts of a million; both axes logarithmic, so that fast and slow are colours.
Figure::Panel speed(const ClockReport& r, double end, const TimeScale& time) {
  constexpr double kLeast = 1e-3;
  Figure::Panel p;
  p.title = "Speed";
  p.note = "blue: slow; vermillion: fast";
  double first = end, last = 0, worst = kLeast, least = 1e9;
  for (const ClockSpeed& s : r.speeds) {
    const double from =
        std::max((s.before * r.question.dt.abs()).to_double(), r.question.dt.abs().to_double());
    const double to = std::min(((s.before + s.additions) * r.question.dt.abs()).to_double(), end);
    const double ppm = s.parts_per_million().to_double();
    if (!(to > from) || std::fabs(ppm) < kLeast) continue;
    p.curves.push_back({{{{from / time.seconds, std::fabs(ppm)}, {to / time.seconds, std::fabs(ppm)}}},
                        ppm > 0 ? Ink::vermillion : Ink::blue,
                        3,
                        false});
    first = std::min(first, from);
    last = std::max(last, to);
    worst = std::max(worst, std::fabs(ppm));
    least = std::min(least, std::fabs(ppm));
  }
  if (p.curves.empty()) {
    p.labels.push_back({{0.5, 0.5}, "no sum is off", Ink::dark, Figure::Align::centre});
    return p;
  }
  p.x = {"true time", time.unit, first / time.seconds, std::min(end, 3 * last) / time.seconds, true};
  p.y = {"speed off by", "ppm", std::pow(10, std::floor(std::log10(least))),
         std::pow(10, std::ceil(std::log10(worst))), true};
  if (p.y.low == p.y.high) p.y.high *= 10;
  return p;
}

}  // namespace

Figure clock_figure(const ClockReport& r) {
  if (r.question.additions < Rational(2) || r.path.runs.empty())
    throw Unable("there is nothing to draw: ask for two additions or more of a clock that moves");
  const double end = (r.question.additions * r.question.dt.abs()).to_double();
  const TimeScale time = scale_for(end);
  Figure figure;
  figure.title = r.question.velocity ? "x += v dt, addition by addition" : "t += dt, addition by addition";
  figure.panels = {lost(r, end, time, r.question.velocity ? "m" : "s"), speed(r, end, time)};
  return figure;
}

}  // namespace shortfall
