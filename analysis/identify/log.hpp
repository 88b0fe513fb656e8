// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// How the numbers of a log were rounded when it was written.
struct LogRounding {
  enum class Kind {
    binary32,     ///< nothing was rounded: every number is a binary32, with all its digits
    binary64,     ///< nothing was rounded: every number is a binary64
    decimals,     ///< to so many digits after the point
    significant,  ///< to so many digits in all
  };
  Kind kind = Kind::binary64;
  int digits = 0;

  bool exact() const { return kind == Kind::binary32 || kind == Kind::binary64; }
  /// Half a unit of the last place that was written; 0 when nothing was rounded.
  double half(double value) const;
  std::string str() const;  ///< "binary32", "4 decimals"
};

/// Positions, and perhaps velocities, of one body, frame by frame, as somebody recorded them. The format is
/// described in docs/identify.md.
///
/// Numbers stay in the units of the file; `metres` says how long its unit of length is.
struct Log {
  using Triple = std::array<double, 3>;
  struct Row {
    Triple x{};
    Triple v{};
    double time = 0;  ///< seconds, where there are stamps
    long frame = 0;   ///< counted from the first row
    int line = 0;     ///< of the file
  };

  std::string file;
  std::vector<int> axes;                            ///< of 0, 1, 2: those that have a column
  std::array<std::string, 3> names{"x", "y", "z"};  ///< of the columns of positions
  bool velocities = false;
  LogRounding position_rounding;
  LogRounding velocity_rounding;
  Rational units_in_metre = 1;  ///< 100 when lengths are in cm; 1 when the unit is not known
  std::string unit = "m";
  std::optional<Rational> dt;  ///< seconds; where the stamps say it
  bool equal_steps = true;     ///< false: the time stamps are not equally far apart
  double shortest_step = 0, longest_step = 0;
  std::vector<Row> rows;
  bool more = false;                ///< the file goes on; only the first kMostRows frames were read
  std::vector<std::string> bodies;  ///< when there are several: all of them, the one that was read first
};

inline constexpr std::size_t kMostRows = 4096;

struct LogOptions {
  std::map<std::string, std::string> columns;  ///< of frame, time, body, x, y, z, vx, vy, vz: the file's name
  std::string body;                            ///< of several; empty: the first
};

/// Reads CSV, TSV (also separated by semicolons or blanks) or JSON lines, with or without a header, line by
/// line: no more is kept than the first kMostRows frames of one body.
///
/// throws  UnreadableFile;  SyntaxError  with row and column
Log read_log(const std::string& path, const LogOptions& options = {});

/// The same of a text that is already here.
Log parse_log(const std::string& text, const std::string& name, const LogOptions& options = {});

}  // namespace shortfall
