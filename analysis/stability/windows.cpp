// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/windows.hpp"

#include <algorithm>

#include "analysis/problems/letters.hpp"
#include "analysis/stability/growth_at_root.hpp"
#include "analysis/stability/motion_pair.hpp"
#include "analysis/stability/resultant.hpp"
#include "analysis/stability/window_walk.hpp"
#include "analysis/stability/windows_over.hpp"

namespace shortfall {

namespace {

Polynomial least_common_denominator(const SquareMatrix<Fraction>& matrix) {
  Polynomial common = 1;
  for (const auto& row : matrix)
    for (const Fraction& f : row)
      common = common * exact_quotient(f.denominator(), gcd(common, f.denominator()));
  return common;
}

/// x^degree p(1/x).
Polynomial reversed(const Polynomial& p) {
  const std::vector<Polynomial> coefficients = p.coefficients(kEigenvalue);
  Polynomial result;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    result +=
        coefficients[k] * Polynomial::letter(kEigenvalue, static_cast<int>(coefficients.size() - 1 - k));
  return result;
}

/// The polynomials at whose roots the answer may change.
class Critical {
 public:
  Critical(const SquareMatrix<Fraction>& matrix, Letter letter) : matrix_(matrix), letter_(letter) {
    const Polynomial poles = least_common_denominator(matrix);
    add(poles);
    const std::vector<Fraction> p = characteristic_coefficients(matrix);
    Polynomial common = 1;
    for (const Fraction& c : p)
      common = common * exact_quotient(c.denominator(), gcd(common, c.denominator()));
    Polynomial cleared;
    for (std::size_t k = 0; k < p.size(); ++k)
      cleared += (p[k] * Fraction(common)).numerator() * Polynomial::letter(kEigenvalue, static_cast<int>(k));
    for (const auto& [factor, multiplicity] : shortfall::factor(cleared).factors) {
      if (factor.degree(kEigenvalue) < 1) continue;
      factors_.emplace_back(factor, multiplicity);
    }
    for (std::size_t i = 0; i < factors_.size(); ++i) add_factor(i);
  }

  const std::vector<Univariate<Rational>>& polynomials() const { return polynomials_; }

 private:
  void add(const Polynomial& p) {
    if (p.contains(letter_)) polynomials_.push_back(univariate(p, letter_));
  }

  static bool own_reversal(const Polynomial& p) {
    const Polynomial r = reversed(p);
    return r == p || r == -p;
  }

  void add_factor(std::size_t i) {
    const Polynomial& f = factors_[i].first;
    if (f == Polynomial::letter(kEigenvalue)) return;
    if (!own_reversal(f)) {
      add(resultant(f, reversed(f), kEigenvalue));
      return;
    }
    add(multiple_root_condition(f, kEigenvalue));
    for (std::size_t j = 0; j < i; ++j)
      if (own_reversal(factors_[j].first)) add(resultant(f, factors_[j].first, kEigenvalue));
    if (factors_[i].second > 1) add_defects(i);
  }

  /// Where a repeated eigenvalue may lose Jordan blocks: roots that all entries of a polynomial in the matrix
  /// share.
  void add_defects(std::size_t i) {
    Univariate<Fraction> rest({Fraction(1)});
    for (std::size_t j = 0; j < factors_.size(); ++j)
      for (int k = 0; j != i && k < factors_[j].second; ++k) rest = rest * in_eigenvalue(factors_[j].first);
    SquareMatrix<Fraction> left = evaluated(rest, matrix_);
    const SquareMatrix<Fraction> step = evaluated(in_eigenvalue(factors_[i].first), matrix_);
    for (int k = 1; k < factors_[i].second; ++k) {
      left = product(left, step);
      Polynomial common;
      for (const auto& row : left)
        for (const Fraction& f : row) common = gcd(common, f.numerator());
      add(common);
    }
  }

  static Univariate<Fraction> in_eigenvalue(const Polynomial& p) {
    std::vector<Fraction> result;
    for (const Polynomial& c : p.coefficients(kEigenvalue)) result.emplace_back(c);
    return result;
  }

