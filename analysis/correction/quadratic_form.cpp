// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/error.hpp"
#include "analysis/correction/linear_kit.hpp"

namespace shortfall {

std::optional<QuadraticForm> quadratic_form(const std::vector<std::vector<Fraction>>& m) {
  if (m.empty() || m[0][1].is_zero()) return std::nullopt;
  const Fraction det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  // Q = [-m21, (m11 - m22)/2; ., m12] satisfies M^T Q M = det(M) Q; divided by m12.
  const QuadraticForm q{-m[1][0] / m[0][1], (m[0][0] - m[1][1]) / m[0][1], det};
  const Fraction b = q.xv / Fraction(2);
  const Fraction xx = m[0][0].pow(2) * q.xx + Fraction(2) * m[0][0] * m[1][0] * b + m[1][0].pow(2);
  const Fraction xv =
      m[0][0] * m[0][1] * q.xx + (m[0][0] * m[1][1] + m[0][1] * m[1][0]) * b + m[1][0] * m[1][1];
  const Fraction vv = m[0][1].pow(2) * q.xx + Fraction(2) * m[0][1] * m[1][1] * b + m[1][1].pow(2);
  if (!(xx == det * q.xx) || !(xv == det * b) || !(vv == det))
    throw Error("a quadratic form does not survive substitution");
  return q;
}

}  // namespace shortfall
