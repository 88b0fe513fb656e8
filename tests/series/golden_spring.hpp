// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall::testing {

/// What tests/data/spring_steps.txt holds for an integrator: x and v after three steps of a damped, driven
/// spring, by the second implementation of the language (tests/independent/spring_steps.py).
struct GoldenSpring {
  static constexpr int kDigits = 60;
  std::vector<std::string> numbers;  ///< x, v; x, v; x, v

  /// Whether a program does the same, to 45 digits.
  bool agrees(const Program& program) const {
    const Precision precision(kDigits);
    const auto exactly = [](const Rational& r) { return real(r, kDigits); };
    const Real k = exactly(Rational(2, 3)), c = exactly(Rational(3, 5)), g = exactly(Rational(1, 2)),
               b = exactly(Rational(-1, 7)), allowed = exactly(Rational(1) / Rational(10).pow(45));
    Numbers<Real> problem;
    problem.round = exactly;
    problem.force = [&](const Real& x, const Real& v, const Real& t) -> Real {
      return g + b * t - k * x - c * v;
    };
    const Tape tape = lower(program, parameter_values(program));
    Run<Numbers<Real>> run(tape, problem, exactly(Rational(1, 3)));
    run.begin(exactly(Rational(5, 4)), exactly(Rational(-1, 3)), exactly(Rational(2, 7)));
    if (numbers.size() != 6) return false;
    for (std::size_t n = 0; n < 6; n += 2) {
      run.step();
      const auto [x, v] = run.read_out();
      if (Real(abs(Real(x - Real(numbers[n])))) > allowed ||
          Real(abs(Real(v - Real(numbers[n + 1])))) > allowed)
        return false;
    }
    return true;
  }
};

inline std::map<std::string, GoldenSpring> golden_spring_steps() {
  std::map<std::string, GoldenSpring> all;
  std::ifstream in(SHORTFALL_SOURCE_DIR "/tests/data/spring_steps.txt");
  std::string name;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("  ")) {
      name = line;
      continue;
    }
    std::istringstream words(line);
    for (std::string word; words >> word;) all[name].numbers.push_back(word);
  }
  return all;
}

}  // namespace shortfall::testing
