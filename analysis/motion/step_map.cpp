// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/step_map.hpp"

#include "analysis/program/run.hpp"

namespace shortfall {

std::vector<std::vector<Fraction>> StepMap::matrix() const {
  std::vector<std::vector<Fraction>> m;
  for (const LinearForm& row : step) {
    m.emplace_back();
    for (int j = 0; j < force.states; ++j) m.back().push_back(row[j]);
  }
  return m;
}

StepMap step_map(const Tape& tape, int degree, Fraction stiffness, Fraction damping, const Fraction& h) {
  StepMap map;
  NumberField field;
  const auto extras = std::make_shared<ExtraLetters>(letter_names(tape));
  map.states = tape.states;
  const int states = static_cast<int>(tape.states.size());
  map.force = {states, degree, std::move(stiffness), std::move(damping), extras};
  Run<LinearForce> run(tape, map.force, h);

  run.begin(LinearForm::column(0), LinearForm::column(1), 0);
  for (int i = 0; i < states; ++i) map.start.push_back(run.state(i));

  const Fraction t = Fraction::letter(kCount) * h;
  for (int i = 0; i < states; ++i) run.set_state(i, LinearForm::column(i));
  run.set_time(t);
  std::tie(map.position, map.velocity) = run.read_out();
  run.step();
  for (int i = 0; i < states; ++i) map.step.push_back(run.state(i));
  map.letters = extras->names();
  map.extras = extras->all();
  map.generators = extras->generators();
  map.assumed = extras->used();
  for (const Tape::Limit& limit : tape.limits) map.assumed.push_back("'" + limit.text + "' never acts");
  for (const Tape::When& when : tape.whens) map.assumed.push_back("'" + when.text + "' always holds");
  if (tape.impulse >= 0) map.assumed.push_back("no impulse is given");
  return map;
}

LinearForm reported(const LinearForm& row, const std::vector<LinearForm>& state, int n, int states) {
  LinearForm result;
  for (int c = 0; c < row.columns(); ++c) {
    if (row[c].is_zero()) continue;
    const Fraction coefficient = row[c].contains(kCount) ? row[c].substitute(kCount, Fraction(n)) : row[c];
    if (c < states)
      result += coefficient * state[c];
    else
      result.at(c) += coefficient;
  }
  return result;
}

std::vector<std::vector<LinearForm>> stepped(const StepMap& map, int steps, const Progress& progress) {
  std::vector<std::vector<LinearForm>> states{map.start};
  for (int n = 0; n < steps; ++n) {
    if (progress) progress("stepping in letters", n, steps);
    std::vector<LinearForm> next;
    for (const LinearForm& row : map.step) next.push_back(reported(row, states.back(), n, map.force.states));
    states.push_back(std::move(next));
  }
  return states;
}

}  // namespace shortfall
