// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/free_flight.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/kick_drift_forms.hpp"

namespace shortfall {

namespace {

using Form = KickDriftForm<KnownDigits>;
using Scalar = Form::Scalar;

StepSums sums(const Program& program, const Values& given) {
  // Printed decimals are parameters here, so that they can be balls.
  Program open = program;
  SplittingNumbers<KnownDigits> numbers{static_cast<int>(program.parameters.size()), {}};
  for (const Approximation& a : program.approximations) {
    open.parameters.push_back({a.name, Dimension(), number(a.value), a.place});
    numbers.published.push_back(KnownDigits::printed(a.text));
  }
  open.approximations.clear();
  const Tape tape = lower(open, given);
  KickDriftForms<KnownDigits> problem{numbers, {}};
  Run run(tape, problem, Scalar({KnownDigits(0), KnownDigits(1)}));
  run.begin(Form::column(0), Form::column(1), Scalar());
  // The second step, as it is reported: a start may have put velocities half a step aside.
  run.step();
  const auto [x1, v1] = run.read_out();
  run.step();
  const auto [x2, v2] = run.read_out();
  StepSums result{x2.at(1, 1) - x1.at(1, 1), KnownDigits(0)};
  for (std::size_t k = 2; k < v2.columns(); ++k) result.kick += v2.at(k, 1) - v1.at(k, 1);
  return result;
}

}  // namespace

std::optional<StepSums> step_sums(const Program& program, const Values& given) {
  try {
    return sums(undisturbed(program), given);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace shortfall
