// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall::cli {

enum class Unit { none, length, time };

/// The exact value of a number as users type it: "0.02", "1/50", "40cm", "50Hz" (as a time: 1/50 s), "1/60f"
/// (rounded to binary32).
///
/// units   metres, seconds
/// param   what  the option it came from, for messages
/// throws  BadInput  with one sentence
Rational quantity(std::string_view text, Unit unit, const std::string& what);

/// As quantity, and positive.
Rational positive_quantity(std::string_view text, Unit unit, const std::string& what);

/// A number and, where it says so (0.1f, 1/60d), what is stored for it.
struct StoredQuantity {
  Rational meant;                ///< 0.1
  std::optional<Rational> kept;  ///< 0.1f, exactly
};

/// Whether a number ends in the suffix f or d.
bool has_suffix(std::string_view text, char suffix);

/// As quantity, with the number that is meant told from the one that is stored.
StoredQuantity stored_quantity(std::string_view text, Unit unit, const std::string& what);

/// "FROM:TO:lin:COUNT" or "FROM:TO:log:COUNT", or a single number. Logarithmic points are rounded to 12
/// significant digits (and are exact then).
///
/// throws  BadInput
std::vector<Rational> sweep(std::string_view text, Unit unit, const std::string& what);

}  // namespace shortfall::cli
