// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "notebooks-export/figure_contour.hpp"
#include "notebooks-export/figure_gnuplot.hpp"
#include "notebooks-export/figure_stability.hpp"
#include "tests/scratch_folder.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

namespace fs = std::filesystem;

/// Twice the signed area inside a closed path.
double area(const Figure::Path& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Figure::Point &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return std::abs(sum) / 2;
}

Grid grid(double reach, int size, double (*f)(double, double)) {
  Grid g{-reach, reach, -reach, reach, size, size, {}};
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) g.values.push_back(f(g.x(c), g.y(r)));
  return g;
}

/// Whatever a text might do to a drawing program.
std::string hostile(const fs::path& file) {
  return "`touch " + file.string() + "` $(touch " + file.string() + ") '; system('touch " + file.string() +
         "') #\" . system(\"touch " + file.string() + "\") . \"\n!touch " + file.string() +
         "\nEND_OF_DATA\n@x {/Symbol a}^2_3 \\ %s ω √2";
}

Figure hostile_figure(const fs::path& file) {
  const std::string text = hostile(file);
  Figure figure;
  figure.title = text;
  Figure::Panel panel;
  panel.title = text;
  panel.note = text;
  panel.x = {text, text, 0, 1, false};
  panel.y = {text, text, 0, 1, false};
  panel.labels.push_back({{0.5, 0.5}, text, Figure::Ink::blue, Figure::Align::left, 0});
  panel.curves.push_back({{{{0, 0}, {1, 1}}}, Figure::Ink::blue, 2, false});
  figure.panels.push_back(panel);
  return figure;
}

}  // namespace

TEST_CASE("texts reach gnuplot in single quotes only, with quotes doubled, on one line") {
  const std::string script = gnuplot_script(hostile_figure("/tmp/never"), ImageFormat::svg);
  std::size_t at = 0;
  bool data = false;
  while (at < script.size()) {
    const std::size_t end = script.find('\n', at);
    const std::string line = script.substr(at, end - at);
    at = end + 1;
    if (line.ends_with("<< END_OF_DATA")) data = true;
    if (line == "END_OF_DATA") {
      CHECK(data);
      data = false;
      continue;
    }
    // Outside single quotes: no double quote, backquote, exclamation mark or system.
    bool quoted = false;
    std::string outside;
    for (const char c : line) {
      if (c == '\'') quoted = !quoted;
      if (!quoted) outside += c;
    }
    CHECK_FALSE(quoted);
    CHECK(outside.find_first_of("\"`!@") == std::string::npos);
    CHECK(outside.find("system") == std::string::npos);
    CHECK(outside.find("touch") == std::string::npos);
  }
  CHECK_FALSE(data);
}

TEST_CASE("a hostile title is drawn and nothing is run") {
  if (!gnuplot_is_here()) {
    MESSAGE("gnuplot is not installed: not drawn here");
    return;
  }
  const ScratchFolder folder;
  const fs::path file = folder.path("run");
  for (const ImageFormat format : {ImageFormat::svg, ImageFormat::png, ImageFormat::pdf}) {
    const std::string bytes = image(hostile_figure(file), format);
    CHECK(bytes.size() > 1000);
    CHECK_FALSE(fs::exists(file));
    if (format == ImageFormat::svg) {
      CHECK(bytes.find("`touch ") != std::string::npos);  // as letters
      CHECK(bytes.find("ω √2") != std::string::npos);
    }
  }
}

TEST_CASE("the format is the name's ending, in any case") {
  CHECK(image_format("a.SVG") == ImageFormat::svg);
  CHECK(image_format("b.c.png") == ImageFormat::png);
  CHECK(image_format("d.pdf") == ImageFormat::pdf);
  CHECK_THROWS_AS(image_format("svg"), BadInput);
  CHECK_THROWS_AS(image_format("a.svg.txt"), BadInput);
}

TEST_CASE("level lines: a circle and a ring have their areas, lines lie on their level") {
  constexpr double kPi = 3.14159265358979;
  const Grid disc = grid(2, 201, [](double x, double y) { return std::hypot(x, y); });
  const LevelRegion circle = level_region(disc, 1);
  REQUIRE(circle.outlines.size() == 1);
  CHECK(area(circle.outlines[0]) == doctest::Approx(kPi).epsilon(1e-3));
  for (const Figure::Path& line : circle.lines)
    for (const Figure::Point& p : line) CHECK(std::hypot(p.x, p.y) == doctest::Approx(1).epsilon(1e-3));
  // 1 <= r <= 1.6: one outline whose hole is joined to it by a cut.
  const Grid ring = grid(2, 201, [](double x, double y) { return std::abs(std::hypot(x, y) - 1.3); });
  const LevelRegion annulus = level_region(ring, 0.3);
  double total = 0;
  for (const Figure::Path& p : annulus.outlines) total += area(p);
  CHECK(total == doctest::Approx(kPi * (1.6 * 1.6 - 1)).epsilon(1e-3));
  // All inside: the grid itself.
  const LevelRegion all = level_region(disc, 10);
  REQUIRE(all.outlines.size() == 1);
  CHECK(area(all.outlines[0]) == doctest::Approx(16).epsilon(1e-9));
  CHECK(all.lines.empty());
  CHECK(level_region(disc, -1).outlines.empty());
}

TEST_CASE("every integrator has a figure whose curves stay on it and whose labels tell the limit" *
          doctest::test_suite("thorough")) {
  for (const Program& p : testing::undamped_catalogue()) {
    CAPTURE(p.name);
    const Stability s = stability(p);
    const Figure figure = stability_figure(s);
    CHECK(figure.title.find(p.name) != std::string::npos);
    CHECK(figure.panels.size() == (s.function ? 2u : 1u));
    const Figure::Panel& sizes = figure.panels.back();
    CHECK(sizes.x.unit == "rad");
    bool told = false;
    for (const Figure::Label& l : sizes.labels)
      told = told || l.text.starts_with(s.limit() ? "limit" : "stable for");
    CHECK(told);
    for (const Figure::Curve& c : sizes.curves)
      for (const Figure::Path& path : c.paths)
        for (const Figure::Point& at : path) {
          CHECK(at.x >= 0);
          CHECK(at.x <= sizes.x.high * (1 + 1e-12));
        }
  }
}
