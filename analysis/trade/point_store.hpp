// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "analysis/trade/scene_run.hpp"

namespace shortfall {

/// Outcomes that are kept in a file of SQLite as they come, so that work that was stopped, even by a power
/// cut, goes on where it was. One transaction a point; readers may look on while it grows.
class PointStore {
 public:
  /// throws  UnreadableFile  when the file cannot be opened or made, or is something else
  explicit PointStore(const std::string& path);
  ~PointStore();
  PointStore(PointStore&&) noexcept;

  /// Bit for bit what was put; none when there is none.
  std::optional<SceneOutcome> find(const std::string& key) const;
  /// throws  UnreadableFile  when it cannot be written
  void put(const std::string& key, const SceneOutcome& outcome);
  std::int64_t size() const;

 private:
  struct Database;
  std::unique_ptr<Database> database_;
};

/// What a point depends on: the scene (its text, its end), how it is stepped, and what steps it.
std::string point_key(const Scene& scene, const StepChoice& choice);

}  // namespace shortfall
