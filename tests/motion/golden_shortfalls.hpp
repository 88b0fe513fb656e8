// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "analysis/motion/formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/program/check.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"

namespace shortfall::testing {

/// What x and v fall short by after n steps under f0 + f1 t + f2 t^2 + f3 t^3.
struct CubicShortfall {
  static constexpr int kDegree = 3;
  StepMap map;
  NumberField field;
  Motion x;
  Motion v;
  bool oscillates = false;  ///< beyond what x and v say

  CubicShortfall(const Program& program, const Values& given)
      : map(step_map(lower(program, given), kDegree)), field(map.generators) {
    const ClosedForm form = closed_form(map);
    x = exact_position(kDegree) - form.position;
    v = exact_velocity(kDegree) - form.velocity;
    oscillates = !form.oscillation.is_zero();
  }
};

/// What tests/data/shortfalls.txt holds for an integrator: with its parameters as letters, and with their
/// defaults.
struct GoldenShortfall {
  std::vector<std::string> lines;  ///< x, v; and again for the defaults

  static std::string text(const Program& program) {
    std::string result = program.name + "\n";
    for (const Values& given : {Values(), parameter_values(program)}) {
      const CubicShortfall found(program, given);
      const Wording wording{found.map.letters, "n", true};
      for (const auto& [head, motion] : {std::pair{"  x: ", &found.x}, {"  v: ", &found.v}})
        result += head + print(formula(*motion, CubicShortfall::kDegree, wording)) + "\n";
      if (program.parameters.empty()) break;
    }
    return result;
  }

  /// Whether they say the same of a program, in whatever form they are written.
  bool agrees(const Program& program) const {
    if (lines.size() != (program.parameters.empty() ? 2U : 4U)) return false;
    for (std::size_t i = 0; i < lines.size(); i += 2) {
      const Values given = i == 0 ? Values() : parameter_values(program);
      const CubicShortfall found(program, given);
      if (found.oscillates || !is_zero(motion(lines[i], program, given, kLength, found) - found.x) ||
          !is_zero(motion(lines[i + 1], program, given, kVelocity, found) - found.v))
        return false;
    }
    return true;
  }

 private:
  static Motion motion(const std::string& text, const Program& program, const Values& given,
                       Dimension dimension, const CubicShortfall& found) {
    const Names names = formula_names(program, CubicShortfall::kDegree);
    return evaluated(parse_formula(text, "shortfalls.txt", names, {Sort::vector, dimension}),
                     formula_scalars(program, given, found.map.force.extras.get()), CubicShortfall::kDegree,
                     found.map.force.extras.get());
  }
};

inline const std::string kShortfallsFile = SHORTFALL_SOURCE_DIR "/tests/data/shortfalls.txt";

inline std::map<std::string, GoldenShortfall> golden_shortfalls() {
  std::map<std::string, GoldenShortfall> all;
  std::ifstream in(kShortfallsFile);
  std::string name;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("  "))
      all[name].lines.push_back(line.substr(5));
    else
      name = line;
  return all;
}

}  // namespace shortfall::testing
