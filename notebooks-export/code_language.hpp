// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// The languages in which shortfall writes code. Numbers are binary32 in C#, C++ and Rust, binary64
/// elsewhere.
enum class Language { csharp, cpp, gdscript, python, rust, javascript };

/// What steps call their force in code: a function of position, velocity and time.
inline constexpr const char* kCalledForce = "acceleration";

/// "csharp" or "c#", "cpp" or "c++", "gdscript", "python", "rust", "javascript", and the endings of their
/// files.
std::optional<Language> language_named(std::string_view word);

/// The first name of each, in the order of the enumeration.
const std::vector<std::string>& language_names();

/// What a language calls itself: "C#".
std::string title(Language language);

/// How the names of its files end: ".cs"; of C++ it is a header, ".hpp".
std::string file_ending(Language language);

bool is_binary32(Language language);

/// A name of ours (snake_case) in the language's habit, out of the way of its keywords: alphaM, alpha_m.
std::string identifier(const std::string& name, Language language);
/// The same for a constant of the file: AlphaM, kAlphaM, ALPHA_M.
std::string constant_identifier(const std::string& name, Language language);

/// A number that is no whole one keeps its value up to one rounding: 0.5f, 1.0f / 3.0f (in parentheses where
/// needed).
std::string literal(const Rational& value, Language language);

/// A measured number with as many digits as the language's numbers keep; negative ones in parentheses.
std::string decimal_literal(double value, Language language);

/// An expression of scalars: one operation of ours is one of theirs, in our order; powers are products.
///
/// param   names  what names of ours become; others become identifiers
/// throws  Unable  for a force, a sum, or a power that is no whole number from -32 to 32
std::string code(const Expr& e, Language language, const std::map<std::string, std::string>& names = {});
/// The same in binary64 in every language, where sin, cos, sinh, cosh, acos and log may occur, too.
std::string code_in_binary64(const Expr& e, Language language,
                             const std::map<std::string, std::string>& names = {});

/// Adds the names in an expression, as they come, that the list does not have yet.
void collect_names(const Expr& e, std::vector<std::string>& names);

}  // namespace shortfall
