// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/mpi/machines.hpp"

#ifdef SHORTFALL_MPI
#include <mpi.h>

#include <cstdlib>
#include <numeric>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/outcome_text.hpp"
#endif

namespace shortfall {

#ifdef SHORTFALL_MPI

namespace {

/// Started by an mpirun, of Open MPI, of MPICH or by a scheduler: alone, there is nothing to wait for.
bool is_one_of_several() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(name)) return true;
  return false;
}

}  // namespace

Machines::Machines() {
  if (!is_one_of_several()) return;
  started_ = true;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Machines::~Machines() {
  if (started_) MPI_Finalize();
}

std::optional<int> Machines::unready(bool this_one_is_ready) const {
  int first = this_one_is_ready ? count_ : rank_;
  if (started_) MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return first < count_ ? std::optional(first) : std::nullopt;
}

std::vector<SceneOutcome> Machines::run_points(std::size_t count,
                                               const std::function<SceneOutcome(std::size_t)>& one,
                                               const Progress& progress) const {
  if (!started_) return run_points_in_threads(count, one, progress);
  std::vector<std::size_t> mine;
  for (auto i = static_cast<std::size_t>(rank_); i < count; i += static_cast<std::size_t>(count_))
    mine.push_back(i);
  // "E why" or a line for each point: an error on one process must not leave the others waiting.
  std::string text;
  std::vector<SceneOutcome> result(count);
  for (SceneOutcome& o : result) o.failed = true;  // until it is known
  try {
    const auto outcomes = run_points_in_threads(
        mine.size(), [&](std::size_t k) { return one(mine[k]); }, progress);
    for (std::size_t k = 0; k < mine.size(); ++k) {
      text += std::to_string(mine[k]) + "\t" + as_line(outcomes[k]);
      result[mine[k]] = outcomes[k];
    }
  } catch (const std::exception& e) {
    text = std::string("E\t") + e.what() + "\n";
  }
  const int length = static_cast<int>(text.size());
  std::vector<int> lengths(static_cast<std::size_t>(count_)), starts(static_cast<std::size_t>(count_));
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(lengths.begin(), lengths.end(), starts.begin(), 0);
  std::string all(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)), ' ');
  MPI_Gatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), starts.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  if (!speaks()) return result;
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    if (line.starts_with("E\t")) throw Error(line.substr(2));
    result[static_cast<std::size_t>(std::stoull(line.substr(0, tab)))] =
        outcome_of_line(line.substr(tab + 1));
  }
  return result;
}

#else

Machines::Machines() = default;
Machines::~Machines() = default;

std::optional<int> Machines::unready(bool this_one_is_ready) const {
  return this_one_is_ready ? std::nullopt : std::optional(0);
}

std::vector<SceneOutcome> Machines::run_points(std::size_t count,
                                               const std::function<SceneOutcome(std::size_t)>& one,
                                               const Progress& progress) const {
  return run_points_in_threads(count, one, progress);
}

#endif

}  // namespace shortfall
