// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "tests/engines/confusion.hpp"

// confusion FOLDER [--decimals N] [--positions]: what `identify` makes of every recording that the folder's
// manifest.json names.
int main(int count, char** words) {
  using namespace shortfall::engines;
  Blur blur;
  std::size_t every = 1;
  std::string folder;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--positions")
      blur.velocities = false;
    else if (word == "--decimals" && i + 1 < count)
      blur.decimals = std::atoi(words[++i]);
    else if (word == "--every" && i + 1 < count)
      every = static_cast<std::size_t>(std::max(1, std::atoi(words[++i])));
    else
      folder = word;
  }
  if (folder.empty()) {
    std::fputs(
        "Usage: confusion FOLDER [--decimals N] [--positions] [--every K]   (a folder with a "
        "manifest.json)\n",
        stderr);
    return 2;
  }
  try {
    const std::vector<Recording> all_of_them = recordings(folder);
    std::vector<Recording> all;
    for (std::size_t i = 0; i < all_of_them.size(); i += every) all.push_back(all_of_them[i]);
    std::vector<Verdict> verdicts(all.size());
    const auto work = [&](std::size_t from) {
      for (std::size_t i = from; i < all.size(); i += 2) {
        std::ifstream in(folder + "/" + all[i].file, std::ios::binary);
        verdicts[i] = verdict(all[i], std::string(std::istreambuf_iterator<char>(in), {}), blur);
        std::fprintf(stderr, "%s: %s (%.2f s)\n", all[i].file.c_str(), verdicts[i].answer.c_str(),
                     verdicts[i].seconds);
      }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    std::fputs(confusion_table(verdicts).c_str(), stdout);
    for (const Verdict& v : verdicts)
      if (v.kind == Verdict::Kind::wrong || v.unfaithful > 0) return 1;
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "confusion: %s\n", e.what());
    return 3;
  }
}
