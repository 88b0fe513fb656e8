// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace shortfall::bench {

/// Puts a comparison into the table that `./dev bench` ends with: the time of our way and of another way of
/// doing the same work, both taken in turns in this run. It is appended to the file that the variable
/// SHORTFALL_RATIOS names, and goes nowhere without it.
///
/// param   work   what both do, with its size
/// param   other  who else does it
/// units   seconds
/// throws  std::runtime_error  when the file cannot be written
void note_ratio(const std::string& work, const std::string& other, double ours, double theirs);

/// The same for many ratios of one kind, ours over theirs: their geometric mean, without times.
void note_mean_ratio(const std::string& work, const std::string& other, const std::vector<double>& ratios);

}  // namespace shortfall::bench
