// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/homological_equation.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/kept_by_degree.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/algebra/row_echelon.hpp"

namespace shortfall {

namespace {

using Row = std::vector<Rational>;

/// Multiplied so that its entries are whole numbers without a common factor.
void make_primitive(Row& row) {
  Univariate<Rational> p(row);
  if (p.is_zero()) return;
  const Rational scale = primitive(p).leading() / p.leading();
  for (Rational& entry : row) entry *= scale;
  const auto first = std::ranges::find_if(row, [](const Rational& r) { return !r.is_zero(); });
  if (first->sign() < 0)
    for (Rational& entry : row) entry = -entry;
}

}  // namespace

const HomologicalEquation& HomologicalEquation::of(VectorFields kind, int n) {
  static KeptByDegree<HomologicalEquation> kept;
  return kept.at(static_cast<std::size_t>(kind), n, 2, [&] { return new HomologicalEquation(kind, n); });
}

HomologicalEquation::HomologicalEquation(VectorFields kind, int n) : n_(n) {
  const LieQuotient& quotient = LieQuotient::of(kind, n);
  const LyndonBasis& lyndon = LyndonBasis::up_to(n);
  const auto rows = static_cast<std::size_t>(quotient.dimension(n));
  const auto columns = static_cast<std::size_t>(quotient.dimension(n - 1));
  // [c, A + B] with the last unknown first, so that in degree 1 it is A that stays free; and beside it the
  // identity, which records what elimination does to r.
  std::vector<Row> extended(rows, Row(columns + rows));
  for (std::size_t k = 0; k < columns; ++k) {
    Row unit(columns);
    unit[k] = 1;
    const Row c = quotient.lifted(n - 1, unit);
    Row image = lyndon.with_letter(n, c, 0);
    const Row other = lyndon.with_letter(n, c, 1);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] += other[i];
    const Row column = quotient.coordinates(n, image);
    for (std::size_t r = 0; r < rows; ++r) extended[r][columns - 1 - k] = column[r];
  }
  for (std::size_t r = 0; r < rows; ++r) extended[r][columns + r] = 1;

  const RowEchelon reduced = row_echelon(std::move(extended), columns + rows);
  solve_.assign(columns, Row(rows));
  for (std::size_t r = 0; r < reduced.rows.size(); ++r) {
    Row record(reduced.rows[r].begin() + static_cast<long>(columns), reduced.rows[r].end());
    const auto pivot = static_cast<std::size_t>(reduced.pivots[r]);
    if (pivot < columns) {
      solve_[columns - 1 - pivot] = std::move(record);
    } else {
      make_primitive(record);
      obstructions_.push_back(std::move(record));
    }
  }
  kernel_dimension_ = static_cast<int>(columns + obstructions_.size()) - static_cast<int>(rows);
}

}  // namespace shortfall
