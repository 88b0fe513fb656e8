// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace shortfall {

/// A double with at most so many significant digits, as "%.{digits}g" prints it where the locale has a
/// decimal point: a host's locale changes nothing.
std::string general_text(double value, int digits);

/// The double with which a text begins, decimal or as "%a" prints it; 0 where there is none, or none of this
/// size.
double double_of(std::string_view text);

}  // namespace shortfall
