// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/step_series.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// Whether an integrator is for x'' = a alone, with these values.
bool solves_plainly(const Program& program, const Values& given) {
  const NumberField field;
  ExtraLetters extras(letter_names(lower(program, given)));
  const OwnEquation own = own_equation(program, given, extras);
  return own.stiffness.is_zero() && own.damping.is_zero();
}

/// An integrator with a damping of its own, without it: it solves another equation otherwise.
Values without_own_damping(const Program& program, Values given, std::vector<std::string>& notes) {
  if (!program.solves) return given;
  const Values values = parameter_values(program, given);
  if (solves_plainly(program, values)) return given;
  const NumberField field;
  ExtraLetters extras(letter_names(lower(program)));
  for (const std::string& name : own_equation(program, {}, extras).parameters) {
    Values plain = given;
    plain[name] = 0;
    if (!solves_plainly(program, parameter_values(program, plain))) continue;
    if (given.contains(name))
      throw Unable("with " + name + " = " + given.at(name).str() +
                   " the step is for an equation with a damping of its own, and its series is made for " +
                   name + " = 0 only");
    notes.push_back("with " + name + " = 0; with " + name + " = " + values.at(name).significant(4) +
                    ", the default, it solves an equation with a damping of its own");
    return plain;
  }
  throw Unable("the step has a damping or a spring of its own, which no parameter switches off");
}

/// A parameter with a unit of time sets a scale of its own, against which h is measured; then a power of h
/// does not follow from the order of a tree. It may stand there if nothing depends on it.
template <class Step>
void check_scales(const Program& program, const Values& given, const Step& step) {
  for (const Parameter& p : program.parameters) {
    // Lengths and speeds are limits that never act here.
    if (p.dimension.length != 0 || p.dimension.time == 0) continue;
    Values other = given;
    other[p.name] = parameter_values(program, given).at(p.name) * Rational(7, 5);
    if (other[p.name].is_zero()) continue;
    if (!step(given, other))
      throw Unable("the step depends on " + p.name + " (" + p.dimension.str() +
                   "), so that its series is not one in powers of h; " + p.name +
                   " = 0 is what can be asked for");
  }
}

/// What numbers printed to so many digits cannot tell from zero; two digits are allowed for what a sum loses.
Rational tolerance(int digits) {
  return digits > 2 ? Rational(1) / Rational(10).pow(digits - 2) : Rational();
}

bool is_rational(const Tape& tape, const TreeTable& table, int digits) {
  try {
    SmoothForce<Rational> problem(table);
    problem.tolerance = tolerance(digits);
    one_step<Rational>(tape, problem, table);
  } catch (const Undefined&) {
    throw;
  } catch (const Unable&) {
    return false;
  }
  return true;
}

constexpr int kWorkingDigits = 60;

}  // namespace

SeriesSource::SeriesSource(const Program& program, const Values& given) : program_(undisturbed(program)) {
  values_ = without_own_damping(program_, given, notes_);
  tape_ = lower(program_, values_);
  const TreeTable table(Signature::mechanical(true, true), 2);
  if (!is_rational(tape_, table, digits())) {
    field_ = std::make_unique<NumberField>();
    extras_ = std::make_shared<ExtraLetters>(letter_names(tape_));
    step<Fraction>(table);  // says what it cannot do, and finds the roots
    for (const ExtraLetters::Extra& e : extras_->all())
      if (!e.root) throw Unable("the step calls " + e.name + ", and its series is not made");
  }
  check_scales(program_, values_, [&](const Values& one, const Values& other) {
    const auto map = [&](const Values& values) {
      SmoothForce<Fraction> problem(table);
      problem.extras = extras_;
      problem.tolerance = tolerance(digits());
      return one_step<Fraction>(lower(program_, values), problem, table).map;
    };
    return map(one) == map(other);
  });
  for (const Tape::Limit& limit : tape_.limits) notes_.push_back("'" + limit.text + "' never acts");
  for (const Tape::When& when : tape_.whens) notes_.push_back("'" + when.text + "' always holds");
}

bool SeriesSource::zero(const Fraction& difference) const {
  Agreement agreement(program_);
  agreement.add(difference);
  return agreement.holds();
}

std::vector<std::string> SeriesSource::letters() const {
  return extras_ ? extras_->names() : letter_names(tape_);
}

const std::vector<ExtraLetters::Extra>& SeriesSource::extras() const {
  static const std::vector<ExtraLetters::Extra> none;
  return extras_ ? extras_->all() : none;
}

Expr SeriesSource::formula(const Fraction& coefficient) const {
  return shortfall::formula(coefficient, Wording{letters()});
}

Rational SeriesSource::approximate(const Fraction& coefficient) const {
  if (coefficient.is_constant()) return coefficient.constant();
  std::map<Letter, Rational> values;
  for (const ExtraLetters::Extra& e : extras()) values[e.letter] = near(*e.root, kWorkingDigits);
  return coefficient.evaluate(values);
}

std::string SeriesSource::decimal(const Fraction& coefficient, int digits) const {
  return approximate(coefficient).significant(digits);
}

double SeriesSource::to_double(const Fraction& coefficient) const {
  return approximate(coefficient).to_double();
}

Fraction SeriesSource::entry(const Expr& e) const {
  return scalar_value(e, formula_scalars(program_, parameter_values(program_, values_), extras_.get()),
                      extras_.get());
}

template <class K>
ButcherTableau<K> SeriesSource::tableau() const {
  if (!program_.tableau) throw Unable(program_.name + " is not written as a tableau");
  const Tableau& t = *program_.tableau;
  const std::size_t stages = t.b.size();
  const auto value = [&](const Expr& e) {
    if constexpr (std::is_same_v<K, Fraction>)
      return entry(e);
    else
      return entry(e).constant();
  };
  ButcherTableau<K> result;
  for (std::size_t i = 0; i < stages; ++i) {
    result.a.emplace_back(stages, K(0));
    for (std::size_t j = 0; j < t.a[i].size(); ++j) result.a[i][j] = value(t.a[i][j]);
    result.b.push_back(value(t.b[i]));
    result.c.push_back(value(t.c[i]));
  }
  for (const Expr& e : t.embedded) result.embedded.push_back(value(e));
  return result;
}

std::vector<Fraction> SeriesSource::splitting_weights() const {
  std::vector<Fraction> weights;
  if (program_.splitting)
    for (const Splitting::Part& part : program_.splitting->parts) weights.push_back(entry(part.weight));
  return weights;
}

template <class K>
OneStep<K> SeriesSource::step(const TreeTable& table, const TreeSeries<K>* force) const {
  const Signature& s = table.signature();
  if (s == Signature::first_order() || s == Signature::first_order_with_time()) {
    OneStep<K> result;
    const ButcherTableau<K> t = tableau<K>();
    result.map = ElementaryWeights<K>(t, table).result(t.b);
    result.field = logarithm(table, result.map);
    result.start.assign(table.size(), K(0));
    return result;
  }
  SmoothForce<K> problem(table);
  if constexpr (std::is_same_v<K, Fraction>) problem.extras = extras_;
  problem.given = force;
  problem.tolerance = tolerance(digits());
  return one_step<K>(tape_, problem, table);
}

template ButcherTableau<Rational> SeriesSource::tableau() const;
template ButcherTableau<Fraction> SeriesSource::tableau() const;
template OneStep<Rational> SeriesSource::step(const TreeTable&, const TreeSeries<Rational>*) const;
template OneStep<Fraction> SeriesSource::step(const TreeTable&, const TreeSeries<Fraction>*) const;

}  // namespace shortfall
