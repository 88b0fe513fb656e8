// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness/interleaved.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace shortfall::bench {

double processor_seconds(clockid_t clock) {
  timespec time{};
  if (clock_gettime(clock, &time) != 0) throw std::runtime_error("the clock of a process cannot be read");
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Contender here(std::string name, std::function<void()> work) {
  return {std::move(name), [work = std::move(work)](long times) {
            const double begin = processor_seconds(CLOCK_PROCESS_CPUTIME_ID);
            for (long i = 0; i < times; ++i) work();
            return processor_seconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
          }};
}

std::vector<double> least_times(const std::vector<Contender>& contenders, int rounds, double least) {
  constexpr long kMostTimes = 100'000'000;
  std::vector<long> times;
  for (const Contender& contender : contenders) {
    long n = 1;
    for (double took; (took = contender.seconds(n)) < least && n < kMostTimes;)
      n = std::min(kMostTimes, std::max(n + 1, std::lround(std::ceil(static_cast<double>(n) *
                                                                     std::min(20.0, 1.2 * least / took)))));
    times.push_back(n);
  }
  std::vector<double> best(contenders.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i)
      best[i] = std::min(best[i], contenders[i].seconds(times[i]) / static_cast<double>(times[i]));
  return best;
}

std::string time_text(double seconds) {
  constexpr std::array<const char*, 4> kUnits{"s", "ms", "us", "ns"};
  std::size_t unit = 0;
  while (seconds < 1 && unit + 1 < kUnits.size()) {
    seconds *= 1000;
    ++unit;
  }
  const int places = seconds < 10 ? 2 : seconds < 100 ? 1 : 0;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f %s", places, seconds, kUnits[unit]);
  return text.data();
}

}  // namespace shortfall::bench
