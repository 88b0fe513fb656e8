// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/homological_equation.hpp"

#include "analysis/algebra/kept_by_degree.hpp"

namespace shortfall {

const RationalSystem& homological_equation(VectorFields kind, int n) {
  static KeptByDegree<RationalSystem> kept;
  return kept.at(static_cast<std::size_t>(kind), n, 2, [&] {
    const LieQuotient& quotient = LieQuotient::of(kind, n);
    const LyndonBasis& lyndon = LyndonBasis::up_to(n);
    const auto unknowns = static_cast<std::size_t>(quotient.dimension(n - 1));
    std::vector<std::vector<Rational>> rows(static_cast<std::size_t>(quotient.dimension(n)));
    for (std::size_t k = 0; k < unknowns; ++k) {
      std::vector<Rational> unit(unknowns);
      unit[k] = 1;
      const std::vector<Rational> c = quotient.lifted(n - 1, unit);
      std::vector<Rational> image = lyndon.with_letter(n, c, 0);
      const std::vector<Rational> other = lyndon.with_letter(n, c, 1);
      for (std::size_t i = 0; i < image.size(); ++i) image[i] += other[i];
      const std::vector<Rational> column = quotient.coordinates(n, image);
      for (std::size_t r = 0; r < rows.size(); ++r) rows[r].push_back(column[r]);
    }
    return new RationalSystem(rows, unknowns);
  });
}

}  // namespace shortfall
