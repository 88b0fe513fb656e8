// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_processing.hpp"

#include <algorithm>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/algebra/word_series.hpp"

namespace shortfall {

namespace {

template <class Field>
bool all_vanish(const std::vector<Field>& values) {
  return std::ranges::all_of(values, [](const Field& v) { return zero_as_known(v); });
}

template <class Field>
bool is_consistent(const LieElement<Field>& logarithm) {
  return zero_as_known(logarithm.at(1, 0) - Field(1)) && zero_as_known(logarithm.at(1, 1) - Field(1));
}

}  // namespace

template <class Field>
int splitting_order(const LieElement<Field>& logarithm, VectorFields kind) {
  if (!is_consistent(logarithm)) return 0;
  const LieQuotient& quotient = LieQuotient::of(kind, logarithm.degree());
  for (int n = 2; n <= logarithm.degree(); ++n)
    if (!all_vanish(quotient.coordinates(n, logarithm.part(n)))) return n - 1;
  return logarithm.degree();
}

template <class Field>
SplittingProcessing<Field> splitting_processing(const LieElement<Field>& logarithm, VectorFields kind) {
  const int degree = logarithm.degree();
  const LieQuotient& quotient = LieQuotient::of(kind, degree);
  LieElement<Field> now = quotient.normal_form(logarithm);
  SplittingProcessing<Field> result{kind, now, splitting_order(now, kind), 0, {}, now, {}};
  if (result.order == 0) return result;
  result.effective_order = 1;
  for (int n = 2; n <= degree; ++n) {
    const RationalSystem& equation = homological_equation(kind, n);
    std::vector<Field> right = quotient.coordinates(n, now.part(n));
    for (Field& r : right) r = -r;
    std::vector<Field> values = equation.residuals(right);
    if (!all_vanish(values)) {
      for (Field& v : values) v = -v;  // of L_n itself
      const auto functionals = equation.obstructions();
      result.obstruction = SplittingObstruction<Field>{
          n, std::vector<std::vector<Rational>>(functionals.begin(), functionals.end()), std::move(values)};
      break;
    }
    const auto c =
        LieElement<Field>::homogeneous(degree, n - 1, quotient.lifted(n - 1, equation.solution(right)));
    now = quotient.normal_form(exp_ad(c, now));
    result.corrections.push_back(c);
    result.effective_order = n;
  }
  result.processed = now;
  return result;
}

template <class Field>
LieElement<Field> corrector_logarithm(const SplittingProcessing<Field>& result) {
  WordSeries<Field> product(result.logarithm.degree());
  for (std::size_t k = result.corrections.size(); k-- > 0;) product = product * exp(result.corrections[k]);
  return LieQuotient::of(result.kind, product.degree()).normal_form(log(product));
}

#define SHORTFALL_INSTANTIATE(Field)                                                                \
  template int splitting_order(const LieElement<Field>&, VectorFields);                             \
  template SplittingProcessing<Field> splitting_processing(const LieElement<Field>&, VectorFields); \
  template LieElement<Field> corrector_logarithm(const SplittingProcessing<Field>&);
SHORTFALL_INSTANTIATE(Rational)
SHORTFALL_INSTANTIATE(Algebraic)
SHORTFALL_INSTANTIATE(Surd)
SHORTFALL_INSTANTIATE(KnownDigits)
#undef SHORTFALL_INSTANTIATE

}  // namespace shortfall
