// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/engines/replay.hpp"

#include <cstdio>
#include <map>
#include <type_traits>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "tests/engines/engine_world.hpp"

namespace shortfall::engines {
namespace {

/// What must be known about an engine besides its file in the catalogue.
struct Engine {
  std::string integrator;
  Adding adding = Adding::at_once;
};

Engine engine(const Recording& r) {
  static const std::map<std::string, Engine> kEngines = {
      {"physx", {"physx", Adding::force_first}},
      {"jolt", {"jolt"}},
      {"rapier3d", {"rapier"}},
      {"bullet", {"bullet"}},
      {"bullet-f64", {"bullet"}},
      {"cannon-es", {"cannon-es"}},
      {"p2", {"p2"}},
      {"ode", {"ode"}},
      {"box2d-v2.4", {"box2d-2"}},
      {"box2d-v3", {"box2d", Adding::after_scaling}},
      {"planck", {"planck", Adding::gravity_first}},
      {"chipmunk", {"chipmunk"}},
      {"godot", {"godot"}},
      {"matter-js", {"matter-js", Adding::after_scaling}},
      {"mujoco-euler", {"mujoco-euler", Adding::gravity_first}},
      {"mujoco-implicitfast", {"mujoco-implicitfast", Adding::gravity_first}},
      {"mujoco-rk4", {"mujoco-rk4"}},
  };
  if (r.smears) return {"physx-tgs-external-forces", Adding::gravity_first};
  const auto found = kEngines.find(r.engine);
  if (found == kEngines.end()) throw BadInput(r.file + ": no engine '" + r.engine + "' is known");
  return found->second;
}

/// Recordings of something else than a free body: they say nothing about the integrator.
std::string other_subject(const Recording& r) {
  if (r.kind == "spring_engine" && !r.engine.starts_with("mujoco"))
    return "a spring of the engine's own, solved as a joint";
  if (r.kind == "pendulum_engine" || r.kind == "pendulum_hinge") return "a body on a joint";
  if (r.kind == "render_interpolated") return "positions extrapolated for drawing, not the engine's own";
  return {};
}

/// The damping number in the units of the engine's interface.
double damping(const Recording& r) {
  if (r.engine == "ode") return r.damping * r.step(1);  // a fraction per step
  if (r.engine == "matter-js") return r.damping / 60;   // per 1/60 s
  return r.damping;
}

Values values(const Recording& r, const Program& program) {
  Values result;
  // The interfaces take the number in the engine's precision.
  const double c = r.precision == "float32" ? static_cast<float>(damping(r)) : damping(r);
  if (!r.default_damping && program.parameter("c") != nullptr) result["c"] = Rational::from_double(c);
  if (r.explicit_damping && program.parameter("d") != nullptr) result["d"] = Rational(0);
  if (r.substeps != 0 && program.parameter("N") != nullptr) result["N"] = Rational(r.substeps);
  if (r.maximal_speed != 0 && program.parameter("S") != nullptr)
    result["S"] = Rational::from_double(r.maximal_speed);
  return result;
}

template <class Vector>
Triple doubles(const Vector& vector) {
  return {double(vector.parts()[0]), double(vector.parts()[1]), double(vector.parts()[2])};
}

/// From this frame on the body stands still in mid-air, with velocity 0.
bool asleep(const Recording& r, std::size_t frame) {
  for (std::size_t n = frame; n < r.rows.size(); ++n)
    if (r.rows[n].v != Triple{} || r.rows[n].x != r.rows[frame].x) return false;
  return true;
}

/// The first component that differs, in as many digits as tell two numbers of the format apart.
std::string difference(const Recording::Row& computed, const Recording::Row& recorded, bool single) {
  const char* const names[] = {"x", "y", "z", "vx", "vy", "vz"};
  for (std::size_t i = 0; i < 6; ++i) {
    const double ours = i < 3 ? computed.x[i] : computed.v[i - 3];
    const double theirs = i < 3 ? recorded.x[i] : recorded.v[i - 3];
    if (ours == theirs) continue;
    char text[100];
    const int digits = single ? 9 : 17;
    std::snprintf(text, sizeof text, "%s is %.*g, computed %.*g", names[i], digits, theirs, digits, ours);
    return text;
  }
  return {};
}

template <class S, class C>
void run(const Recording& r, const Program& program, Adding adding, Outcome& outcome) {
  const Tape tape = lower(program, values(r, program));
  EngineWorld<S, C> world{r, adding};
  Run<EngineWorld<S, C>> body(tape, world, S(r.step(1)));
  body.begin(world.vector(r.rows[0].x), world.vector(r.rows[0].v), S(0));
  if (r.impulsive()) body.give_impulse(world.vector(r.launch));
  for (std::size_t frame = 0; frame < r.rows.size(); ++frame) {
    if (frame > 0) {
      body.set_step(S(r.step(frame)));
      body.step();
    }
    const auto [x, v] = body.read_out();
    const std::string found = difference({doubles(x), doubles(v)}, r.rows[frame], std::is_same_v<C, float>);
    if (found.empty()) continue;
    outcome.first_difference = frame;
    outcome.reason = frame > 0 && asleep(r, frame)
                         ? "the engine has put the body to sleep: it stands still from here on"
                         : found;
    return;
  }
  outcome.exact = true;
}

}  // namespace

Outcome replay(const Recording& r, const Program& program) {
  Outcome outcome{r.file, r.engine, {}, r.claimed, false, r.rows.size(), {}, other_subject(r)};
  if (!outcome.reason.empty()) return outcome;
  const Adding adding = engine(r).adding;
  outcome.integrator = program.name;
  if (r.precision == "float32")
    run<float, float>(r, program, adding, outcome);
  else if (r.precision == "float64")
    run<double, double>(r, program, adding, outcome);
  else if (r.precision == "float64-stored32")
    run<double, float>(r, program, adding, outcome);
  else
    throw BadInput(r.file + ": no precision is called '" + r.precision + "'");
  return outcome;
}

Outcome replay(const Recording& r) { return replay(r, find_integrator(integrator_of(r))); }

std::string integrator_of(const Recording& r) { return engine(r).integrator; }

}  // namespace shortfall::engines
