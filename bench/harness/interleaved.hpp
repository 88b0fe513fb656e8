// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace shortfall::bench {

/// The processor time that a process has used, by the clock that clock_getcpuclockid gives for it. Unlike the
/// time on the wall it does not count the turns of other programs on a busy machine.
///
/// units   seconds
double processor_seconds(clockid_t clock);

/// One way of doing a piece of work.
struct Contender {
  std::string name;
  /// Processor time of doing the work so many times in a row.
  std::function<double(long times)> seconds;
};

/// A contender that runs in this process: `work` does the work once.
Contender here(std::string name, std::function<void()> work);

/// The least time that each contender needs for doing the work once.
///
/// The contenders take turns, so that what slows the machine down for a while slows down all of them. The
/// least of the rounds is taken, since disturbances only add.
///
/// param   rounds  turns of each contender
/// param   least   seconds that a turn lasts at least: the work is repeated until it does
/// units   seconds
std::vector<double> least_times(const std::vector<Contender>& contenders, int rounds, double least);

/// "12.3 ms": three digits with the unit that suits.
std::string time_text(double seconds);

/// Keeps the compiler from leaving out the computation of a value.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace shortfall::bench
