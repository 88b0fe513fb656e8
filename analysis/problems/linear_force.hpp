// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/problems/extra_letters.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/problems/linear_form.hpp"

namespace shortfall {

/// x'' = f0 + f1 t + ... + fD t^D - k x - c v, in letters: one run of a step gives its exact affine map.
///
/// Columns of a vector: the carried states (x, v, ...), then f0..fD, then the unknowns of a stage that is
/// being solved.
struct LinearForce {
  using Scalar = Fraction;
  using Vector = LinearForm;

  int states = 2;                                  ///< how many carried vectors the integrator has
  int degree = 0;                                  ///< D, of the force polynomial; -1 for no such force
  Fraction stiffness;                              ///< k; 0 for none
  Fraction damping;                                ///< c; 0 for none
  std::shared_ptr<ExtraLetters> extras = nullptr;  ///< for programs with roots and functions

  int force_column(int d) const { return states + d; }
  int unknown_column(int u) const { return states + degree + 1 + u; }

  Scalar number(const Rational& value) const { return value; }
  /// A parameter is a letter, unless its default follows from others.
  std::optional<Scalar> parameter(int index, bool derived) const {
    if (derived) return std::nullopt;
    return Fraction::letter(kFirstParameter + index);
  }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const;

  /// Where limits have no lengths to compare: no `limit` acts, every `when` holds.
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }
  /// Without extra letters functions have values only where these are rational numbers, and roots have none.
  Scalar function(Function f, const Scalar& a, const Scalar& b) const;
  Scalar root(const RealRoot& root, const std::string& name) const;
  void assume(Scalar positive, std::string text) const;

  /// The unknowns get columns of their own and are eliminated exactly.
  ///
  /// throws  Undefined  when the stage has no unique solution
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    std::vector<Vector> guess;
    for (std::size_t u = 0; u < unknowns.size(); ++u)
      guess.push_back(LinearForm::column(unknown_column(static_cast<int>(u))));
    unknowns = eliminated(f(guess));
  }

 private:
  std::vector<Vector> eliminated(std::vector<Vector> values) const;
};

}  // namespace shortfall
