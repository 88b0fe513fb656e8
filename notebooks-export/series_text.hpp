// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/program/print.hpp"
#include "analysis/series/step_series.hpp"

namespace shortfall {

/// A sum of coefficient * h^power * thing, gathered by the power of h, as it is printed behind a first term:
/// " - h/2 V' v + h^2 (1/12 V' V' + 1/12 V''(v, v))".
class SumByPowers {
 public:
  SumByPowers(const SeriesSource& source, Style style) : source_(source), style_(style) {}

  void add(int power, const Fraction& coefficient, const std::string& thing);
  bool empty() const { return terms_.empty(); }
  /// param   indent  of further lines, for a text; each power of h on a line of its own when not empty
  std::string str(const std::string& indent = {}) const;

 private:
  struct Term {
    int power;
    Fraction coefficient;
    std::string thing;
  };
  std::string step_power(int power) const;
  /// A coefficient in front of something: its sign, and "1/12 ", or nothing for 1.
  std::pair<bool, std::string> weight(const Fraction& coefficient) const;

  const SeriesSource& source_;
  Style style_;
  std::vector<Term> terms_;
};

/// What is said of coefficients: "exact", or "to k digits".
std::string exactness_note(int digits);

}  // namespace shortfall
