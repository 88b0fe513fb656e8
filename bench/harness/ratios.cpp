// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness/ratios.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "bench/harness/interleaved.hpp"

namespace shortfall::bench {
namespace {

void note(double ratio, const std::string& rest) {
  const char* const name = std::getenv("SHORTFALL_RATIOS");
  if (!name) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", ratio);
  std::ofstream file(name, std::ios::app);
  file << text.data() << '\t' << rest << '\n';
  if (!file.flush()) throw std::runtime_error(std::string(name) + " cannot be written");
}

}  // namespace

void note_ratio(const std::string& work, const std::string& other, double ours, double theirs) {
  note(ours / theirs, work + '\t' + time_text(ours) + '\t' + other + '\t' + time_text(theirs));
}

void note_mean_ratio(const std::string& work, const std::string& other, const std::vector<double>& ratios) {
  double sum = 0;
  for (const double r : ratios) sum += std::log(r);
  note(std::exp(sum / static_cast<double>(ratios.size())),
       work + "\tmean of " + std::to_string(ratios.size()) + '\t' + other + "\t");
}

}  // namespace shortfall::bench
