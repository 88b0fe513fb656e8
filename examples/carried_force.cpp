// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that carries its force from frame to frame and weights the old and the new one: a state and a
// parameter.
#include <iostream>
#include <shortfall/analysis/motion/derivation.hpp>
#include <shortfall/analysis/program/print.hpp>
#include <shortfall/analysis/program/traced.hpp>

int main() {
  using namespace shortfall;
  const Program mine = Tracing("carried-force")
                           .parameter("theta", Rational(1, 2))
                           .state("a0", "L/T^2")
                           .start([](auto& x, auto& v, auto t, auto, auto a, auto& carried) {
                             carried.vector("a0") = a(x, v, t);
                           })
                           .step([](auto& x, auto& v, auto t, auto h, auto a, auto& carried) {
                             auto& a0 = carried.vector("a0");
                             const auto theta = carried.number("theta");
                             x += h * v + h * h / 2 * a0;
                             const auto a1 = a(x, v, t + h);
                             v += h * ((1 - theta) * a0 + theta * a1);
                             a0 = a1;
                           });
  std::cout << print(mine) << "\n";
  const Derivation d = derivation(mine, 1);  // a force f0 + f1 t, for every theta
  std::cout << "shortfall of the velocity: " << print(d.shortfall_velocity) << "\n"
            << (d.proved() ? "proved\n" : "not proved\n");
}
