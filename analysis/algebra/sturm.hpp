// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/univariate.hpp"

namespace shortfall {

/// Counts the real roots of a square-free polynomial over an ordered field, exactly.
///
/// source  Sturm (1829), Memoire sur la resolution des equations numeriques
template <class F>
class Sturm {
 public:
  explicit Sturm(const Univariate<F>& p) {
    sequence_.push_back(p);
    sequence_.push_back(p.derivative());
    while (!sequence_.back().is_zero()) {
      Univariate<F> rest = -divided(sequence_[sequence_.size() - 2], sequence_.back()).second;
      // A positive factor changes no sign, and keeps the coefficients small.
      if (!rest.is_zero()) rest = rest.leading().sign() > 0 ? rest.monic() : -rest.monic();
      sequence_.push_back(std::move(rest));
    }
    sequence_.pop_back();
  }

  /// Roots x with low < x <= high; neither low nor high may be a multiple root.
  int roots_between(const F& low, const F& high) const { return changes(low) - changes(high); }
  int roots_above(const F& low) const { return changes(low) - changes_at_infinity(1); }
  int roots() const { return changes_at_infinity(-1) - changes_at_infinity(1); }

 private:
  int changes(const F& x) const {
    return counted([&](const Univariate<F>& p) { return p.at(x).sign(); });
  }
  int changes_at_infinity(int side) const {
    return counted([&](const Univariate<F>& p) {
      return p.leading().sign() * (side < 0 && p.degree() % 2 == 1 ? -1 : 1);
    });
  }
  template <class Sign>
  int counted(Sign sign_of) const {
    int count = 0;
    int last = 0;
    for (const Univariate<F>& p : sequence_) {
      const int sign = sign_of(p);
      if (sign * last < 0) ++count;
      if (sign != 0) last = sign;
    }
    return count;
  }
  std::vector<Univariate<F>> sequence_;
};

}  // namespace shortfall
