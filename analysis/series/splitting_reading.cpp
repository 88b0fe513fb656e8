// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_reading.hpp"

#include <optional>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/kick_drift_forms.hpp"

namespace shortfall {

namespace {

/// The coefficient of a column, which has to be a multiple of one power of h.
template <class Field>
Field only_power(const KickDriftForm<Field>& form, std::size_t column, int power, const char* what) {
  const auto s = form[column];
  for (int k = 0; k <= s.degree(); ++k)
    if (k != power && !zero_as_known(s[k])) throw Unable(std::string(what) + " contains other powers of h");
  return form.at(column, power);
}

template <class Field>
SplittingParts<Field> parts_of(const KickDriftForms<Field>& problem, const KickDriftForm<Field>& x,
                               const KickDriftForm<Field>& v, bool& in_time) {
  const auto& evaluations = problem.evaluations;
  if (!zero_as_known(only_power(x, 0, 0, "the new position") - Field(1)) ||
      !zero_as_known(only_power(v, 1, 0, "the new velocity") - Field(1)) ||
      !KickDriftForm<Field>().agrees(v[0] * KickDriftForm<Field>::column(0)))
    throw Unable("it scales a position or a velocity, or adds a position to a velocity");
  std::vector<Field> kicks, covered;
  for (std::size_t k = 0; k < evaluations.size(); ++k)
    kicks.push_back(only_power(v, 2 + k, 1, "the new velocity"));
  // How far the drifts have come at a position, which has to follow from the kicks before it.
  const auto covered_by = [&](const KickDriftForm<Field>& at, std::size_t count, const std::string& what) {
    if (!zero_as_known(only_power(at, 0, 0, what.c_str()) - Field(1)))
      throw Unable(what + " is a multiple of the old one");
    Field c = only_power(at, 1, 1, what.c_str());
    for (std::size_t j = 0; j < count; ++j)
      if (!zero_as_known(only_power(at, 2 + j, 2, what.c_str()) - kicks[j] * (c - covered[j])))
        throw Unable("no kicks and drifts lead to " + what);
    return c;
  };
  SplittingParts<Field> parts;
  // A drift that is 0 to the digits known is none.
  const auto append_drift = [&](Field weight) {
    if (!zero_as_known(weight)) parts.push_back({false, std::move(weight)});
  };
  Field reached(0);
  for (std::size_t k = 0; k < evaluations.size(); ++k) {
    if (kicks[k].is_zero()) {
      covered.push_back(Field(0));  // no kick: later positions must not contain this force
      continue;
    }
    covered.push_back(
        covered_by(evaluations[k].x, k, "the position of force evaluation " + std::to_string(k + 1)));
    in_time = in_time && evaluations[k].in_time;
    append_drift(covered[k] - reached);
    parts.push_back({true, kicks[k]});
    reached = covered[k];
  }
  append_drift(covered_by(x, evaluations.size(), "the new position") - reached);
  return merged(parts);
}

/// What a step carries besides x and v, as a function of them: coefficients of x, v and the force at x.
template <class Field>
using Carried = std::vector<KickDriftForm<Field>>;

/// The state after `start` by the position and velocity that it left.
template <class Field>
Carried<Field> carried_by_start(const Tape& tape, const KickDriftForms<Field>& problem,
                                const Run<KickDriftForms<Field>>& run) {
  using Form = KickDriftForm<Field>;
  Carried<Field> result;
  const Form moved = run.state(1) - Form::column(1);
  for (std::size_t k = 2; k < tape.states.size(); ++k) {
    if (!run.state(0).agrees(Form::column(0)))
      throw Unable("its start moves the body and carries " + tape.states[k] + " besides");
    const Form form = run.state(static_cast<int>(k)) - run.state(static_cast<int>(k))[1] * moved;
    Form known;
    for (std::size_t column = 0; column < 3; ++column) known = known + form[column] * Form::column(column);
    const bool elsewhere = !form[2].is_zero() && !problem.evaluations[0].x.agrees(Form::column(0));
    if (elsewhere || !known.agrees(form))
      throw Unable("it remembers more than a position and a velocity: " + tape.states[k]);
    result.push_back(std::move(known));
  }
  return result;
}

template <class Field>
KicksAndDrifts<Field> read(const Tape& tape, const SplittingNumbers<Field>& numbers) {
  using Form = KickDriftForm<Field>;
  using Scalar = Univariate<Field>;
  const Form x0 = Form::column(0), v0 = Form::column(1);
  const Scalar h({Field(0), Field(1)});
  KicksAndDrifts<Field> result;
  bool& in_time = result.time_follows_drifts;

  KickDriftForms<Field> problem{numbers, {}};
  Run run(tape, problem, h);
  run.begin(x0, v0, Scalar());
  result.start = parts_of(problem, run.state(0), run.state(1), in_time);
  const Carried<Field> carried = carried_by_start(tape, problem, run);
  const auto put_back = [&] {
    problem.evaluations.clear();
    run.set_time(Scalar());
    run.set_state(0, x0);
    run.set_state(1, v0);
    for (std::size_t k = 0; k < carried.size(); ++k) {
      if (!carried[k][2].is_zero()) problem.acceleration(x0, v0, Scalar());  // column 2 from here on
      run.set_state(static_cast<int>(2 + k), carried[k]);
    }
  };

  put_back();
  run.step();
  const Form x1 = run.state(0), v1 = run.state(1);
  for (std::size_t k = 0; k < carried.size(); ++k) {
    Form expected = carried[k][0] * x1 + carried[k][1] * v1;
    if (!carried[k][2].is_zero()) expected = expected + carried[k][2] * problem.acceleration(x1, v1, h);
    if (!expected.agrees(run.state(static_cast<int>(2 + k))))
      throw Unable("it remembers more than a position and a velocity: " + tape.states[2 + k]);
  }
  result.step = parts_of(problem, x1, v1, in_time);

  put_back();
  const auto [x, v] = run.read_out();
  result.finish = parts_of(problem, x, v, in_time);
  return result;
}

/// Published decimals as parameters, so that a run can give them their digits.
Program with_parameters(const Program& program) {
  Program result = program;
  for (const Approximation& a : program.approximations)
    result.parameters.push_back({a.name, Dimension(), number(a.value), a.place});
  result.approximations.clear();
  return result;
}

std::string generator_name(const Program& program, const RealRoot& value) {
  for (const Root& r : program.roots)
    if (r.value->degree() == value.degree() && *r.value == value) return r.name;
  if (const auto square = value.rational_square()) return "sqrt(" + square->str() + ")";
  return "r";
}

SplittingReading read_any(const Program& program, const Values& given) {
  SplittingReading result;
  const auto digits = [&] {
    SplittingNumbers<KnownDigits> numbers{static_cast<int>(program.parameters.size()), {}};
    for (const Approximation& a : program.approximations)
      numbers.published.push_back(KnownDigits::printed(a.text));
    result.parts = read(lower(with_parameters(program), given), numbers);
    return result;
  };
  if (program.approximate()) return digits();
  const Tape tape = lower(program, given);
  try {
    result.parts = read(tape, SplittingNumbers<Rational>());
    return result;
  } catch (const FieldTooSmall& more) {
    result.generator_value = std::make_shared<const RealRoot>(*more.wanted);
  }
  try {
    result.parts = read(tape, SplittingNumbers<Algebraic>{result.generator_value});
    result.generator = generator_name(program, *result.generator_value);
    return result;
  } catch (const FieldTooSmall&) {
    result.generator_value.reset();
  }
  return digits();
}

}  // namespace

SplittingReading splitting_reading(const Program& program, const Values& given) {
  try {
    return read_any(undisturbed(program), given);
  } catch (const Unable& reason) {
    SplittingReading result;
    result.why_not = reason.what();
    return result;
  }
}

}  // namespace shortfall
