// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <random>

#include "analysis/algebra/real.hpp"
#include "analysis/motion/closed_form.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"
#include "tests/motion/random_integrator.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;
using shortfall::testing::Chance;

namespace {

constexpr int kHighestDegree = 6;
constexpr int kSteps = 12;
constexpr int kRoundedDigits = 100;

/// Whether letters stand for pow(1 - c, h) and the like, which have no value in rational numbers.
bool calls_functions(const Program& program) { return !step_map(lower(program), 0).extras.empty(); }

/// Everything that is a letter in a closed form, as numbers.
struct Trial {
  Rational x0, v0, h;
  std::vector<Rational> force;  ///< f0, f1, ...
  Values parameters;

  Trial(Chance& chance, const Program& program, int degree)
      : x0(chance.rational()), v0(chance.rational()), h(chance.rational().abs() + Rational(1, 10)) {
    for (int d = 0; d <= degree; ++d) force.push_back(chance.rational());
    // Some parameters get values, the others keep their defaults, also those that follow from others and
    // those that rational numbers cannot follow.
    if (calls_functions(program)) {
      parameters = parameter_values(program);
      return;
    }
    const Tape tape = lower(program);
    for (std::size_t i = 0; i < program.parameters.size(); ++i) {
      const std::string& name = program.parameters[i].name;
      if (tape.parameters[i].fixed)
        parameters[name] = chance.number(1, 3);
      else if (!program.assumptions
                    .empty())  // formulas divide by a damping; what is assumed holds for small ones
        parameters[name] = Rational(chance.number(1, 9), 1000);
      else if (chance.once_in(2))
        parameters[name] = chance.rational();
    }
  }
};

/// The position's (or velocity's) value at the numbers of a trial, by the closed form.
Rational value(const ClosedForm& form, bool position, int n, const Trial& trial,
               std::map<Letter, Rational> letters) {
  const Motion& motion = position ? form.position : form.velocity;
  letters[kCount] = n;
  Rational sum;
  for (std::size_t column = 0; column < motion.size(); ++column) {
    const Rational& amount = column == 0 ? trial.x0 : column == 1 ? trial.v0 : trial.force[column - 2];
    for (const Sequence::Term& term : motion[column].terms())
      sum += amount * term.coefficient.evaluate(letters) * term.base.evaluate(letters).pow(n);
    if (form.oscillation.is_zero()) continue;
    const auto& first = position ? form.oscillation.position : form.oscillation.velocity;
    sum += amount * form.oscillation.at(first[column], n).evaluate(letters);
  }
  return sum;
}

/// x and v read out after 0..kSteps steps, in any kind of number.
template <class T>
std::vector<std::pair<T, T>> stepped(const Program& program, const Trial& trial,
                                     std::function<T(const Rational&)> round) {
  Numbers<T> problem;
  problem.round = round;
  std::vector<T> force;
  for (const Rational& f : trial.force) force.push_back(round(f));
  problem.force = [&force](const T&, const T&, const T& t) {
    T sum = force.back();
    for (std::size_t d = force.size() - 1; d-- > 0;) sum = sum * t + force[d];
    return sum;
  };
  const Tape tape = lower(program, trial.parameters);
  Run<Numbers<T>> run(tape, problem, round(trial.h));
  run.begin(round(trial.x0), round(trial.v0), round(0));
  std::vector<std::pair<T, T>> result{run.read_out()};
  for (int n = 1; n <= kSteps; ++n) {
    run.step();
    result.push_back(run.read_out());
  }
  return result;
}

struct Count {
  int exact = 0;
  int rounded = 0;
  int undefined = 0;
};

/// Holds a closed form, its parameters kept as letters, against stepping in rationals and at 100 digits.
/// Programs with irrational coefficients are stepped with 100 digits only.
void validate(const Program& program, const StepMap& map, const ClosedForm& form, const Trial& trial,
              Count& count) {
  std::map<Letter, Rational> letters{{kStepLetter, trial.h}};
  for (const ExtraLetters::Extra& e : map.extras) {
    if (!e.root) return;  // exp and pow of a random step are no rational numbers
    const RealRoot fine = e.root->refined(Rational(1) / Rational(10).pow(kRoundedDigits + 30));
    letters[e.letter] = (fine.low() + fine.high()) / Rational(2);
  }
  const Values values = parameter_values(program, trial.parameters);
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    letters[kFirstParameter + static_cast<Letter>(i)] = values.at(program.parameters[i].name);

  const bool rational = map.extras.empty();
  std::vector<std::pair<Rational, Rational>> exact;
  if (rational) exact = stepped<Rational>(program, trial, [](const Rational& r) { return r; });
  const auto rounded =
      stepped<Real>(program, trial, [](const Rational& r) { return real(r, kRoundedDigits); });
  Rational largest = 1;
  for (int n = form.valid_from; n <= kSteps; ++n)
    largest = std::max(
        {largest, value(form, true, n, trial, letters).abs(), value(form, false, n, trial, letters).abs()});
  // A few hundred roundings of 10^-100 each, and what cancels between them: ten digits are more than enough.
  const Real bound = real(largest * Rational(10).pow(10 - kRoundedDigits), kRoundedDigits);
  for (int n = form.valid_from; n <= kSteps; ++n) {
    CAPTURE(n);
    const Rational x = value(form, true, n, trial, letters);
    const Rational v = value(form, false, n, trial, letters);
    if (rational) {
      CHECK(x == exact[n].first);
      CHECK(v == exact[n].second);
    }
    CHECK(abs(Real(rounded[n].first - real(x, kRoundedDigits))) <= bound);
    CHECK(abs(Real(rounded[n].second - real(v, kRoundedDigits))) <= bound);
    ++count.exact;
    ++count.rounded;
  }
}

/// With letters for the parameters that the trial leaves alone and for those that it gives: a closed form of
/// the program as it stands.
void validate_letters(const Program& program, int degree, Chance& chance, int trials, Count& count) {
  CAPTURE(program.name);
  CAPTURE(degree);
  const Values given = calls_functions(program) ? parameter_values(program) : Values();
  const StepMap map = step_map(lower(program, given), degree);
  const NumberField field(map.generators);
  const ClosedForm form = closed_form(map);
  for (int k = 0; k < trials; ++k) {
    Trial trial(chance, program, degree);
    // A default that follows from others is no letter, nor is a number of substeps: they must not be given.
    const Tape tape = lower(program);
    for (const Tape::ParameterSlot& slot : tape.parameters)
      if (slot.derived || slot.fixed) trial.parameters.erase(slot.name);
    try {
      validate(program, map, form, trial, count);
    } catch (const Undefined&) {  // the numbers drawn make a stage singular
      ++count.undefined;
    }
  }
}

}  // namespace

