// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "tests/engines/replay.hpp"

// replay FOLDER: every recording that the folder's manifest.json names, run again with the catalogue's
// engines.
int main(int count, char** words) {
  if (count != 2) {
    std::fputs("Usage: replay FOLDER   (a folder with a manifest.json and the recordings that it names)\n",
               stderr);
    return 2;
  }
  try {
    std::vector<shortfall::engines::Outcome> outcomes;
    bool refuted = false;
    for (const auto& recording : shortfall::engines::recordings(words[1])) {
      outcomes.push_back(shortfall::engines::replay(recording));
      refuted = refuted || (outcomes.back().claimed && !outcomes.back().exact);
    }
    std::fputs(shortfall::engines::table(outcomes).c_str(), stdout);
    return refuted ? 1 : 0;
  } catch (const shortfall::UnreadableFile& e) {
    std::fprintf(stderr, "replay: %s\n", e.what());
    return 5;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "replay: %s\n", e.what());
    return 3;
  }
}
