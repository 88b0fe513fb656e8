// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_report.hpp"

#include <algorithm>
#include <variant>

#include "analysis/algebra/error.hpp"
#include "analysis/series/splitting_force_correction.hpp"
#include "analysis/series/splitting_processing.hpp"
#include "analysis/series/splitting_reading.hpp"

namespace shortfall {

namespace {

constexpr int kDecimals = 20;

/// Turns numbers into text; knows the generator's name and value.
struct Writer {
  const SplittingReading& reading;

  SplittingCoefficient operator()(const Rational& c) const { return {c.str(), c.significant(kDecimals), 0}; }
  SplittingCoefficient operator()(const Algebraic& c) const {
    if (c.is_rational()) return (*this)(c.rational());
    std::string text;
    for (int k = 0; k <= c.polynomial().degree(); ++k) {
      const Rational& q = c.polynomial()[k];
      if (q.is_zero()) continue;
      text += text.empty() ? (q.sign() < 0 ? "-" : "") : (q.sign() < 0 ? " - " : " + ");
      if (k == 0 || !q.abs().is_one()) text += q.abs().str() + (k > 0 ? "*" : "");
      if (k > 0) text += reading.generator + (k > 1 ? "^" + std::to_string(k) : "");
    }
    const Ball r = ball(*reading.generator_value, KnownDigits::kBits);
    Ball value(0, KnownDigits::kBits);
    for (int k = c.polynomial().degree(); k >= 0; --k)
      value = value * r + Ball(c.polynomial()[k], KnownDigits::kBits);
    return {text, value.significant(kDecimals).value_or(""), 0};
  }
  SplittingCoefficient operator()(const KnownDigits& c) const { return {"", c.str(), c.digits()}; }
};

template <class Field>
std::vector<BracketTerm> terms(const LieElement<Field>& x, const Writer& write) {
  std::vector<BracketTerm> result;
  for (int d = 1; d <= x.degree(); ++d)
    for (std::size_t i = 0; i < x.part(d).size(); ++i)
      if (!zero_as_known(x.part(d)[i]))
        result.push_back({d, x.basis().bracket_text(d, static_cast<int>(i)), write(x.part(d)[i])});
  return result;
}

/// To how many digits what has to be 0 is 0.
template <class Field>
std::optional<int> zero_to_digits(const LieElement<Field>& logarithm, int order) {
  if constexpr (std::is_same_v<Field, KnownDigits>) {
    int least = KnownDigits(0).digits();
    for (int d = 2; d <= order; ++d)
      for (const KnownDigits& c : logarithm.part(d)) least = std::min(least, c.digits());
    return least;
  } else {
    return std::nullopt;
  }
}

template <class Field>
SplittingClass described(const SplittingProcessing<Field>& found, const Writer& write) {
  const VectorFields kind = found.kind;
  const LieElement<Field>& logarithm = found.logarithm;
  SplittingClass result;
  result.kind = kind;
  result.modified = terms(found.logarithm, write);
  result.order = found.order;
  result.order_is_exact = found.order < logarithm.degree();
  result.effective_order = found.effective_order;
  result.effective_order_is_exact = found.order == 0 || found.obstruction.has_value();
  result.zero_to_digits = zero_to_digits(found.logarithm, found.order);
  result.effective_zero_to_digits = zero_to_digits(found.processed, found.effective_order);
  for (const LieElement<Field>& c : found.corrections) result.corrections.push_back(terms(c, write));
  result.corrector = terms(corrector_logarithm(found), write);
  if (!found.obstruction) return result;
  result.obstruction_degree = found.obstruction->degree;
  const LieQuotient& quotient = LieQuotient::of(kind, logarithm.degree());
  for (std::size_t r = 0; r < found.obstruction->values.size(); ++r) {
    if (zero_as_known(found.obstruction->values[r])) continue;
    const int n = found.obstruction->degree;
    const auto functional =
        LieElement<Rational>::homogeneous(n, n, quotient.lifted(n, found.obstruction->functionals[r]));
    result.obstructions.push_back({terms(functional, write), write(found.obstruction->values[r])});
  }
  return result;
}

template <class Field>
std::vector<SplittingWeight> weights(const SplittingParts<Field>& parts, const Writer& write) {
  std::vector<SplittingWeight> result;
  for (const SplittingPart<Field>& p : parts) result.push_back({p.kick, write(p.weight)});
  return result;
}

template <class Field>
void fill(SplittingReport& report, const KicksAndDrifts<Field>& parts, const Writer& write) {
  report.proved = !std::is_same_v<Field, KnownDigits>;
  report.time_follows_drifts = parts.time_follows_drifts;
  report.start = weights(parts.start, write);
  report.step = weights(parts.step, write);
  report.finish = weights(parts.finish, write);
  const LieElement<Field> logarithm = splitting_logarithm(parts.step, report.degree);
  report.any = described(splitting_processing(logarithm, VectorFields::any), write);
  report.mechanical = described(splitting_processing(logarithm, VectorFields::mechanical), write);
}

template <class Field>
void fill(SplittingForceReport& report, const KicksAndDrifts<Field>& parts, int degree, const Writer& write) {
  const SplittingForceCorrection<Field> found = splitting_force_correction(parts.step, degree);
  report.proved = !std::is_same_v<Field, KnownDigits>;
  report.kick = terms(found.kick, write);
  report.processed = described(found.processing, write);
  if (found.limit)
    report.limit = {found.limit->degree, found.limit->conditions, found.limit->unknowns,
                    write(found.limit->residual), found.limit->conclusive};
}

void check_degree(int degree) {
  if (degree < 2 || degree > LyndonBasis::kHighestDegree)
    throw Unable("the error of a splitting is known from degree 2 to " +
                 std::to_string(LyndonBasis::kHighestDegree) + ", not to degree " + std::to_string(degree));
}

/// Calls use(parts) with the kicks and drifts, whatever their numbers are.
template <class Use>
void with_parts(const SplittingReading& reading, const Use& use) {
  std::visit(
      [&](const auto& parts) {
        if constexpr (requires { parts.step; }) use(parts);
      },
      reading.parts);
}

}  // namespace

SplittingReport splitting_report(const Program& program, int degree, const Values& given) {
  check_degree(degree);
  const SplittingReading reading = splitting_reading(program, given);
  SplittingReport report;
  report.why_not = reading.why_not;
  report.generator = reading.generator;
  report.degree = degree;
  with_parts(reading, [&](const auto& parts) { fill(report, parts, Writer{reading}); });
  return report;
}

SplittingForceReport splitting_force_report(const Program& program, int degree, const Values& given) {
  check_degree(degree);
  const SplittingReading reading = splitting_reading(program, given);
  SplittingForceReport report;
  report.why_not = reading.why_not;
  report.generator = reading.generator;
  with_parts(reading, [&](const auto& parts) { fill(report, parts, degree, Writer{reading}); });
  return report;
}

}  // namespace shortfall
