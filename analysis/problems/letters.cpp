// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/letters.hpp"

#include "analysis/algebra/error.hpp"

namespace shortfall {

std::vector<std::string> letter_names(const Tape& tape) {
  std::vector<std::string> names{"n", "h", "t", "k", "c"};
  for (const Tape::ParameterSlot& p : tape.parameters)
    for (const Letter letter : {kStiffness, kDamping})  // two letters must not share a name
      if (p.name == names[static_cast<std::size_t>(letter)])
        names[static_cast<std::size_t>(letter)] += "_force";
  for (const Tape::ParameterSlot& p : tape.parameters) names.push_back(p.name);
  if (static_cast<int>(names.size()) > kLetters)
    throw Unable(tape.name + " has " + std::to_string(tape.parameters.size()) +
                 " parameters; symbolic answers carry at most " + std::to_string(kLetters - kFirstParameter));
  return names;
}

}  // namespace shortfall
