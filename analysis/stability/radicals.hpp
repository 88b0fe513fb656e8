// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// A real algebraic number by real radicals, such as 2*sqrt(2), where a formula is shorter than the number's
/// polynomial: rational numbers, roots of quadratic polynomials and of cubic ones with a single real root,
/// positive roots of all these.
std::optional<Expr> radical_formula(const RealRoot& number);

/// The polynomial of a number as a formula in x that is 0 there: x^3 - 4*x^2 + 12*x - 24.
Expr polynomial_formula(const Univariate<Rational>& p, const std::string& unknown);

/// sqrt(r) for r >= 0, squares taken out of the root: 2*sqrt(2), 1/3*sqrt(6).
Expr square_root_formula(const Rational& r);

}  // namespace shortfall
