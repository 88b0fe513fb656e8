// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// How expressions become exact Python: names are Fractions, but for some that are whole numbers (n, k).
///
/// A quotient of whole numbers becomes Fraction(p, q), so that nothing is ever rounded.
struct PythonWording {
  std::function<std::string(const std::string&)> name;  ///< what a name of ours becomes
  std::set<std::string> whole;                          ///< names that are Python integers
};

/// One operation of ours is one of Python's, in our order; a force becomes a(x, v, t), a sum sum(... for
/// ...).
std::string python(const Expr& e, const PythonWording& wording);

/// Whether its value is a Python integer, which a division would round.
bool is_whole(const Expr& e, const PythonWording& wording);

/// "head text", broken at signs into lines of about 90 characters when it is long; then in parentheses.
///
/// param   indent  of the first line, in blanks
std::string wrapped(int indent, const std::string& head, const std::string& text);

/// head and a statement's value; the arguments of a long call of the force get lines of their own.
std::string wrapped_call(int indent, const std::string& head, const Expr& e, const PythonWording& wording);

/// A formula with the parentheses of added sums dissolved: a + (b - c) becomes a + b - c.
Expr flattened(const Expr& e);

}  // namespace shortfall