TEST_CASE(
    "closed forms of the catalogue agree with stepping, exactly in rationals and to rounding at 100 digits" *
    doctest::test_suite("thorough")) {
  const Precision digits(kRoundedDigits);
  Chance chance(20);
  Count count;
  for (const Program& program : testing::undamped_catalogue())
    for (int degree = 0; degree <= kHighestDegree; ++degree)
      validate_letters(program, degree, chance, 4, count);
  CHECK(count.exact >= 44 * 7 * 4 * kSteps * 9 / 10);
  CHECK(count.undefined <= 16);
}

TEST_CASE("closed forms with parameters that the user gives agree with stepping") {
  const Precision digits(kRoundedDigits);
  Chance chance(21);
  Count count;
  for (const Program& program : testing::undamped_catalogue()) {
    if (program.parameters.empty()) continue;
    for (int k = 0; k < 10; ++k) {
      const int degree = chance.number(0, kHighestDegree);
      const Trial trial(chance, program, degree);
      CAPTURE(program.name);
      try {
        const StepMap map = step_map(lower(program, trial.parameters), degree);
        const NumberField field(map.generators);
        validate(program, map, closed_form(map), trial, count);
      } catch (const Undefined&) {
        ++count.undefined;
      }
    }
  }
  CHECK(count.exact >= 100);
}

TEST_CASE("closed forms of integrators that a user may write agree with stepping") {
  const Precision digits(kRoundedDigits);
  Chance chance(22);
  for (const auto& [what, written] : testing::random_integrators(chance, 60)) {
    const std::string text = written;
    CAPTURE(text);
    const Program program = parse(text, what + ".integrator");
    Count count;
    validate_letters(program, chance.number(0, kHighestDegree), chance, 4, count);
    CHECK(count.exact >= kSteps);
  }
}
