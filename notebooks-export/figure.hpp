// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace shortfall {

/// A drawing as a description: panels side by side with axes, regions, curves and labels; no pixel and no
/// command of a drawing program.
///
/// Coordinates are those of the panel's axes. Labels stand at what they name, so that no legend is needed.
struct Figure {
  /// Colours that people of every colour vision tell apart.
  ///
  /// source  Okabe & Ito (2008), Color Universal Design
  enum class Ink { black, dark, grey, blue, sky, green, orange, vermillion, purple };

  struct Point {
    double x = 0;
    double y = 0;
    bool operator==(const Point&) const = default;
  };
  using Path = std::vector<Point>;

  struct Axis {
    std::string label;
    std::string unit;  ///< empty for a pure number
    double low = 0;
    double high = 1;
    bool logarithmic = false;
  };
  /// An area inside closed paths.
  struct Region {
    std::vector<Path> outlines;
    Ink ink = Ink::sky;
    double strength = 0.3;  ///< from 0, white, to 1, the full colour
  };
  /// Lines through points; nothing joins one path to the next.
  struct Curve {
    std::vector<Path> paths;
    Ink ink = Ink::blue;
    double width = 2;
    bool dashed = false;
  };
  enum class Align { left, centre, right };
  struct Label {
    Point at;
    std::string text;
    Ink ink = Ink::black;
    Align align = Align::left;
    double up = 0;  ///< moved by so many heights of a letter
  };
  /// A dot.
  struct Mark {
    Point at;
    Ink ink = Ink::black;
    double size = 1.1;
  };
  struct Panel {
    std::string title;
    std::string note;  ///< below the title, in small grey letters: how to read it
    Axis x;
    Axis y;
    bool equal_scales = false;    ///< one unit is as long upwards as sideways
    std::vector<Region> regions;  ///< drawn first, in this order
    std::vector<Curve> curves;
    std::vector<Mark> marks;
    std::vector<Label> labels;
  };

  std::string title;
  std::vector<Panel> panels;
};

}  // namespace shortfall
