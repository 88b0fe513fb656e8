// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/program/source.hpp"

namespace shortfall {

struct JsonMember;

/// A JSON value that knows where it stands, and whose numbers are the text that was written: 0.1 is one tenth
/// and not a binary64.
struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  std::string text;   ///< number: as written; string: its content; boolean: "true" or "false"
  bool plain = true;  ///< string: written without escapes, so that its content stands on its line as it is
  std::vector<JsonValue> items;     ///< array
  std::vector<JsonMember> members;  ///< object: keys (strings) and values, in order
  Place place;
  std::size_t byte = 0;  ///< of its line, where the text of a number or of a plain string begins

  const JsonValue* find(std::string_view key) const;
  /// "a list", "the text \"abc\"", "the number 3": what a message calls it.
  std::string described() const;
};

struct JsonMember {
  JsonValue first;   ///< the key, a string
  JsonValue second;  ///< the value
};

/// The value that a whole text is.
///
/// throws  SyntaxError  with the place: what is no JSON, a key that stands twice, lists within lists within
/// ... (8 deep)
JsonValue json_value(const Source& source);

}  // namespace shortfall
