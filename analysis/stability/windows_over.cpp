// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/windows_over.hpp"

#include <algorithm>

#include "analysis/stability/algebraic_over.hpp"
#include "analysis/stability/quotient.hpp"
#include "analysis/stability/window_walk.hpp"

namespace shortfall {

namespace {

using Poly = Univariate<Algebraic>;      // over K, in the letter
using Entry = Quotient<Algebraic>;       // K(letter)
using InEigenvalue = Univariate<Entry>;  // over K(letter), in the eigenvalue

/// The resultant, by Euclid's algorithm.
Entry resultant_of(InEigenvalue a, InEigenvalue b) {
  Entry result = 1;
  while (b.degree() > 0) {
    InEigenvalue rest = divided(a, b).second;
    if (rest.is_zero()) return 0;
    for (int k = a.degree() - rest.degree(); k > 0; --k) result *= b.leading();
    if (a.degree() % 2 == 1 && b.degree() % 2 == 1) result = -result;
    a = std::exchange(b, std::move(rest));
  }
  for (int k = a.degree(); k > 0; --k) result *= b.leading();
  return result;
}

/// The polynomials over K at whose roots the answer may change.
class CriticalOver {
 public:
  explicit CriticalOver(const SquareMatrix<Entry>& matrix) : matrix_(matrix) {
    for (const auto& row : matrix)
      for (const Entry& e : row) add(e.denominator());
    InEigenvalue p(characteristic_coefficients(matrix));
    int zeros = 0;
    while (p[zeros].is_zero()) ++zeros;
    for (int k = 0; k < zeros; ++k) others_ = others_ * InEigenvalue({Entry(0), Entry(1)});
    p = InEigenvalue({p.coefficients().begin() + zeros, p.coefficients().end()});
    for (const auto& [part, multiplicity] : squarefree_parts(p)) add_part(part, multiplicity);
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) add(resultant_of(shared_[i].first, shared_[j].first));
      if (shared_[i].second > 1) add_defects(i);
    }
  }

  const std::vector<Poly>& polynomials() const { return polynomials_; }

 private:
  void add(const Poly& p) {
    if (p.degree() > 0) polynomials_.push_back(p);
  }
  /// Zeros and poles.
  void add(const Entry& e) {
    add(e.numerator());
    add(e.denominator());
  }

  void add_part(const InEigenvalue& part, int multiplicity) {
    const InEigenvalue shared = gcd(part, part.reversed());
    const InEigenvalue rest = divided(part, shared).first;
    for (int k = 0; k < multiplicity; ++k) others_ = others_ * rest;
    if (rest.degree() > 0) add(resultant_of(rest, rest.reversed()));
    if (shared.degree() < 1) return;
    if (shared.degree() > 1) add(resultant_of(shared, shared.derivative()));
    shared_.emplace_back(shared, multiplicity);
  }

  /// Where a repeated eigenvalue may lose Jordan blocks: roots that all entries of a polynomial in the matrix
  /// share.
  void add_defects(std::size_t i) {
    InEigenvalue rest = others_;
    for (std::size_t j = 0; j < shared_.size(); ++j)
      for (int k = 0; j != i && k < shared_[j].second; ++k) rest = rest * shared_[j].first;
    SquareMatrix<Entry> left = evaluated(rest, matrix_);
    const SquareMatrix<Entry> step = evaluated(shared_[i].first, matrix_);
    for (int k = 1; k < shared_[i].second; ++k) {
      left = product(left, step);
      Poly common;
      for (const auto& row : left)
        for (const Entry& e : row) common = gcd(common, e.numerator());
      add(common);
    }
  }

  const SquareMatrix<Entry>& matrix_;
  std::vector<std::pair<InEigenvalue, int>> shared_;  ///< with multiplicities
  InEigenvalue others_{{Entry(1)}};
  std::vector<Poly> polynomials_;
};

/// Each entry's numerator and denominator at a value that the field F knows.
template <class F, class At>
SquareMatrix<F> evaluated_at(const SquareMatrix<Entry>& matrix, At&& at) {
  SquareMatrix<F> result;
  for (const auto& row : matrix) {
    result.emplace_back();
    for (const Entry& e : row) result.back().push_back(at(e.numerator()) / at(e.denominator()));
  }
  return result;
}

template <class F, class At>
WindowEdge edge_at(const SquareMatrix<Entry>& matrix, const RealRoot& root, At&& at) {
  WindowEdge edge{root, false, {}};
  for (const auto& row : matrix)
    for (const Entry& e : row) edge.pole = edge.pole || at(e.denominator()).is_zero();
  if (!edge.pole) edge.growth = power_growth(evaluated_at<F>(matrix, at));
  return edge;
}

}  // namespace

Windows bounded_windows_over(const SquareMatrix<Fraction>& matrix, Letter letter,
                             const std::vector<AlgebraicLetter>& letters) {
  const CommonField field = common_field(letters);
  SquareMatrix<Entry> entries;
  for (const auto& row : matrix) {
    entries.emplace_back();
    for (const Fraction& f : row)
      entries.back().emplace_back(over_field(f.numerator(), letter, letters, field),
                                  over_field(f.denominator(), letter, letters, field));
  }
  const std::vector<RootOver> roots = positive_roots(CriticalOver(entries).polynomials(), field.generator);
  std::vector<RealRoot> values;
  for (const RootOver& r : roots) values.push_back(r.root);
  const auto at_number = [](const Rational& value) {
    return [&value](const Poly& p) { return p.at(Algebraic(value)); };
  };
  const auto edge = [&](std::size_t i) {
    const RealRoot& root = values[i];
    if (root.is_rational()) return edge_at<Algebraic>(entries, root, at_number(root.low()));
    const RealRoot narrow = root.refined(root.low() / Rational(2).pow(80));
    const auto generator = std::make_shared<AlgebraicOver::Extension>(
        AlgebraicOver::Extension{field.generator, narrow, roots[i].polynomial});
    return edge_at<AlgebraicOver>(entries, root, [&](const Poly& p) { return AlgebraicOver(p, generator); });
  };
  const auto inside = [&](const Rational& value) {
    return power_growth(evaluated_at<Algebraic>(entries, at_number(value)));
  };
  return walked(values, edge, inside);
}

}  // namespace shortfall
