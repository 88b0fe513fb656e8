// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/modular.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// One place of a tableau, counted from 0.
struct Cell {
  enum class Part { a, b, embedded, b_position, embedded_position, c };
  Part part = Part::a;
  std::size_t i = 0;
  std::size_t j = 0;  ///< in the matrix only

  bool operator==(const Cell&) const = default;
};

/// The numbers of a Runge-Kutta or Nystroem tableau, in one kind of number: Rational, Fraction (with the
/// letters of roots), KnownDigits, or Modular for fingerprints.
///
/// shape  a: stages x stages; the others: stages, or empty where the tableau has none
template <class K>
struct Method {
  bool nystroem = false;
  std::vector<std::vector<K>> a;
  std::vector<K> b;
  std::vector<K> embedded;
  std::vector<K> b_position;
  std::vector<K> embedded_position;
  std::vector<K> c;

  std::size_t stages() const { return b.size(); }
  std::vector<K>& row(Cell::Part part) {
    switch (part) {
      case Cell::Part::embedded:
        return embedded;
      case Cell::Part::b_position:
        return b_position;
      case Cell::Part::embedded_position:
        return embedded_position;
      case Cell::Part::c:
        return c;
      default:
        return b;
    }
  }
  K& at(const Cell& cell) { return cell.part == Cell::Part::a ? a[cell.i][cell.j] : row(cell.part)[cell.i]; }
  const K& at(const Cell& cell) const { return const_cast<Method&>(*this).at(cell); }
};

/// Every place that a tableau has.
template <class K>
std::vector<Cell> cells(const Method<K>& m) {
  using Part = Cell::Part;
  std::vector<Cell> all;
  for (std::size_t i = 0; i < m.stages(); ++i)
    for (std::size_t j = 0; j < m.stages(); ++j) all.push_back({Part::a, i, j});
  for (const Part part : {Part::b, Part::embedded, Part::b_position, Part::embedded_position, Part::c})
    for (std::size_t i = 0; i < const_cast<Method<K>&>(m).row(part).size(); ++i) all.push_back({part, i, 0});
  return all;
}

/// The same tableau in another kind of number.
template <class To, class From, class Convert>
Method<To> converted(const Method<From>& m, Convert&& convert) {
  const auto row = [&](const std::vector<From>& from) {
    std::vector<To> to;
    to.reserve(from.size());
    for (const From& k : from) to.push_back(convert(k));
    return to;
  };
  Method<To> result;
  result.nystroem = m.nystroem;
  for (const auto& line : m.a) result.a.push_back(row(line));
  result.b = row(m.b);
  result.embedded = row(m.embedded);
  result.b_position = row(m.b_position);
  result.embedded_position = row(m.embedded_position);
  result.c = row(m.c);
  return result;
}

/// Nothing, as far as is known: 0, or a ball that holds it.
template <class K>
bool is_nothing(const K& value) {
  if constexpr (requires { value.contains_zero(); })
    return value.contains_zero();
  else
    return value.is_zero();
}

}  // namespace shortfall
