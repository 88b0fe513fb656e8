// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/twin.hpp"

#include <optional>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/free_force.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

using Step = std::pair<FreeVector, FreeVector>;

/// Position and velocity after one step, started as the integrator starts; none when what it carries then is
/// not what it would start with there.
std::optional<Step> one_step_of(const Program& program, FreeForce& force, const Fraction& h,
                                const Fraction& t) {
  const Tape tape = lower(program, parameter_values(program));
  Run<FreeForce> run(tape, force, h), again(tape, force, h);
  run.begin(FreeVector::x(), FreeVector::v(), t);
  run.step();
  Step step = run.read_out();
  again.begin(step.first, step.second, t + h);
  for (std::size_t s = 0; s < tape.states.size(); ++s)
    if (!(run.state(static_cast<int>(s)) == again.state(static_cast<int>(s)))) return std::nullopt;
  return step;
}

}  // namespace

std::vector<std::string> processed_twins(const Program& program, const Values& given, const Rational& kick) {
  const Fraction h = Fraction::letter(kStepLetter), t = Fraction::letter(kTimeLetter);
  FreeForce force;
  Step step;
  try {
    const Program plain = undisturbed(program);
    const Tape tape = lower(plain, given);
    if (tape.states.size() > 2 || !tape.start.empty() || !tape.finish.empty()) return {};
    Run<FreeForce> run(tape, force, h);
    const Fraction weight = Fraction(kick) * h;
    run.begin(FreeVector::x(),
              FreeVector::v() + weight * force.acceleration(FreeVector::x(), FreeVector::v(), t), t);
    run.step();
    step = run.read_out();
    step.second = step.second - weight * force.acceleration(step.first, step.second, t + h);
  } catch (const Error&) {
    return {};
  }
  std::vector<std::string> twins;
  for (const Program& other : catalogue()) {
    if (other.name == program.name || family(other) == "engines") continue;
    try {
      if (one_step_of(other, force, h, t) == step) twins.push_back(other.name);
    } catch (const Error&) {
      continue;  // not written out in formulas
    }
  }
  return twins;
}

}  // namespace shortfall
