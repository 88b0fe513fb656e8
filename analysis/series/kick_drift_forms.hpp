// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/algebra/univariate.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/series/splitting_numbers.hpp"

namespace shortfall {

/// A vector as a sum of x, v and evaluations of the force, with polynomials in h as coefficients.
///
/// Columns: 0 is x, 1 is v, 2 + k the k-th evaluation; those past the end are 0.
template <class Field>
class KickDriftForm {
 public:
  using Scalar = Univariate<Field>;

  KickDriftForm() = default;
  static KickDriftForm column(std::size_t index) {
    KickDriftForm result;
    result.columns_.resize(index + 1);
    result.columns_[index] = Scalar({Field(1)});
    return result;
  }
  std::size_t columns() const { return columns_.size(); }
  Scalar operator[](std::size_t column) const {
    return column < columns_.size() ? columns_[column] : Scalar();
  }
  /// The coefficient of h^power in a column.
  Field at(std::size_t column, int power) const {
    const Scalar s = (*this)[column];
    return power <= s.degree() ? s[power] : Field(0);
  }

  KickDriftForm operator-() const { return Scalar({Field(-1)}) * *this; }
  friend KickDriftForm operator+(KickDriftForm a, const KickDriftForm& b) {
    if (a.columns_.size() < b.columns_.size()) a.columns_.resize(b.columns_.size());
    for (std::size_t k = 0; k < b.columns_.size(); ++k) a.columns_[k] = a.columns_[k] + b.columns_[k];
    return a;
  }
  friend KickDriftForm operator-(const KickDriftForm& a, const KickDriftForm& b) { return a + -b; }
  friend KickDriftForm operator*(const Scalar& s, KickDriftForm a) {
    for (Scalar& c : a.columns_) c = s * c;
    return a;
  }
  friend KickDriftForm operator/(KickDriftForm a, const Scalar& s) {
    for (Scalar& c : a.columns_) c = c / s;
    return a;
  }
  /// The same to the digits known.
  bool agrees(const KickDriftForm& other) const {
    const KickDriftForm difference = *this - other;
    for (const Scalar& c : difference.columns_)
      for (const Field& f : c.coefficients())
        if (!zero_as_known(f)) return false;
    return true;
  }

 private:
  std::vector<Scalar> columns_;
};

/// A quotient that is a polynomial in h again.
///
/// throws  Unable  when it is none
template <class Field>
Univariate<Field> operator/(const Univariate<Field>& a, const Univariate<Field>& b) {
  auto [quotient, rest] = divided(a, b);
  if (!rest.is_zero()) throw Unable("the step divides by something that contains h");
  return quotient;
}
/// A step in forms: every evaluation of the force is a new column, unless the force was evaluated there
/// already.
template <class Field>
struct KickDriftForms {
  using Scalar = Univariate<Field>;
  using Vector = KickDriftForm<Field>;

  struct Evaluation {
    Vector x;
    bool in_time;  ///< always asked for at the time that its drifts have covered
  };

  SplittingNumbers<Field> numbers;
  std::vector<Evaluation> evaluations;

  Scalar number(const Rational& value) const { return Scalar({Field(value)}); }
  std::optional<Scalar> parameter(int index, bool) const { return numbers.parameter(index); }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector&, const Scalar& t) {
    const Scalar late = t - x[1];
    const bool in_time =
        std::ranges::all_of(late.coefficients(), [](const Field& f) { return zero_as_known(f); });
    for (std::size_t k = 0; k < evaluations.size(); ++k) {
      if (!evaluations[k].x.agrees(x)) continue;
      evaluations[k].in_time = evaluations[k].in_time && in_time;
      return Vector::column(2 + k);
    }
    evaluations.push_back({x, in_time});
    return Vector::column(1 + evaluations.size());
  }
  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    throw Unable("it solves for a stage, while kicks and drifts are explicit");
  }
  Scalar function(Function f, const Scalar& a, const Scalar& b) const {
    // An engine's damping that is switched off: pow(1, h), max(0, 1).
    if (f == Function::pow && a.degree() == 0 && (a[0] - Field(1)).is_zero()) return a;
    if constexpr (std::is_same_v<Field, Rational>)
      if ((f == Function::max || f == Function::min) && a.degree() <= 0 && b.degree() <= 0)
        return Scalar({value_of(f, a.is_zero() ? Rational(0) : a[0], b.is_zero() ? Rational(0) : b[0])});
    if (f != Function::sqrt || a.degree() > 0)
      throw Unable("its coefficients are no polynomials in h: " + std::string(name_of(f)) + " makes them");
    return Scalar({numbers.square_root(a.is_zero() ? Field(0) : a[0])});
  }
  Scalar root(const RealRoot& root, const std::string&) const { return Scalar({numbers.root(root)}); }
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }
};

}  // namespace shortfall
