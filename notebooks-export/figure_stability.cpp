// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/algebra/general_text.hpp"
#include "analysis/program/print.hpp"
#include "analysis/stability/radicals.hpp"
#include "analysis/stability/sampled.hpp"
#include "notebooks-export/figure_contour.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;
using Align = Figure::Align;

std::string short_number(double value) { return general_text(value, 4); }

/// "2 √2 = 2.828", "2.507", "2".
std::string value_text(const RealRoot& r) {
  std::string decimal = short_number(r.to_double());
  const auto formula = radical_formula(r);
  if (!formula) return decimal;
  const std::string exact = print(*formula, Style::unicode);
  return exact == decimal ? exact : exact.size() > 24 ? decimal : exact + " ≈ " + decimal;
}

/// How far the picture reaches: past the last edge, but not for ever.
double reach(const Windows& windows) {
  double last = 0;
  for (const Window& w : windows.windows)
    for (const auto* edge : {&w.from, &w.to})
      if (*edge) last = std::max(last, (*edge)->at.to_double());
  if (last == 0) return windows.always() ? 10 : 3;
  return std::min(1.35 * last, 40 + last);
}

constexpr double kTop = 1.6;

/// The same line with fewer points: none of those left out is farther than this share of the picture from it.
///
/// source  Douglas & Peucker (1973), Algorithms for the reduction of the number of points
void thin(const Figure::Path& p, std::size_t from, std::size_t to, double x_unit, double y_unit,
          Figure::Path& kept) {
  std::size_t farthest = from;
  double largest = 2e-4;
  const double dx = (p[to].x - p[from].x) / x_unit, dy = (p[to].y - p[from].y) / y_unit,
               length = std::hypot(dx, dy);
  for (std::size_t i = from + 1; i < to; ++i) {
    const double off =
        std::abs((p[i].x - p[from].x) / x_unit * dy - (p[i].y - p[from].y) / y_unit * dx) / length;
    if (off > largest) {
      largest = off;
      farthest = i;
    }
  }
  if (farthest == from) {
    kept.push_back(p[to]);
    return;
  }
  thin(p, from, farthest, x_unit, y_unit, kept);
  thin(p, farthest, to, x_unit, y_unit, kept);
}

Figure::Path thinned(const Figure::Path& p, double x_unit, double y_unit) {
  Figure::Path kept{p.front()};
  thin(p, 0, p.size() - 1, x_unit, y_unit, kept);
  return kept;
}

Figure::Panel sizes_panel(const Stability& s) {
  Figure::Panel panel;
  panel.title = s.substeps > 1 ? "what a frame multiplies an oscillation by"
                               : "what a step multiplies an oscillation by";
  const std::size_t count = s.numbers.nonzero.size() - 1;
  const double end = reach(s.windows);
  panel.x = {s.substeps > 1 ? "frame times frequency, h ω" : "step times frequency, h ω", "rad", 0, end,
             false};
  panel.y = {"size of the eigenvalues, |λ|", "", 0, kTop, false};
  for (const Window& w : s.windows.windows) {
    const double from = w.from ? w.from->at.to_double() : 0, to = w.to ? w.to->at.to_double() : end;
    panel.regions.push_back({{{{from, 0}, {to, 0}, {to, 1}, {from, 1}}}, Ink::sky, 0.16});
    panel.labels.push_back({{(from + std::min(to, end)) / 2, 0.06},
                            to - from > end / 6 ? "stable" : "",
                            Ink::blue,
                            Align::centre,
                            0});
  }
  panel.curves.push_back({{{{0, 1}, {end, 1}}}, Ink::grey, 1, true});
  const SampledEigenvalues eigenvalues(s.numbers);
  constexpr int kPoints = 900;
  std::vector<Figure::Path> paths(count);
  for (int i = 0; i <= kPoints; ++i) {
    const double z = end * std::max(i, 1) / kPoints * (i == 0 ? 1e-3 : 1);
    const std::vector<double> sizes = eigenvalues.sizes(z / s.substeps);
    for (std::size_t k = 0; k < count; ++k)
      paths[k].push_back({z, std::min(std::pow(sizes[k], s.substeps), 2 * kTop)});
  }
  const auto apart = [](const Figure::Point& a, const Figure::Point& b) {
    return std::abs(a.y - b.y) > 0.01;
  };
  const bool one_size =
      count < 2 ||
      std::ranges::none_of(paths.front(), [&, i = std::size_t{0}](const Figure::Point& p) mutable {
        return apart(p, paths.back()[i++]);
      });
  panel.note = one_size ? "all eigenvalues have one size" : "thick: the largest eigenvalue; thin: the others";
  for (Figure::Path& p : paths) p = thinned(p, end, kTop);
  if (count > 1) panel.curves.push_back({{paths.begin() + 1, paths.end()}, Ink::sky, 2, false});
  panel.curves.push_back({{paths.front()}, Ink::blue, 3, false});
  if (const RealRoot* limit = s.limit()) {
    const double at = limit->to_double();
    panel.curves.push_back({{{{at, 0}, {at, kTop}}}, Ink::vermillion, 1.6, true});
    panel.marks.push_back({{at, 1}, Ink::vermillion});
    const bool room_left = at > 0.4 * end;
    panel.labels.push_back({{at + (room_left ? -0.015 : 0.015) * end, kTop * 0.96},
                            "limit " + value_text(*limit),
                            Ink::vermillion,
                            room_left ? Align::right : Align::left,
                            0});
  } else {
    const bool always = s.windows.always();
    panel.labels.push_back({{end / 2, always ? 1.3 : 0.7},
                            always                      ? "stable for every h ω"
                            : s.windows.windows.empty() ? "stable for no h ω"
                                                        : "stable for no small h ω",
                            Ink::vermillion,
                            Align::centre,
                            0});
  }
  return panel;
}

