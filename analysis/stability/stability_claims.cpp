// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_claims.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/program/print.hpp"
#include "analysis/series/order_claims.hpp"
#include "analysis/stability/radicals.hpp"
#include "analysis/stability/stability.hpp"

namespace shortfall {

namespace {

/// The letter of z = h w; a step's matrix does not contain the letter of time.
constexpr Letter kPhase = kTimeLetter;

/// A claim's expression as a function of z and the parameters, in units of the step (h = 1). Functions keep
/// their h, as they do in the step: pow(1 - c, h) is a letter.
Fraction value_of(const Claim& claim, const Program& program, ExtraLetters& extras) {
  FormulaScalars scalars = formula_scalars(program, {}, &extras);
  scalars["z"] = Fraction::letter(kPhase);
  scalars["w"] = Fraction::letter(kPhase) / Fraction::letter(kStepLetter);
  return scalar_value(claim.value, scalars, &extras).substitute(kStepLetter, Fraction(1));
}

ClaimVerdict matrix_verdict(const Program& program, const Claim& claim) {
  const StepMap map = step_map(lower(program), -1, Fraction::letter(kStiffness));
  const NumberField field(map.generators);
  const Amplification a = amplification(program, {}, Damping::none, FreeFunctions::letters);
  const Fraction found = (claim.word == "trace" ? a.trace() : a.determinant())
                             .substitute(kStiffness, Fraction::letter(kPhase, 2));
  const Fraction claimed = value_of(claim, program, *map.force.extras);
  std::vector<std::string> names = map.letters;
  names[kPhase] = "z";
  Agreement agreement(program);
  agreement.add(claimed - found);
  return {claim.word + " " + print(claim.value), agreement.holds(),
          claim.word + " " + print(formula(found, Wording{names})), agreement.digits()};
}

/// Digits after the point of a decimal; none when it has no finite number of them.
std::optional<int> decimal_places(Rational value) {
  for (int places = 0; places <= 100; ++places, value *= Rational(10))
    if (value.is_integer()) return places;
  return std::nullopt;
}

/// Whether a number made of rational numbers and square roots is this one: it solves the number's polynomial,
/// and lies in its interval.
bool equals(const Expr& value, const Program& program, const RealRoot& number) {
  NumberField field;
  ExtraLetters extras({"n", "h", "t", "k", "c"});
  const Fraction f = value_of({"limit", value, {}}, program, extras);
  if (!f.is_polynomial()) return false;
  Fraction at;
  for (int k = number.degree(); k >= 0; --k) at = at * f + Fraction(number.polynomial()[k]);
  if (!at.is_zero()) return false;
  // Which of the polynomial's roots it is: 40 digits tell them apart.
  constexpr int kDigits = 40;
  std::map<Letter, Rational> values;
  for (const ExtraLetters::Extra& e : extras.all()) {
    if (!e.root) return false;
    const RealRoot fine = e.root->refined(Rational(1) / Rational(10).pow(kDigits + 10));
    values[e.letter] = (fine.low() + fine.high()) / Rational(2);
  }
  const Rational near = f.evaluate(values), width = Rational(1) / Rational(10).pow(kDigits);
  return number.compare(near - width) > 0 && number.compare(near + width) < 0;
}

ClaimVerdict limit_verdict(const Program& program, const Claim& claim) {
  const std::optional<RealRoot> limit = stability_limit(program);
  ClaimVerdict verdict{claim.word + " " + print_decimals(claim.value), false, {}, printed_digits(program)};
  const bool infinite = claim.value->op == Expression::Op::name && claim.value->name == "infinity";
  if (!limit || infinite) {
    verdict.holds = !limit && infinite;
    verdict.found = limit ? "limit " + limit->significant(20) : "limit infinity";
    return verdict;
  }
  const auto formula = radical_formula(*limit);
  verdict.found = "limit " + (formula ? print(*formula) : limit->significant(20));
  const Rational decimal = claim.value->op == Expression::Op::number ? claim.value->value : Rational();
  const auto places = decimal_places(decimal);
  if (!decimal.is_integer() && places) {  // agrees to the digits printed
    const Rational unit = Rational(1) / Rational(10).pow(*places);
    verdict.holds = limit->compare(decimal - unit) > 0 && limit->compare(decimal + unit) < 0;
    if (program.approximate()) verdict.digits = std::min(verdict.digits, *places);
  } else {
    verdict.holds = equals(claim.value, program, *limit);
  }
  return verdict;
}

bool about_oscillator(const Claim& claim) {
  return claim.word == "trace" || claim.word == "determinant" || claim.word == "limit";
}

}  // namespace

std::vector<ClaimVerdict> stability_claims(const Program& program) {
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : program.claims)
    if (about_oscillator(claim))
      verdicts.push_back(claim.word == "limit" ? limit_verdict(program, claim)
                                               : matrix_verdict(program, claim));
  return verdicts;
}

std::vector<ClaimVerdict> all_claims(const Program& program) {
  const std::vector<ClaimVerdict> motion = claims(program), oscillator = stability_claims(program),
                                  series = order_claims(program);
  std::vector<ClaimVerdict> verdicts;
  auto m = motion.begin(), o = oscillator.begin(), s = series.begin();
  for (const Claim& claim : program.claims)
    verdicts.push_back(about_oscillator(claim) ? *o++ : about_series(claim) ? *s++ : *m++);
  return verdicts;
}

}  // namespace shortfall
