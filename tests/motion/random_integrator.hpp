// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall::testing {

/// Small random numbers from a fixed seed, the same on every machine.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  int number(int from, int to) {
    return from + static_cast<int>(engine_() % static_cast<unsigned>(to - from + 1));
  }
  bool once_in(int n) { return number(1, n) == 1; }
  Rational rational() { return Rational(number(-9, 9), number(1, 7)); }

 private:
  std::mt19937 engine_;
};

/// A Runge-Kutta method with random rational entries; the weights sum to 1, the times need not be the row
/// sums.
inline std::string random_tableau(Chance& chance, int stages, bool implicit) {
  std::string text = "integrator random\ntableau\n";
  for (int i = 0; i < stages; ++i) {
    text += "  " + chance.rational().str() + " |";
    for (int j = 0; j < (implicit ? stages : i); ++j)
      text += " " + (chance.once_in(4) ? Rational(0) : chance.rational()).str();
    text += "\n";
  }
  Rational rest = 1;
  text += "  b |";
  for (int i = 0; i + 1 < stages; ++i) {
    const Rational weight = chance.rational();
    rest -= weight;
    text += " " + weight.str();
  }
  return text + " " + rest.str() + "\n";
}

/// Two kicks and two drifts whose shares sum to 1, the force read at random times, the velocity damped now
/// and then.
inline std::string random_composition(Chance& chance) {
  const Rational kick = chance.rational();
  const Rational drift = chance.rational();
  const std::string damping = chance.once_in(3) ? "  v = v*(" + chance.rational().str() + ")\n" : "";
  const auto kicked = [&](const Rational& share) {
    return "  v = v + (" + share.str() + ")*h*a(x, v, t + (" + chance.rational().str() + ")*h)\n";
  };
  const auto drifted = [](const Rational& share) { return "  x = x + (" + share.str() + ")*h*v\n"; };
  std::string text = "integrator random\nstep\n";
  if (chance.once_in(2))
    return text + kicked(kick) + drifted(drift) + damping + kicked(1 - kick) + drifted(1 - drift);
  return text + drifted(drift) + kicked(kick) + drifted(1 - drift) + damping + kicked(1 - kick);
}

/// x from its last two values, whose characteristic roots are 1 and r (0 and 1 among them), and two
/// accelerations.
inline std::string random_two_step(Chance& chance) {
  const std::vector<Rational> roots{0, 1, -1, Rational(1, 2), chance.rational()};
  const std::string r = "(" + roots[chance.number(0, 4)].str() + ")";
  const auto any = [&] { return "(" + chance.rational().str() + ")"; };
  return "integrator random\n  param  g = " + chance.rational().str() +
         "\n  state  x_prev : L\n  state  a_prev : L/T^2\nstart\n  a_prev = a(x, v, t - h)\n  x_prev = x - "
         "h*v + " +
         any() + "*h^2*a_prev\nstep\n  a0     = a(x, v, t)\n  x_next = (1 + " + r + ")*x - " + r +
         "*x_prev + (1 - " + r + ")*h*v + h^2*(" + any() + "*a0 + g*a_prev)\n  v      = v + h*(" + any() +
         "*a0 + " + any() +
         "*a_prev)\n  x_prev = x\n  x      = x_next\n  a_prev = a0\nfinish\n  v = v + g*h*(a(x, v, t) - "
         "a_prev)\n";
}

/// x from its last two values with weights p and q, whose characteristic roots are hardly ever rational.
inline std::string random_oscillation(Chance& chance) {
  const auto any = [&] { return "(" + chance.rational().str() + ")"; };
  return "integrator random\n  state  x_prev : L\nstart\n  x_prev = x - h*v\nstep\n  x_next = " + any() +
         "*x + " + any() + "*x_prev + " + any() + "*h*v + h^2*a(x, v, t)\n  v      = v + " + any() +
         "*h*a(x, v, t)\n  x_prev = x\n  x      = x_next\n";
}

/// Of each kind so many: what it is, and its file.
inline std::vector<std::pair<std::string, std::string>> random_integrators(Chance& chance, int each) {
  std::vector<std::pair<std::string, std::string>> result;
  for (int k = 0; k < each; ++k) {
    result.emplace_back("explicit-tableau", random_tableau(chance, chance.number(1, 4), false));
    result.emplace_back("implicit-tableau", random_tableau(chance, chance.number(1, 3), true));
    result.emplace_back("composition", random_composition(chance));
    result.emplace_back("two-step", random_two_step(chance));
    result.emplace_back("oscillation", random_oscillation(chance));
  }
  return result;
}

}  // namespace shortfall::testing
