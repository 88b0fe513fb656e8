// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/rational_system.hpp"

#include <algorithm>
#include <utility>

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

RationalSystem::RationalSystem(const std::vector<Row>& rows, std::size_t unknowns) {
  // The last unknown comes first, so that it is the first ones that stay free; beside A the identity, which
  // records what elimination does to r.
  const std::size_t count = rows.size();
  std::vector<Row> extended(count, Row(unknowns + count));
  for (std::size_t r = 0; r < count; ++r) {
    std::reverse_copy(rows[r].begin(), rows[r].end(), extended[r].begin());
    extended[r][unknowns + r] = 1;
  }
  const RowEchelon reduced = row_echelon(std::move(extended), unknowns + count);
  solve_.assign(unknowns, Row(count));
  for (std::size_t r = 0; r < reduced.rows.size(); ++r) {
    Row record(reduced.rows[r].begin() + static_cast<long>(unknowns), reduced.rows[r].end());
    const auto pivot = static_cast<std::size_t>(reduced.pivots[r]);
    if (pivot < unknowns) {
      solve_[unknowns - 1 - pivot] = std::move(record);
    } else {
      make_primitive(record);
      obstructions_.push_back(std::move(record));
    }
  }
  kernel_dimension_ = static_cast<int>(unknowns + obstructions_.size()) - static_cast<int>(count);
}

}  // namespace shortfall
