// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/motion/agreement.hpp"
#include "analysis/program/program.hpp"
#include "analysis/series/one_step.hpp"
#include "analysis/series/tableau_series.hpp"

namespace shortfall {

/// An integrator made ready for series: which numbers its coefficients are, and what was done to it.
///
/// Coefficients are rational numbers, or rational functions whose letters are roots (an open NumberField says
/// how they multiply). Decimals that stand for other numbers are taken as they are printed; `digits` then
/// says how far a zero can be trusted.
class SeriesSource {
 public:
  /// throws  Unable    for functions of h in the step
  ///         BadInput  for a value of an unknown parameter
  SeriesSource(const Program& program, const Values& given);

  const Program& program() const { return program_; }
  const Tape& tape() const { return tape_; }
  /// Values of parameters: what was given, and what was switched off.
  const Values& values() const { return values_; }
  bool rational() const { return !extras_; }
  /// What the reader has to know: "with c = 0: ..." and the like.
  const std::vector<std::string>& notes() const { return notes_; }
  int digits() const { return printed_digits(program_); }  ///< 0: exact
  /// Whether a difference is zero, as far as the coefficients are known.
  bool zero(const Fraction& difference) const;

  /// The names of letters in coefficients.
  std::vector<std::string> letters() const;
  const std::vector<ExtraLetters::Extra>& extras() const;
  /// A coefficient as a formula of the language, and as a decimal.
  Expr formula(const Fraction& coefficient) const;
  std::string decimal(const Fraction& coefficient, int digits = 10) const;
  double to_double(const Fraction& coefficient) const;

  /// The step for y' = f(y) needs a tableau.
  bool has_tableau() const { return program_.tableau.has_value(); }
  /// The entries of the tableau.  K is Rational (when rational()) or Fraction.
  template <class K>
  ButcherTableau<K> tableau() const;
  /// The weights of the program's `splitting` block; empty without one.
  std::vector<Fraction> splitting_weights() const;

  /// The step in the trees of a table: mechanical signatures by running it, others by its tableau.
  ///
  /// param   force  what the step is given instead of a (mechanical signatures only); null for a itself
  template <class K>
  OneStep<K> step(const TreeTable& table, const TreeSeries<K>* force = nullptr) const;

 private:
  Rational approximate(const Fraction& coefficient) const;
  Fraction entry(const Expr& e) const;

  Program program_;
  Values values_;
  Tape tape_;
  std::vector<std::string> notes_;
  std::unique_ptr<NumberField> field_;
  std::shared_ptr<ExtraLetters> extras_;
};

/// Calls use.template operator()<K>() with the type of a source's coefficients.
template <class Use>
decltype(auto) with_coefficients(const SeriesSource& source, Use&& use) {
  if (source.rational()) return use.template operator()<Rational>();
  return use.template operator()<Fraction>();
}

}  // namespace shortfall
