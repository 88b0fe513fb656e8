// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/extremes_text.hpp"

namespace shortfall {

std::string as_text(const std::vector<ExtremeCase>& cases, const std::string& title) {
  std::string text = title + "\n";
  int lost = 0;
  for (const ExtremeCase& c : cases) {
    text += "\n  " + c.name + ": " + c.asked + "\n    exact     " + c.exact + "\n    computed  " +
            c.computed + (c.lost ? "   LOST" : "") + "\n    why       " + c.why + "\n";
    lost += c.lost ? 1 : 0;
  }
  return text + "\n  " + std::to_string(cases.size()) + " cases, " + std::to_string(lost) +
         " lost (wrong by more than a tenth, or no number)\n";
}

nlohmann::ordered_json as_json(const std::vector<ExtremeCase>& cases) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ExtremeCase& c : cases)
    json.push_back({{"name", c.name},
                    {"asked", c.asked},
                    {"exact", c.exact},
                    {"computed", c.computed},
                    {"why", c.why},
                    {"lost", c.lost}});
  return json;
}

}  // namespace shortfall