  const SquareMatrix<Fraction>& matrix_;
  Letter letter_;
  std::vector<std::pair<Polynomial, int>> factors_;
  std::vector<Univariate<Rational>> polynomials_;
};

WindowEdge edge_at(const SquareMatrix<Fraction>& matrix, Letter letter, const Univariate<Rational>& poles,
                   const RealRoot& root) {
  WindowEdge edge{root, false, {}};
  if (root.is_rational()) {
    edge.pole = poles.at(root.rational()).is_zero();
    if (!edge.pole) edge.growth = power_growth(matrix_at(matrix, letter, root.rational()));
  } else {
    edge.pole = divided(poles, root.polynomial()).second.is_zero();
    if (!edge.pole)
      edge.growth = matrix.size() <= 2 ? growth_at_root(matrix, letter, root)
                                       : power_growth(matrix_at(matrix, letter, root));
  }
  return edge;
}

}  // namespace

SquareMatrix<Rational> matrix_at(const SquareMatrix<Fraction>& matrix, Letter letter, const Rational& value) {
  SquareMatrix<Rational> result;
  for (const auto& row : matrix) {
    result.emplace_back();
    for (const Fraction& f : row) result.back().push_back(f.evaluate({{letter, value}}));
  }
  return result;
}

SquareMatrix<Algebraic> matrix_at(const SquareMatrix<Fraction>& matrix, Letter letter,
                                  const RealRoot& value) {
  // Narrow enough for most signs to be seen at once.
  const auto generator =
      std::make_shared<const RealRoot>(value.refined(value.low().abs() / Rational(2).pow(80)));
  SquareMatrix<Algebraic> result;
  for (const auto& row : matrix) {
    result.emplace_back();
    for (const Fraction& f : row)
      result.back().push_back(Algebraic(univariate(f.numerator(), letter), generator) /
                              Algebraic(univariate(f.denominator(), letter), generator));
  }
  return result;
}

std::vector<Rational> samples_between(const std::vector<RealRoot>& roots) {
  std::vector<Rational> samples;
  Rational low = 0;
  for (const RealRoot& r : roots) {
    samples.push_back(simplest_between(low, r.low()));
    low = r.high();
  }
  samples.push_back(low.floor() + 1);
  return samples;
}

Windows walked(const std::vector<RealRoot>& roots, const std::function<WindowEdge(std::size_t)>& edge_of,
               const std::function<PowerGrowth(const Rational&)>& inside_of) {
  const std::vector<Rational> samples = samples_between(roots);
  Windows result;
  result.cells = static_cast<int>(samples.size());
  result.points = static_cast<int>(roots.size());
  Window* open = nullptr;  // the window that goes on
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::optional<WindowEdge> edge;
    if (i > 0) edge = edge_of(i - 1);
    const bool point_bounded = edge && !edge->pole && edge->growth.bounded();
    const PowerGrowth inside = inside_of(samples[i]);
    if (open && edge && !(point_bounded && inside.bounded())) {
      open->to = edge;
      open->to_included = point_bounded;
      open = nullptr;
    } else if (!open && point_bounded && !inside.bounded()) {
      result.windows.push_back({edge, edge, true, true, false, false});
    }
    if (!inside.bounded()) continue;
    if (!open) {
      result.windows.push_back({edge, {}, point_bounded, false, inside.decays, inside.inside == 0});
      open = &result.windows.back();
      continue;
    }
    open->decays = open->decays && inside.decays;
    open->keeps = open->keeps && inside.inside == 0;
  }
  return result;
}

Windows bounded_windows(const SquareMatrix<Fraction>& matrix, Letter letter) {
  const std::vector<RealRoot> roots = positive_roots(Critical(matrix, letter).polynomials());
  const Univariate<Rational> poles = univariate(least_common_denominator(matrix), letter);
  return walked(
      roots, [&](std::size_t i) { return edge_at(matrix, letter, poles, roots[i]); },
      [&](const Rational& value) { return power_growth(matrix_at(matrix, letter, value)); });
}

Windows bounded_windows(const SquareMatrix<Fraction>& matrix, Letter letter,
                        const std::vector<AlgebraicLetter>& letters) {
  const auto occurs = [&](const AlgebraicLetter& a) {
    return std::ranges::any_of(matrix, [&](const auto& row) {
      return std::ranges::any_of(row, [&](const Fraction& f) { return f.contains(a.letter); });
    });
  };
  std::vector<AlgebraicLetter> present;
  for (const AlgebraicLetter& a : letters)
    if (occurs(a)) present.push_back(a);
  return present.empty() ? bounded_windows(matrix, letter) : bounded_windows_over(matrix, letter, present);
}

}  // namespace shortfall
