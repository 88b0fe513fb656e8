// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Integrators that tests write out, and what their steps do.

#include <string>
#include <utility>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"

namespace shortfall::testing {

inline Program read(const std::string& head, const std::string& blocks) {
  return parse("integrator test\n" + head + "\n" + blocks + "\n", "test.integrator");
}

inline Program with_step(const std::string& step, const std::string& head = "") {
  return read(head, "step\n" + step);
}

/// x and v after steps from x = 1, v = 2 at t = 0 under a = t - x - v/2, which tells x, v and t apart.
template <class T>
std::pair<T, T> after(const Program& program, int steps, const T& h, const Values& values = {},
                      T impulse = T(0)) {
  const Tape tape = lower(program, values);
  Numbers<T> problem{[](const T& x, const T& v, const T& t) { return T(t - x - v / T(2)); }};
  Run<Numbers<T>> run(tape, problem, h);
  run.begin(T(1), T(2), T(0));
  if (tape.impulse >= 0) run.give_impulse(impulse);
  for (int n = 0; n < steps; ++n) run.step();
  return run.read_out();
}

}  // namespace shortfall::testing
