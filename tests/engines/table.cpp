// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/engines/replay.hpp"

namespace shortfall::engines {
namespace {

struct Counts {
  std::string engine;
  int recordings = 0;
  int replayed = 0;
  int exact = 0;
  int claimed = 0;
  int claimed_in_vain = 0;  ///< claimed, but not exact

  void add(const Outcome& o) {
    ++recordings;
    replayed += !o.integrator.empty();
    exact += o.exact;
    claimed += o.claimed;
    claimed_in_vain += o.claimed && !o.exact;
  }

  std::string line() const {
    char text[120];
    std::snprintf(text, sizeof text, "%-20s %10d %9d %9d %9d %9d\n", engine.c_str(), recordings, replayed,
                  exact, claimed, claimed_in_vain);
    return text;
  }
};

}  // namespace

std::string table(const std::vector<Outcome>& outcomes) {
  std::vector<Counts> engines;
  Counts all{"all"};
  std::string misses;
  for (const Outcome& o : outcomes) {
    auto found = std::ranges::find(engines, o.engine, &Counts::engine);
    if (found == engines.end()) found = engines.insert(engines.end(), Counts{o.engine});
    found->add(o);
    all.add(o);
    if (o.exact) continue;
    misses += "  " + o.file + ": ";
    if (o.first_difference) misses += "frame " + std::to_string(*o.first_difference) + ": ";
    misses += o.reason + "\n";
  }
  std::string result = "engine               recordings  replayed     exact   claimed   refuted\n";
  for (const Counts& c : engines) result += c.line();
  result += all.line();
  if (!misses.empty()) result += "\nnot exact, and why:\n" + misses;
  return result;
}

}  // namespace shortfall::engines
