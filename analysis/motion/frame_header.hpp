// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/algebra/rational.hpp"
#include "analysis/motion/frame_list.hpp"

namespace shortfall {

/// A unit in which frames are recorded.
struct FrameUnit {
  std::string_view name;
  Rational seconds;  ///< of one such unit; for a rate, the number is one over the step
  bool rate = false;
};

/// s, sec, seconds, ms, milliseconds, us, µs, microseconds, ns, nanoseconds, Hz, fps; case does not matter.
std::optional<FrameUnit> frame_unit(std::string_view name);

/// What the header of a column says: "dt [ms]", "frame time (s)", "timestamp_us", "FPS".
struct FrameColumn {
  FrameList::Kind kind;
  std::optional<FrameUnit> unit;  ///< when the header names one
};

/// Nothing when the header names neither steps, nor time stamps, nor rates.
std::optional<FrameColumn> frame_column(std::string_view header);

}  // namespace shortfall
