// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

/// A coefficient does not lie in the field that was tried: it takes this number too.
struct FieldTooSmall {
  std::optional<RealRoot> wanted;
};

/// How a step's coefficients become elements of a field.
///
/// root and square_root throw FieldTooSmall for a number outside of it.
template <class Field>
struct SplittingNumbers;

template <>
struct SplittingNumbers<Rational> {
  std::optional<Univariate<Rational>> parameter(int) const { return {}; }
  Rational root(const RealRoot& root) const;
  Rational square_root(const Rational& value) const;
};

/// The field Q(r) of one generator r.
template <>
struct SplittingNumbers<Algebraic> {
  Algebraic::Generator generator;

  std::optional<Univariate<Algebraic>> parameter(int) const { return {}; }
  Algebraic root(const RealRoot& root) const;
  Algebraic square_root(const Algebraic& value) const;
};

/// Decimals as far as they are known: from some parameter on these are what was published.
template <>
struct SplittingNumbers<KnownDigits> {
  int first = 0;
  std::vector<KnownDigits> published;

  std::optional<Univariate<KnownDigits>> parameter(int index) const {
    if (index < first) return {};
    return Univariate<KnownDigits>({published[static_cast<std::size_t>(index - first)]});
  }
  KnownDigits root(const RealRoot& root) const;
  KnownDigits square_root(const KnownDigits& value) const;
};

}  // namespace shortfall
