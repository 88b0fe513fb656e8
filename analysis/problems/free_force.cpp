// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/free_force.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/problems/functions.hpp"

namespace shortfall {

FreeVector& FreeVector::add(const FreeVector& other, const Fraction& factor) {
  for (const auto& [key, coefficient] : other.terms) {
    Fraction& mine = terms[key];
    mine += factor * coefficient;
    if (mine.is_zero()) terms.erase(key);
  }
  return *this;
}

FreeVector FreeForce::acceleration(const Vector& x, const Vector&, const Scalar& t) {
  int key = 2;
  for (const Evaluation& e : evaluations_) {
    if (e.x == x && e.t == t) return {{{key, 1}}};
    ++key;
  }
  evaluations_.push_back({x, t});
  return {{{key, 1}}};
}

Fraction FreeForce::function(Function f, const Scalar& a, const Scalar& b) const {
  if (a.is_constant() && b.is_constant()) return value_of(f, a.constant(), b.constant());
  throw Unable("the step calls " + std::string(name_of(f)) + " of what is no number");
}

Fraction FreeForce::root(const RealRoot& root, const std::string& name) const {
  if (root.is_rational()) return root.rational();
  throw Unable("the coefficient '" + name + "' of the step is irrational");
}

void FreeForce::refuse_stage() {
  throw Unable("a stage that is solved for has no formula for a force that is not known");
}

}  // namespace shortfall