struct Box {
  double left, right, top;
};

/// A box that shows what there is to see: the bounded stable region, or the bounded unstable one.
Box box_of(const StabilityFunction& r) {
  const bool bounded = !r.size_at_infinity() || Algebraic(1) < *r.size_at_infinity();
  const SampledFunction sampled(r);
  double scale = 2.0 * (r.numerator.degree() + r.denominator.degree()) + 4;
  Box seen{0, 0, 0};
  constexpr int kLook = 120;
  for (int i = -kLook; i <= kLook; ++i)
    for (int j = 0; j <= kLook; ++j) {
      const std::complex<double> z(scale * i / kLook, scale * j / kLook);
      if ((sampled.size(z) <= 1) != bounded) continue;
      seen.left = std::min(seen.left, z.real());
      seen.right = std::max(seen.right, z.real());
      seen.top = std::max(seen.top, z.imag());
    }
  if (!bounded && (seen.right > 0.95 * scale || seen.top > 0.95 * scale)) seen = {-4, 4, 4};  // half a plane
  const double width = seen.right - seen.left, margin = 0.16 * std::max(width, 2 * seen.top);
  Box box{seen.left - margin, seen.right + margin, seen.top + margin};
  if (!bounded) box.left = std::min(box.left, -0.45 * (box.right - box.left));
  box.right = std::max(box.right, 0.25 * (box.right - box.left));
  // A picture is neither a tower nor a ribbon.
  if (const double missing = 1.0 * 2 * box.top - (box.right - box.left); missing > 0) {
    box.left -= missing / 2;
    box.right += missing / 2;
  }
  box.top = std::max(box.top, (box.right - box.left) / 1.5 / 2);
  return box;
}

Figure::Panel region_panel(const Stability& s) {
  const StabilityFunction& r = *s.function;
  Figure::Panel panel;
  panel.title = s.properties->l_stable   ? "where |R(z)| ≤ 1: A-stable and L-stable"
                : s.properties->a_stable ? "where |R(z)| ≤ 1: A-stable"
                                         : "where |R(z)| ≤ 1";
  panel.note = "z = h λ for y' = λ y; darker: ≤ 0.8, 0.6, 0.4, 0.2";
  const Box box = box_of(r);
  panel.x = {"Re z", "", box.left, box.right, false};
  panel.y = {"Im z", "", -box.top, box.top, false};
  panel.equal_scales = true;
  constexpr int kFine = 361;
  const SampledFunction sampled(r);
  Grid grid{box.left, box.right, -box.top, box.top, kFine, kFine, {}};
  for (int row = 0; row < kFine; ++row)
    for (int column = 0; column < kFine; ++column)
      grid.values.push_back(sampled.size({grid.x(column), grid.y(row)}));
  const std::array<std::pair<double, double>, 5> tints{
      {{1, 0.16}, {0.8, 0.26}, {0.6, 0.38}, {0.4, 0.52}, {0.2, 0.68}}};
  for (const auto& [level, strength] : tints)
    panel.regions.push_back({level_region(grid, level).outlines, Ink::sky, strength});
  panel.curves.push_back(
      {{{{box.left, 0}, {box.right, 0}}, {{0, -box.top}, {0, box.top}}}, Ink::grey, 0.8, false});
  panel.curves.push_back({level_region(grid, 1).lines, Ink::blue, 2.4, false});
  if (const WindowEdge* edge = s.properties->real_axis.limit()) {
    const double at = -edge->at.to_double();
    panel.marks.push_back({{at, 0}, Ink::vermillion});
    panel.labels.push_back({{at - 0.02 * (box.right - box.left), 0},
                            "−" + short_number(-at),
                            Ink::vermillion,
                            Align::right,
                            0.8});
  }
  if (s.limit() && s.limit()->to_double() / s.substeps < box.top) {
    const double at = s.limit()->to_double() / s.substeps;
    for (const double side : {at, -at}) panel.marks.push_back({{0, side}, Ink::vermillion});
    panel.labels.push_back(
        {{0.02 * (box.right - box.left), at}, short_number(at) + " i", Ink::vermillion, Align::left, 0.8});
  }
  return panel;
}

}  // namespace

Figure stability_figure(const Stability& s) {
  Figure figure;
  figure.title = "Stability of " + s.integrator +
                 (s.substeps > 1 ? ", " + std::to_string(s.substeps) + " substeps" : "");
  if (s.function) figure.panels.push_back(region_panel(s));
  figure.panels.push_back(sizes_panel(s));
  return figure;
}

}  // namespace shortfall
