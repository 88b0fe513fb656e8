// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/floating/clock.hpp"

namespace shortfall {

/// What a clock reads, why, how fast it goes, where it stops, what to use instead.
std::string as_text(const ClockReport& report);

/// A line for each spacing of the numbers that the clock passes: where, how many additions, what each adds.
std::string as_csv(const ClockReport& report);

/// Schema shortfall.clock/1: numbers are exact fractions; `error` and its parts are exact minus computed.
nlohmann::ordered_json as_json(const ClockReport& report);

/// "2^21" for a power of two or its negative, else none.
std::string power_of_two_text(const Rational& value);

/// The size of the sums of a row: from where to where. Numbers; the row of exact sums begins at 0.
struct ClockRange {
  Rational from, to;
};
ClockRange range(const ClockSpeed& speed, const BinaryFormat& format);

}  // namespace shortfall
