// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "analysis/trade/scene.hpp"
#include "analysis/trade/scene_table.hpp"

namespace shortfall {

/// What the reading of a force has to know of the scene around it.
struct SceneContext {
  const SceneText& text;
  Scene& scene;
  bool angles = false;                         ///< coordinates are angles
  std::map<std::string, Rational> parameters;  ///< of [parameters], for expressions

  /// Of a coordinate, times T^time.
  PhysicalDimension coordinate(int time = 0) const { return {angles ? 0 : 1, time, 0}; }
  int body_named(const toml::node& at, const std::string& name) const;
  /// d numbers behind a key.
  std::vector<Rational> vector(const toml::node& node, const std::string& key,
                               const PhysicalDimension& dimension) const;
};

SceneForce read_force(const SceneContext& context, const toml::table& table);

}  // namespace shortfall
