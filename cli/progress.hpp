// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "analysis/program/progress.hpp"

namespace shortfall::cli {

/// One line on stderr that says how far long work is, rewritten in place and taken away at the end. It
/// appears only after two seconds, and only where stderr is a terminal.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// What to hand to the library; empty where nobody would see it.
  Progress progress();

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& doing, int done, int of);

  bool terminal_;
  bool shown_ = false;
  Clock::time_point begin_;
  Clock::time_point next_;
};

}  // namespace shortfall::cli
