// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_force_correction.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/algebra/homological_equation.hpp"
#include "analysis/algebra/rational_system.hpp"
#include "analysis/algebra/word_series.hpp"

namespace shortfall {

std::vector<int> position_only_kicks(int degree) {
  const LieQuotient& quotient = LieQuotient::of(VectorFields::mechanical, degree);
  const auto words = LyndonBasis::up_to(degree).words(degree);
  std::vector<int> result;
  for (std::size_t k = 0; k < quotient.basis(degree).size(); ++k) {
    const Word w = words[static_cast<std::size_t>(quotient.basis(degree)[k])];
    if (w.count_b() == w.count_a() + 1) result.push_back(static_cast<int>(k));
  }
  return result;
}

namespace {

/// The conditions of a degree as they see the kicks of that degree.
std::vector<std::vector<Rational>> conditions_on_kicks(int degree) {
  const RationalSystem& equation = homological_equation(VectorFields::mechanical, degree);
  const std::vector<int> kicks = position_only_kicks(degree);
  std::vector<std::vector<Rational>> matrix;
  for (const std::vector<Rational>& condition : equation.obstructions()) {
    std::vector<Rational>& row = matrix.emplace_back();
    for (const int k : kicks) row.push_back(condition[static_cast<std::size_t>(k)]);
  }
  return matrix;
}

/// Whether the conditions of each degree below this one determine the kicks of that degree.
bool kicks_are_determined(int below) {
  for (int degree = 2; degree < below; ++degree) {
    const RationalSystem system(conditions_on_kicks(degree), position_only_kicks(degree).size());
    if (system.kernel_dimension() > 0) return false;
  }
  return true;
}

}  // namespace

template <class Field>
LieElement<Field> splitting_logarithm(const SplittingParts<Field>& parts, const LieElement<Field>& kick) {
  WordSeries<Field> product(kick.degree());
  for (const SplittingPart<Field>& p : parts) {
    if (p.kick)
      product = product * exp(p.weight * kick);
    else
      product.multiply_by_exponential(false, p.weight);
  }
  return log(product);
}

template <class Field>
SplittingForceCorrection<Field> splitting_force_correction(const SplittingParts<Field>& parts, int degree) {
  constexpr VectorFields kKind = VectorFields::mechanical;
  LieElement<Field> kick = LieElement<Field>::b(degree);
  for (;;) {
    SplittingProcessing<Field> now = splitting_processing(splitting_logarithm(parts, kick), kKind);
    if (!now.obstruction) return {std::move(kick), std::move(now), {}};
    const int n = now.obstruction->degree;
    const std::vector<int> kicks = position_only_kicks(n);
    // A kick of degree n, whatever the weights, enters L_n with their sum, which is 1 for a consistent step.
    const RationalSystem system(conditions_on_kicks(n), kicks.size());
    std::vector<Field> right;
    for (const Field& value : now.obstruction->values) right.push_back(-value);
    const std::vector<Field> residuals = system.residuals(right);
    const auto violated = std::ranges::find_if(residuals, [](const Field& r) { return !zero_as_known(r); });
    if (violated == residuals.end()) {
      const std::vector<Field> added = system.solution(right);
      const LieQuotient& quotient = LieQuotient::of(kKind, degree);
      for (std::size_t k = 0; k < kicks.size(); ++k)
        kick.at(n, quotient.basis(n)[static_cast<std::size_t>(kicks[k])]) += added[k];
      continue;
    }
    const auto row = static_cast<std::size_t>(violated - residuals.begin());
    typename SplittingForceCorrection<Field>::Limit limit{n,
                                                          static_cast<int>(right.size()),
                                                          static_cast<int>(kicks.size()),
                                                          system.obstructions()[row],
                                                          -residuals[row],
                                                          kicks_are_determined(n)};
    return {std::move(kick), std::move(now), std::move(limit)};
  }
}

#define SHORTFALL_INSTANTIATE(Field)                                                                      \
  template LieElement<Field> splitting_logarithm(const SplittingParts<Field>&, const LieElement<Field>&); \
  template SplittingForceCorrection<Field> splitting_force_correction(const SplittingParts<Field>&, int);
SHORTFALL_INSTANTIATE(Rational)
SHORTFALL_INSTANTIATE(Algebraic)
SHORTFALL_INSTANTIATE(KnownDigits)
#undef SHORTFALL_INSTANTIATE

}  // namespace shortfall
