// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "notebooks-export/trade_text.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr std::array<Ink, 7> kSeriesInks{Ink::blue,   Ink::vermillion, Ink::green, Ink::purple,
                                         Ink::orange, Ink::sky,        Ink::black};

struct Range {
  double low = 1e300, high = 0;
  void add(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Whole powers of ten around; the range takes at most such a share of the axis.
void fit(Figure::Axis& axis, const Range& range, double share = 1) {
  axis.logarithmic = true;
  const double low = std::floor(std::log10(range.low) - 0.05);
  axis.low = std::pow(10.0, low);
  axis.high = std::pow(10.0, std::ceil(low + (std::log10(range.high) + 0.05 - low) / share));
}

constexpr double kShareOfCurves = 0.58;  ///< the rest of the width is for the names
constexpr double kMostNames = 24;        ///< as many lines of text are as high as a panel

/// Names of the lines in a column on the right, beside what they name as far as there is room, each joined to
/// the end of its line, which is where the label stands that comes in.
void place_labels(Figure::Panel& panel, std::vector<Figure::Label> labels) {
  std::ranges::sort(labels, [](const auto& a, const auto& b) { return a.at.y < b.at.y; });
  const double span = std::log10(panel.y.high / panel.y.low);
  const double least = span / std::max(kMostNames, static_cast<double>(labels.size()) + 1);
  std::vector<double> y;
  for (const Figure::Label& l : labels) y.push_back(std::log10(l.at.y));
  for (int round = 0; round < 200; ++round)
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
      const double overlap = least - (y[i + 1] - y[i]);
      if (overlap <= 0) continue;
      y[i] -= overlap / 2;
      y[i + 1] += overlap / 2;
    }
  // None below the axis.
  double least_y = std::log10(panel.y.low) + least / 2;
  for (double& value : y) {
    value = std::max(value, least_y);
    least_y = value + least;
  }
  const double column = panel.x.low * std::pow(panel.x.high / panel.x.low, kShareOfCurves + 0.03);
  const double gap = std::pow(panel.x.high / panel.x.low, 0.01);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Figure::Point end = labels[i].at;
    labels[i].at = {column, std::pow(10.0, y[i])};
    panel.curves.push_back(
        {{{{end.x * gap, end.y}, {column / gap, labels[i].at.y}}}, labels[i].ink, 0.5, false});
    panel.labels.push_back(std::move(labels[i]));
  }
}

Figure::Panel panel(const Trade& trade, std::size_t observable) {
  const SceneObservable& o = trade.scene.observables[observable];
  const double tolerance = o.tolerance.to_double();
  Figure::Panel p;
  p.title = o.name;
  p.note = "shaded: within " + error_text(tolerance, o.unit) + "; dashed: binary32; dots: best for the cost";
  p.x.label = trade.timed ? "time for the whole scene" : "evaluations of the force";
  p.x.unit = trade.timed ? "us" : "";
  p.y.label = o.is_vector() || o.kind == SceneObservable::Kind::path ? "distance from the truth"
                                                                     : "size of the error";
  p.y.unit = o.unit;
  const auto x_of = [&](const SceneOutcome& point) {
    return trade.timed ? point.nanoseconds / 1e3 : static_cast<double>(point.evaluations);
  };
  Range x, y;
  y.add(tolerance);
  for (const TradeSeries& s : trade.series)
    for (const SceneOutcome& point : s.points) {
      if (point.failed) continue;
      x.add(x_of(point));
      y.add(std::fabs(point.errors[observable]));
    }
  if (x.high == 0) x = {1, 10};
  // What is a million times better than asked for is shown; zeros and accidents below that are not.
  y.low = std::max(y.low, tolerance * 1e-9);
  y.high = std::min(y.high, tolerance * 1e9);
  fit(p.x, x, kShareOfCurves);
  fit(p.y, y);
  p.regions.push_back(
      {{{{p.x.low, p.y.low}, {p.x.high, p.y.low}, {p.x.high, tolerance}, {p.x.low, tolerance}}},
       Ink::sky,
       0.15});
  std::vector<Figure::Label> labels;
  for (const auto& [format, floor] : trade.floors[observable]) {
    if (!(floor > p.y.low) || floor > p.y.high) continue;
    p.curves.push_back({{{{p.x.low, floor}, {p.x.high, floor}}}, Ink::grey, 1, true});
    p.labels.push_back({{p.x.low * 1.1, floor}, "floor of " + format, Ink::grey, Figure::Align::left, 0.5});
  }
  std::vector<std::string> families;
  for (const TradeSeries& s : trade.series) {
    const bool is_peer = s.integrator.empty();
    const std::string family = is_peer ? s.label : s.integrator + (s.launched ? " + launch" : "");
    const auto known = std::ranges::find(families, family);
    const auto ink = static_cast<std::size_t>(known - families.begin());
    if (known == families.end() && !is_peer) families.push_back(family);
    // Side by side: the same colour, thinner.
    const double width = s.launched ? 3.0 : s.at_once > 0 ? 1.0 : 1.8;
    Figure::Curve curve{
        {}, is_peer ? Ink::grey : kSeriesInks[ink % kSeriesInks.size()], width, s.format == "f32"};
    Figure::Path path;
    for (const SceneOutcome& point : s.points) {
      const double error = point.failed ? 0 : std::fabs(point.errors[observable]);
      if (!(error >= p.y.low) || error > p.y.high) {
        if (!path.empty()) curve.paths.push_back(std::move(path));
        path.clear();
        continue;
      }
      path.push_back({x_of(point), error});
    }
    if (!path.empty()) curve.paths.push_back(std::move(path));
    if (curve.paths.empty()) continue;
    const Figure::Point end = curve.paths.back().back();
    // In the same colour a dashed line is known by the whole one.
    const bool has_whole_line =
        s.format == "f32" && std::ranges::any_of(trade.series, [&](const TradeSeries& other) {
          return other.integrator == s.integrator && other.launched == s.launched &&
                 other.at_once == s.at_once && other.format == "f64";
        });
    const std::string name = s.at_once > 0 ? family + ", many" : family;
    if (!has_whole_line) labels.push_back({end, name, curve.ink, Figure::Align::left, 0});
    p.curves.push_back(std::move(curve));
  }
  for (const TradePlace& place : pareto_front(trade, observable)) {
    const SceneOutcome& point = trade.series[place.series].points[place.point];
    const double error = std::fabs(point.errors[observable]);
    if (error >= p.y.low && error <= p.y.high) p.marks.push_back({{x_of(point), error}, Ink::black});
  }
  place_labels(p, std::move(labels));
  return p;
}

}  // namespace

Figure trade_figure(const Trade& trade) {
  Figure figure;
  figure.title =
      (trade.scene.title.empty() ? trade.scene.name : trade.scene.title) + ": accuracy against speed";
  for (std::size_t i = 0; i < trade.scene.observables.size(); ++i) figure.panels.push_back(panel(trade, i));
  return figure;
}

}  // namespace shortfall
