// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/verify.hpp"

#include <algorithm>

#include "analysis/motion/formula.hpp"

namespace shortfall {

namespace {

/// Numbers for the letters at which a nonzero function does not vanish: the smallest of a few simple choices.
std::map<Letter, Rational> telling_numbers(const Fraction& difference,
                                           const std::vector<std::string>& letters) {
  for (int shift = 0;; ++shift) {
    std::map<Letter, Rational> numbers;
    for (Letter letter = 0; letter < static_cast<int>(letters.size()); ++letter)
      numbers[letter] = Rational(letter + 1 + shift, 2 + letter * shift);
    numbers[kStepLetter] = Rational(1, 10 + shift);
    numbers[kCount] = 0;  // the number of steps is already put in
    try {
      if (!difference.evaluate(numbers).is_zero()) return numbers;
    } catch (const Undefined&) {
      // A denominator vanishes there; take the next.
    }
  }
}

}  // namespace

Verdict verdict(const Derivation& d, const Program& program, const Values& given, const Expr& claimed,
                bool position) {
  Verdict verdict;
  const Motion& truth = position ? d.form.position : d.form.velocity;
  verdict.found = position ? d.position : d.velocity;
  verdict.found_from = d.form.valid_from;
  const NumberField field(d.map.generators);
  ExtraLetters* extras = d.map.force.extras.get();
  const FormulaScalars scalars = formula_scalars(program, given, extras);
  const Motion motion = evaluated(claimed, scalars, d.degree, extras);
  verdict.gaps = formula_gaps(claimed, scalars, d.degree, extras);
  const bool equal = is_zero(motion - truth);
  const LinearForm& row = position ? d.map.position : d.map.velocity;
  // Two sequences of this kind that differ do so within as many consecutive n as they have coefficients;
  // before valid_from, only stepping counts.
  const auto states = stepped(d.map, d.form.valid_from);
  for (int n = 0;; ++n) {
    if (n >= d.form.valid_from && equal) break;
    if (std::ranges::find(verdict.gaps.counts, Rational(n)) != verdict.gaps.counts.end()) continue;
    for (std::size_t column = 0; column < motion.size(); ++column) {
      const int source =
          column < 2 ? static_cast<int>(column) : d.map.force.force_column(static_cast<int>(column) - 2);
      const Fraction computed = n < d.form.valid_from
                                    ? reported(row, states[n], n, d.map.force.states)[source]
                                    : truth[column].at(n);
      const Fraction said = motion[column].at(n);
      if (said == computed) continue;
      CounterExample example;
      example.n = n;
      const auto numbers = telling_numbers(said - computed, d.map.letters);
      // All other vectors are 0, so that the one that shows the difference stands alone.
      example.computed = computed.evaluate(numbers);
      example.claimed = said.evaluate(numbers);
      example.values["h"] = numbers.at(kStepLetter);
      for (std::size_t c = 0; c < motion.size(); ++c)
        example.values[column_name(static_cast<int>(c), d.degree)] = c == column ? 1 : 0;
      for (Letter letter = kFirstParameter; letter < static_cast<int>(d.map.letters.size()); ++letter)
        example.values[d.map.letters[letter]] =
            given.contains(d.map.letters[letter]) ? given.at(d.map.letters[letter]) : numbers.at(letter);
      verdict.counter_example = std::move(example);
      if (equal && d.proof.proved) verdict.holds_from = d.form.valid_from;
      return verdict;
    }
  }
  verdict.proved = d.proof.proved;
  return verdict;
}

}  // namespace shortfall
