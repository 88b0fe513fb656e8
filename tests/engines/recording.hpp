// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall::engines {

using Triple = std::array<double, 3>;

/// One flight of one body in a real engine, frame by frame, and what the body was told to do.
///
/// Numbers that the engine keeps in binary32 are held as the doubles equal to them.
struct Recording {
  struct Row {
    Triple x;
    Triple v;
  };

  std::string file;       ///< relative to the folder of its manifest
  std::string engine;     ///< as the manifest calls it: "rapier3d"
  std::string precision;  ///< "float32", "float64", "float64-stored32"
  std::string kind;       ///< "velocity", "impulse", "force", "spring_user", ...
  double mass = 1;
  double damping = 0;  ///< the number given to the engine, per second; meaningless when default_damping
  bool default_damping = false;
  int substeps = 0;               ///< 0: the engine's own default
  bool smears = false;            ///< PhysX: external forces in every iteration of its TGS solver
  bool explicit_damping = false;  ///< MuJoCo's Euler with its implicit damping switched off
  double maximal_speed = 0;       ///< 0: the engine's own default
  Triple gravity{};
  Triple launch{};            ///< the velocity that was set, or the impulse over the mass
  Triple force{};             ///< a constant force in newtons
  double stiffness = 0;       ///< of a spring to the origin, as a user's force
  double attraction = 0;      ///< mu of a force -mu x/|x|^3
  std::vector<double> steps;  ///< the length of every step: one number, or one for each frame
  bool claimed = false;       ///< the manifest says that its map agrees to the last bit
  std::vector<Row> rows;      ///< frame 0 is the state before the first step

  bool impulsive() const { return kind == "impulse"; }
  double step(std::size_t frame) const { return steps.size() == 1 ? steps[0] : steps.at(frame - 1); }
};

/// Every recording that the folder's manifest.json names, in its order.
///
/// throws  UnreadableFile  without a manifest or a CSV;  BadInput  when one of them makes no sense
std::vector<Recording> recordings(const std::filesystem::path& folder);

}  // namespace shortfall::engines
