// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/first_steps.hpp"

#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

namespace {

template <class T>
FirstSteps stepped(const Program& program, const Values& given, int count) {
  Numbers<T> problem;
  problem.force = [](const T& x, const T& v, const T& t) { return t - T(2) * x - T(0.25) * v; };
  const Tape tape = lower(program, given);
  const T dt = problem.number(Rational(1, 10));
  Run<Numbers<T>> run(tape, problem, dt);
  run.begin(T(0.5), T(-0.75), T(0));
  FirstSteps result{static_cast<double>(dt), {}, {}};
  for (int k = 0; k < count; ++k) {
    run.step();
    const auto [x, v] = run.read_out();
    result.x.push_back(static_cast<double>(x));
    result.v.push_back(static_cast<double>(v));
  }
  return result;
}

}  // namespace

FirstSteps first_steps(const Program& program, const Values& given, bool binary32, int count) {
  return binary32 ? stepped<float>(program, given, count) : stepped<double>(program, given, count);
}

}  // namespace shortfall
