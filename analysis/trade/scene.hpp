// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/program/expression.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/trade/physical_quantity.hpp"

namespace shortfall {

/// One force of a scene, an acceleration. Coordinates of body b are x[b d], ..., x[b d + d - 1].
struct SceneForce {
  /// The letters are those of `numbers`, in this order; vectors have d components.
  enum class Kind {
    constant,        ///< a (d)
    polynomial,      ///< f0 (d), f1 (d), ...: f0 + f1 t + ...
    linear_drag,     ///< c, w (d): -c (v - w)
    quadratic_drag,  ///< k, w (d): -k |v - w| (v - w)
    spring,    ///< k, c, x0 (d), length: -k (1 - length/r) (x - x0) - c v along x - x0 (all of v if length 0)
    link,      ///< K, C, length: a spring and damper between two bodies, over their masses
    pendulum,  ///< w2: -w2 sin(x), x the angle
    kepler,    ///< mu, centre (d): -mu (x - centre)/r^3
    n_body,    ///< G: every body pulls every other one
    height,    ///< g, R: -g R^2/(R + x_last)^2 in the last coordinate
    lorentz,   ///< E (d), B (3): E + v x B, charge over mass included
    coriolis,  ///< W (3), 1 or 0: -2 W x v - W x (W x x), the second only for 1
    expression,  ///< of x, y, z, vx, vy, vz, t
    potential,   ///< a = -gradient of an expression
  };
  Kind kind = Kind::constant;
  std::string name;         ///< "gravity", as the scene calls it
  std::vector<int> bodies;  ///< whom it acts on; of a link: the two
  std::vector<Rational> numbers;
  std::vector<Expr> expressions;  ///< d of them, or the one potential
  bool held = false;              ///< evaluated once a frame, for all of its substeps
  bool by_engine = false;         ///< the integrator of the budget does it itself, and is not asked for it
};

struct SceneBody {
  std::string name;
  std::vector<Rational> position;
  std::vector<Rational> velocity;
  Rational mass = 1;
};

/// A passing of a coordinate (or velocity) through a level.
struct SceneEvent {
  std::string name;
  int body = 0;
  int axis = 0;
  bool of_velocity = false;
  Rational level;
  int direction = 0;  ///< 1: upwards only; -1: downwards only; 0: both
  bool ends = false;  ///< the motion ends there
};

/// What the user of a scene looks at, and how well it has to be.
struct SceneObservable {
  enum class Kind {
    position,  ///< of a body at a time: the distance from the true one
    velocity,  ///< likewise
    peak,      ///< the highest value of a coordinate
    apex_time,
    event_time,    ///< of the `count`th passing
    event_place,   ///< where the body is then: the distance from the true place
    period,        ///< mean time between the first and the `count`th passing
    phase,         ///< 2 pi times the time by which the `count`th passing is late, over the true period
    energy_drift,  ///< largest |E - E0|/|E0| over the frames
    path,          ///< largest distance from the true path at `count` times
  };
  Kind kind = Kind::position;
  std::string name;
  int body = 0;
  bool of_body = false;      ///< a body was named; a path is otherwise that of the farthest one
  int axis = -1;             ///< -1: the last one
  std::optional<int> event;  ///< index
  int count = 1;
  Rational at;             ///< for position and velocity: the time
  bool at_frames = false;  ///< a peak: the highest frame, not the top between frames
  Rational tolerance;      ///< in `unit`, of the scene's units
  PhysicalDimension dimension;
  std::string unit;  ///< "m", "" for a pure number
  bool is_vector() const {
    return kind == Kind::position || kind == Kind::velocity || kind == Kind::event_place;
  }
};

/// What may be spent.
struct SceneBudget {
  std::string integrator;       ///< of the engine, when it is fixed; empty: free
  Values parameters;            ///< of that integrator
  std::vector<Rational> steps;  ///< the frame times allowed, in the scene's unit of time; empty: any
  int most_substeps = 64;
  std::optional<Rational> microseconds;  ///< a frame may take
  std::vector<std::string> formats{"f64"};
};

/// A situation: bodies, forces, what is looked at and how precise it has to be.
struct Scene {
  std::string file;
  std::string text;  ///< of the file
  std::string name;
  std::string title;
  UnitSystem units;
  int dimension = 1;
  std::vector<SceneBody> bodies;
  std::vector<SceneForce> forces;
  std::vector<SceneEvent> events;
  std::vector<SceneObservable> observables;
  Rational until;  ///< in the scene's unit of time
  Rational step;   ///< of the naive choice: the engine's frame
  std::string naive = "rk4";
  SceneBudget budget;

  int coordinates() const { return dimension * static_cast<int>(bodies.size()); }
};

/// A scene from its file.
///
/// throws  UnreadableFile;  SyntaxError  with line and column, for a text that is no TOML, an unknown key, a
/// number, unit or expression that makes no sense, tolerances that cannot be
Scene read_scene(const std::string& path);
Scene scene_of(const std::string& text, const std::string& file);

}  // namespace shortfall
