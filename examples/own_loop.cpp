// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of a game, written once: it runs in floats, and shortfall derives from the same lines what it gets
// wrong.
#include <iostream>
#include <shortfall/analysis/correction/kit.hpp>
#include <shortfall/analysis/program/print.hpp>
#include <shortfall/analysis/program/traced.hpp>

int main() {
  const auto loop = [](auto& x, auto& v, auto t, auto h, auto a) {
    v += h * a(x, v, t);
    x += h * v;
  };

  // In floats: a jump that is meant to be 1.7 m high.
  const auto gravity = [](float, float, float) { return -9.81f; };
  float x = 0, v = 5.775292f, top = 0;
  for (int i = 0; i<60; ++i, top = x> top ? x : top) loop(x, v, float(i) * 0.02f, 0.02f, gravity);
  std::cout << "the loop jumps " << top << " m high\n";

  // In letters: why, and what to add.
  using namespace shortfall;
  const Derivation d = derivation(traced("own-loop", loop), 0);
  std::cout << "it falls short by " << print(d.shortfall_position) << "\n";
  const CorrectionKit kit = correction_kit(d);
  for (const Correction& c : kit.best()->corrections)
    std::cout << "add to " << c.target << ": " << print(c.add) << "\n";
}
