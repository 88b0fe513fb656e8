// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall::testing {

/// The catalogue as runs in rational numbers can follow it: engines as they are, but without damping, without
/// their limits, and with the force of every moment.
inline const std::vector<Program>& undamped_catalogue() {
  static const std::vector<Program> all = [] {
    std::vector<Program> programs;
    for (Program program : catalogue()) {
      if (family(program) == "engines") {
        program.holds_force = false;
        for (Parameter& p : program.parameters)
          if (p.name == "c") p.fallback = number(0);
        const std::string file = program.file;
        program = undisturbed(program);
        program.file = file;
      }
      programs.push_back(std::move(program));
    }
    return programs;
  }();
  return all;
}

/// Those of them whose coefficients are short rational numbers: what is solved for in letters takes seconds
/// for each of the others, whose kits have tests of their own.
inline const std::vector<Program>& short_catalogue() {
  static const std::vector<Program> all = [] {
    std::vector<Program> programs;
    for (const Program& program : undamped_catalogue()) {
      const bool irrational = !program.roots.empty() || print(program).find("sqrt(") != std::string::npos;
      const bool is_long = program.splitting && program.splitting->parts.size() > 6;
      if (!irrational && !is_long && !program.approximate()) programs.push_back(program);
    }
    return programs;
  }();
  return all;
}

}  // namespace shortfall::testing
