// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/trade/trade.hpp"

namespace shortfall {

/// The processes that mpirun started, each perhaps on a machine of its own. Built with -DSHORTFALL_MPI=ON;
/// without, there is one.
class Machines {
 public:
  /// MPI_Init, where mpirun started this process.
  Machines();
  /// MPI_Finalize, then. Without MPI there is nothing to end.
  ~Machines();  // NOLINT(performance-trivially-destructible)
  Machines(const Machines&) = delete;
  Machines& operator=(const Machines&) = delete;

  /// Whether this process speaks: the others only work.
  bool speaks() const { return rank_ == 0; }

  /// Which process, the lowest of them, could not begin; none when all could. All processes ask together.
  std::optional<int> unready(bool this_one_is_ready) const;
  /// Whether that is this process.
  bool is(int process) const { return process == rank_; }

  /// Point i is done by process i mod count(), by its threads; process 0 gets all of them, bit for bit, the
  /// others theirs.
  ///
  /// throws  Error  on process 0 what went wrong on any
  std::vector<SceneOutcome> run_points(std::size_t count, const std::function<SceneOutcome(std::size_t)>& one,
                                       const Progress& progress) const;

 private:
  bool started_ = false;
  int rank_ = 0;
  int count_ = 1;
};

}  // namespace shortfall
