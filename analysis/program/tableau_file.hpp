// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// One coefficient of a tableau file, as it was written and as it was understood.
struct TableauEntry {
  Expr value;  ///< in the program: a number, an expression, or the name of an approximate coefficient
  std::optional<Rational>
      exact;             ///< what was written, when that is rational: 0.1 is 1/10; none for sqrt(2)/2
  std::string text;      ///< as written: "0.1", "1/3", "1/4-sqrt(3)/6"; "0" for an entry left out
  bool decimal = false;  ///< written with a point
  /// Present when it stands for another number, with which it agrees to so many digits after the point.
  std::optional<int> digits;
  Place place;  ///< of the entry, or of the row in which it was left out
};

/// What an author says, and where.
template <class T>
struct Stated {
  T value{};
  Place place;
};

/// What a tableau file claims about its method. Nothing of it is believed.
struct TableauClaims {
  std::optional<Stated<int>> order;
  std::optional<Stated<int>> embedded_order;
  std::optional<Stated<int>> stage_order;
  std::optional<Stated<bool>> symplectic;
  std::optional<Stated<bool>> symmetric;
  std::optional<Stated<bool>> a_stable;
  std::optional<Stated<bool>> l_stable;
};

/// A Runge-Kutta or Nystroem tableau read from JSON.
///
/// shape  a is square, with as many rows as b and c have entries; what a file leaves out of it is 0
struct TableauFile {
  std::string name;  ///< as an integrator may be called; what was written otherwise is an alias
  /// For y'' = f(t, y): `a`, `b_position` and `c` make the positions, `b` the velocities.
  bool nystroem = false;
  std::vector<std::vector<TableauEntry>> a;
  std::vector<TableauEntry> b;
  std::vector<TableauEntry> embedded;           ///< empty when there is none
  std::vector<TableauEntry> b_position;         ///< Nystroem only
  std::vector<TableauEntry> embedded_position;  ///< Nystroem only, empty when there is none
  std::vector<TableauEntry> c;                  ///< the row sums of a where the file has no c
  bool c_given = true;
  TableauClaims claims;
  std::string note;
  Program program;  ///< the same as an integrator; it has no `tableau` when this is a Nystroem method

  std::size_t stages() const { return b.size(); }
  /// Whether no entry stands for another number.
  bool exact() const { return !program.approximate(); }
};

/// The highest order that may be claimed: 20 has 12,826,228 conditions of its own.
inline constexpr int kHighestClaimedOrder = 20;

/// What the members of a tableau file may be called.
const std::vector<std::string>& tableau_keys();

/// The tableau that a JSON text describes; see docs/tableau.md.
///
/// param   file  the name that messages show
/// throws  SyntaxError  with line, column and what to write instead
TableauFile parse_tableau(std::string_view text, const std::string& file);

/// throws  SyntaxError; UnreadableFile
TableauFile parse_tableau_file(const std::string& path);

}  // namespace shortfall
