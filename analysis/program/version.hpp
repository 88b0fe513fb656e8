// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// A version of a piece of software in whose source an integrator was read.
struct SoftwareVersion {
  std::string software;      ///< "Jolt"
  std::vector<int> numbers;  ///< 5, 2
  std::string text;          ///< as the source says it: "Jolt 5.2 (jolt-physics.js 1.1.0)"
};

/// What the sources of an integrator begin with, where that is a name and a version: `source Jolt 5.2, ...`.
/// Books and papers have none.
std::vector<SoftwareVersion> versions(const Program& program);

/// "5.6" or "v5.6.1"; none when the text is no version.
std::optional<std::vector<int>> version_numbers(std::string_view text);

/// Whether one says no more than the beginning of the other: 5 and 5.6.1, 4.2 and 4.
bool agree(const std::vector<int>& a, const std::vector<int>& b);

/// The integrator that a word with a version means, "rapier@0.21": the named one, or where that is another
/// version, the only one of the catalogue that was read in this version of the same software.
///
/// param   named    what the word means without its version
/// param   version  what stands after the @
/// throws  BadInput  for a text that is no version, for an integrator that has none, and for a version that
///                   is not known, with those that are
Program of_version(const Program& named, const std::string& version, const std::vector<Program>& catalogue);

}  // namespace shortfall
