// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_contour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace shortfall {

namespace {

using Path = Figure::Path;
using Point = Figure::Point;

/// The grid with a frame around it that lies above every level, at the place of the outermost values: all
/// lines are closed.
class Framed {
 public:
  Framed(const Grid& grid, double level) : grid_(grid), level_(level) {}
  int columns() const { return grid_.columns + 2; }
  int rows() const { return grid_.rows + 2; }
  bool frame(int c, int r) const { return c == 0 || r == 0 || c == columns() - 1 || r == rows() - 1; }
  double value(int c, int r) const {
    if (frame(c, r)) return std::numeric_limits<double>::infinity();
    const double v = grid_.at(c - 1, r - 1);
    return std::isnan(v) ? std::numeric_limits<double>::infinity() : v;
  }
  double level() const { return level_; }
  bool inside(int c, int r) const { return value(c, r) <= level_; }
  Point place(int c, int r) const {
    return {grid_.x(std::clamp(c - 1, 0, grid_.columns - 1)), grid_.y(std::clamp(r - 1, 0, grid_.rows - 1))};
  }
  /// Where the level is met between a node inside and its neighbour outside.
  Point crossing(int c, int r, int c2, int r2) const {
    if (!inside(c, r)) return crossing(c2, r2, c, r);
    const double a = value(c, r), b = value(c2, r2);
    const double t = std::isinf(b) ? (frame(c2, r2) ? 0 : 1) : (level_ - a) / (b - a);
    const Point p = place(c, r), q = place(c2, r2);
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

 private:
  const Grid& grid_;
  double level_;
};

struct Vertex {
  Point at;
  bool on_frame;
};

/// Edges of the grid: 2 * node for the one to the right of a node, one more for the one above it.
class Marching {
 public:
  Marching(const Framed& field) : field_(field) {
    for (int r = 0; r + 1 < field.rows(); ++r)
      for (int c = 0; c + 1 < field.columns(); ++c) cell(c, r);
  }

  std::vector<std::vector<Vertex>> loops() {
    std::vector<std::vector<Vertex>> result;
    while (!next_.empty()) {
      std::vector<Vertex> loop;
      for (auto i = next_.begin(); i != next_.end(); i = next_.find(follow(i, loop))) {
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  using Next = std::map<long, long>;

  long follow(Next::iterator i, std::vector<Vertex>& loop) {
    loop.push_back(vertices_.at(i->first));
    const long to = i->second;
    next_.erase(i);
    return to;
  }

  long edge(int c, int r, bool upwards) {
    return 2 * (static_cast<long>(r) * field_.columns() + c) + (upwards ? 1 : 0);
  }

  /// The four edges of a cell, counter-clockwise from the lower one.
  long side(int c, int r, int which) {
    const int c1 = which == 1 ? c + 1 : c, r1 = which == 2 ? r + 1 : r;
    const bool upwards = which % 2 == 1;
    const long id = edge(c1, r1, upwards);
    const int c2 = upwards ? c1 : c1 + 1, r2 = upwards ? r1 + 1 : r1;
    if (!vertices_.contains(id))
      vertices_[id] = {field_.crossing(c1, r1, c2, r2), field_.frame(c1, r1) || field_.frame(c2, r2)};
    return id;
  }

  /// Lines that keep the inside on their left.
  void cell(int c, int r) {
    const bool in[4] = {field_.inside(c, r), field_.inside(c + 1, r), field_.inside(c + 1, r + 1),
                        field_.inside(c, r + 1)};
    // Along side k from corner k to corner k + 1: a line ends where the inside begins and starts where it
    // ends.
    std::vector<int> starts, ends;
    for (int k = 0; k < 4; ++k) {
      if (in[k] && !in[(k + 1) % 4]) starts.push_back(k);
      if (!in[k] && in[(k + 1) % 4]) ends.push_back(k);
    }
    if (starts.size() == 2) {
      // A saddle: its middle decides which corners belong together.
      const double middle = (field_.value(c, r) + field_.value(c + 1, r) + field_.value(c + 1, r + 1) +
                             field_.value(c, r + 1)) /
                            4;
      const bool joined = middle <= field_.level();
      for (const int s : starts) {
        const int e = joined ? (s + 1) % 4 : (s + 3) % 4;
        next_[side(c, r, s)] = side(c, r, e);
      }
      return;
    }
    if (starts.size() == 1) next_[side(c, r, starts[0])] = side(c, r, ends[0]);
  }

  const Framed& field_;
  Next next_;
  std::map<long, Vertex> vertices_;
};

double signed_area(const Path& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point& a = p[i];
    const Point& b = p[(i + 1) % p.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum / 2;
}

bool contains(const Path& p, const Point& q) {
  bool inside = false;
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++)
    if ((p[i].y > q.y) != (p[j].y > q.y) &&
        q.x < (p[j].x - p[i].x) * (q.y - p[i].y) / (p[j].y - p[i].y) + p[i].x)
      inside = !inside;
  return inside;
}

/// Joins a hole to its outline where they are closest.
void cut(Path& outline, const Path& hole) {
  std::size_t from = 0, to = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (std::size_t j = 0; j < hole.size(); ++j)
      if (const double d = std::hypot(outline[i].x - hole[j].x, outline[i].y - hole[j].y); d < best) {
        best = d;
        from = i;
        to = j;
      }
  Path detour;
  for (std::size_t j = 0; j <= hole.size(); ++j) detour.push_back(hole[(to + j) % hole.size()]);
  detour.push_back(outline[from]);
  outline.insert(outline.begin() + static_cast<long>(from) + 1, detour.begin(), detour.end());
}

/// The pieces of a loop that do not run along the frame.
void append_lines(const std::vector<Vertex>& loop, std::vector<Path>& lines) {
  const std::size_t size = loop.size();
  const auto along_frame = [&](std::size_t k) {
    return loop[k % size].on_frame && loop[(k + 1) % size].on_frame;
  };
  std::size_t begin = 0;
  while (begin < size && !along_frame(begin)) ++begin;
  Path line;
  for (std::size_t k = begin; k < begin + size; ++k) {
    if (along_frame(k)) {
      if (!line.empty()) lines.push_back(std::move(line));
      line.clear();
      continue;
    }
    if (line.empty()) line.push_back(loop[k % size].at);
    line.push_back(loop[(k + 1) % size].at);
  }
  if (!line.empty()) lines.push_back(std::move(line));
}

}  // namespace

LevelRegion level_region(const Grid& grid, double level) {
  const Framed field(grid, level);
  std::vector<Path> holes;
  LevelRegion result;
  for (const std::vector<Vertex>& loop : Marching(field).loops()) {
    Path path;
    for (const Vertex& v : loop)
      if (path.empty() || !(path.back() == v.at)) path.push_back(v.at);
    append_lines(loop, result.lines);
    if (path.size() < 3) continue;
    (signed_area(path) > 0 ? result.outlines : holes).push_back(std::move(path));
  }
  for (const Path& hole : holes) {
    // The smallest outline around it.
    Path* around = nullptr;
    for (Path& outline : result.outlines)
      if (contains(outline, hole.front()) && (!around || signed_area(outline) < signed_area(*around)))
        around = &outline;
    if (around) cut(*around, hole);
  }
  return result;
}

}  // namespace shortfall
