// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A text of the .integrator language with one slip in it undone: other lines in some places.
struct TextEdit {
  struct Line {
    int number = 0;  ///< from 1
    std::string text;
  };
  std::vector<Line> lines;
  std::string words;  ///< the slip: "a sign is the other one"
  double cost = 1;
  /// When present, a number in the line is still to be found: the text has the parameter `name` in its place.
  struct Unknown {
    std::string name;
    Rational printed;
    std::string before, token, after;  ///< the line: before + token + after
    enum class Form { factor, divisor, time } form = Form::factor;
    /// The line with a value in the unknown's place, in the manner of what is printed.
    std::string line(const std::string& value) const { return before + value + after; }
  };
  std::optional<Unknown> unknown;
  bool exchanges_kicks = false;  ///< all kicks are drifts and the other way round
};

/// The name that stands for a number to be found.
inline const std::string kUnknownName = "unknown_in_audit";

/// Every single slip that the lines of a text can have: numbers, signs, names, times of the force,
/// neighbouring lines, kick and drift.
std::vector<TextEdit> text_edits(const std::string& text);

/// Short numbers with a slip in them undone, digit by digit: for those in which nothing is a polynomial, 1/(5
/// - r).
std::vector<TextEdit> digit_edits(const std::string& text);

/// The text after an edit; with its unknown declared as a parameter.
std::string edited(const std::string& text, const TextEdit& edit);

std::vector<std::string> lines_of(const std::string& text);

/// Without the blanks at both ends.
std::string trimmed(const std::string& text);

}  // namespace shortfall
