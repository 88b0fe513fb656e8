// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/memory.hpp"

#include <array>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall::cli {

void add_memory(CLI::App& command, std::string& memory) {
  command
      .add_option("--max-memory", memory,
                  "how much memory the trees may take, such as 500MB or 4GB (default 500MB)")
      ->type_name("SIZE");
}

double memory_of(const std::string& text) {
  constexpr std::array<std::pair<const char*, double>, 4> kUnits{
      {{"GB", 1e9}, {"MB", 1e6}, {"kB", 1e3}, {"B", 1}}};
  std::string number = text;
  double unit = 1;
  for (const auto& [name, size] : kUnits)
    if (number.ends_with(name)) {
      number.resize(number.size() - std::string(name).size());
      unit = size;
      break;
    }
  while (!number.empty() && number.back() == ' ') number.pop_back();
  try {
    const double bytes = Rational::parse(number).to_double() * unit;
    if (bytes > 0) return bytes;
  } catch (const BadInput&) {  // said below
  }
  throw BadInput("--max-memory '" + text.substr(0, 60) + "': write an amount such as 500MB or 4GB");
}

}  // namespace shortfall::cli
