// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/program/json_text.hpp"
#include "analysis/program/tableau_file.hpp"

namespace shortfall {

/// Reads the coefficients of one tableau file, and gathers those that stand for other numbers.
class TableauEntryReader {
 public:
  /// How long an unbroken row of digits has to be for a decimal (after its point) to be taken as rounded.
  static constexpr std::size_t kRoundedFrom = 8;
  enum class Decimals { by_length, exact, rounded };

  /// param   digits  when present, entries with 8 digits in a row agree with what they stand for to so many
  /// places, fractions too
  TableauEntryReader(const Source& source, Decimals decimals, std::optional<int> digits)
      : source_(source), decimals_(decimals), digits_(digits) {}

  /// param   name  of the coefficient, should it be an approximate one: "a2_1"
  /// throws  SyntaxError
  TableauEntry entry(const JsonValue& value, const std::string& name);

  /// In the order in which they were first met; the same text is the same coefficient.
  const std::vector<Approximation>& approximations() const { return approximations_; }

 private:
  std::string complaint(const std::string& text) const;
  std::optional<int> places(const TableauEntry& entry) const;
  void approximate(TableauEntry& entry, const std::string& name);

  const Source& source_;
  Decimals decimals_;
  std::optional<int> digits_;
  std::vector<Approximation> approximations_;
  std::map<std::string, std::string> names_;  ///< by decimal
};

}  // namespace shortfall
