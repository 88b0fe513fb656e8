// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/identify/candidate.hpp"

namespace shortfall {

/// A motion that one could record in order to tell maps apart.
struct Experiment {
  std::string text;  ///< "a fall with a damping of 0.5, with velocities"
  double c = 0;      ///< the number given to the engine
  double k = 0;      ///< of a spring as the user's own force
  bool impulse = false;
  bool velocities = true;
};

const std::vector<Experiment>& experiments();

/// Which candidates an experiment cannot tell apart: the number of its group for each, from 0.
std::vector<int> groups(const std::vector<Candidate>& candidates, const Experiment& experiment);

/// The same of all experiments together.
std::vector<int> groups(const std::vector<Candidate>& candidates);

/// The experiment that tells the most of them apart; null when none does.
const Experiment* best_experiment(const std::vector<Candidate>& candidates);

/// How many different numbers there are.
int group_count(const std::vector<int>& groups);

}  // namespace shortfall
