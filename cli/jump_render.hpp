// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/correction/engine_jumps.hpp"

namespace shortfall::cli {

/// How numbers are written for a person.
struct JumpWords {
  std::string unit;  ///< of heights: mm, cm, m, km or px; empty: chosen by size
  bool ascii = false;
};

/// The answer first, then its parts, the meanings of peak, the corrections.
std::string jump_text(const Jump& jump, const JumpWords& words);

/// One line a height.
std::string jump_table(const std::vector<Jump>& jumps, const JumpWords& words);
std::string jump_csv(const std::vector<Jump>& jumps);

/// Schema shortfall.jump/1; metres and seconds. Several jumps: the schema and a list `jumps`.
nlohmann::ordered_json jump_json(const Jump& jump);
nlohmann::ordered_json jump_json(const std::vector<Jump>& jumps);

/// All engines: one line each. The CSV is that of the undamped jumps, with the engine first.
std::string engines_text(const std::vector<EngineJump>& jumps, const JumpWords& words);
std::string engines_csv(const std::vector<EngineJump>& jumps);
nlohmann::ordered_json engines_json(const std::vector<EngineJump>& jumps);

/// An exact number: a rational one as it is, one with a root by its formula and its decimal.
nlohmann::ordered_json surd_json(const Surd& value);
/// A number where every reader of JSON keeps all its digits, otherwise text.
nlohmann::ordered_json whole_json(const Rational& n);

/// To 17 digits.
std::string csv_decimal(const Surd& value);

/// "frame 1", "frames 1 to 5": of a force that launches.
std::string force_frames_text(int count);

/// A binary32 or binary64 number by the shortest decimal that reads back as itself, and in hexadecimal.
std::string shortest(std::floating_point auto value);
std::string hexadecimal(float value);

}  // namespace shortfall::cli
