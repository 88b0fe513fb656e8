// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_lanes.hpp"

#include <cmath>
#include <span>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_many.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/trade/rounded_number.hpp"

namespace shortfall {

std::optional<std::string> why_no_lanes(const Scene& scene, const StepChoice& choice) {
  if (scene.coordinates() != 1)
    return "side by side go motions of one coordinate; this scene has " + std::to_string(scene.coordinates());
  for (const SceneForce& f : scene.forces)
    if (f.held) return "a force that is held over a frame is computed for one motion at a time";
  if (choice.launched) return "launch and read-out are computed for one motion at a time";
  if (choice.format != "f32" && choice.format != "f64") return "lanes are of f32 and f64";
  const Program program = find_integrator(choice.integrator);
  if (const auto reason = why_not_native(program)) return *reason;
  if (!has_lanes(program))
    return program.name +
           " is stepped one motion after the other (implicit stages, or a processor without AVX2)";
  return std::nullopt;
}

struct SceneLanes::Machine {
  virtual ~Machine() = default;
  virtual void run(std::int64_t frames) = 0;
  virtual std::pair<double, double> state(std::size_t index) const = 0;
};

template <class S>
struct SceneLanes::MachineOf : Machine {
  MachineOf(const Scene& scene, const StepChoice& choice, int count)
      : steps(chosen_steps(choice)),
        step(rounded_number<S>(steps.h)),
        acceleration(scene, asked_forces(scene, choice.integrator, {})) {
    const S x0 = rounded_number<S>(scene.bodies[0].position[0]);
    const S v0 = rounded_number<S>(scene.bodies[0].velocity[0]);
    for (int i = 0; i < count; ++i) {
      start_x.push_back(i == 0 ? x0 : std::nextafter(start_x.back(), S(INFINITY)));
      start_v.push_back(v0);
    }
  }

  void run(std::int64_t frames) override {
    x = start_x;
    v = start_v;
    const auto force = [this](std::span<const S> at, std::span<const S> moving, S t, std::span<S> a) {
      acceleration.many(at.data(), moving.data(), t, a.data(), at.size());
    };
    native_many<S>(steps.program, steps.parameters, step, ForceReference<S>(force), x, v, S(0),
                   frames * steps.a_frame);
  }

  std::pair<double, double> state(std::size_t index) const override { return {x.at(index), v.at(index)}; }

  ChosenSteps steps;
  S step;
  SceneAcceleration<S> acceleration;
  std::vector<S> start_x, start_v, x, v;
};

SceneLanes::SceneLanes(const Scene& scene, const StepChoice& choice, int count) {
  if (const auto why = why_no_lanes(scene, choice)) throw Unable(*why);
  if (choice.format == "f32")
    machine_ = std::make_unique<MachineOf<float>>(scene, choice, count);
  else
    machine_ = std::make_unique<MachineOf<double>>(scene, choice, count);
}

SceneLanes::~SceneLanes() = default;
SceneLanes::SceneLanes(SceneLanes&&) noexcept = default;

void SceneLanes::run(std::int64_t frames) { machine_->run(frames); }
std::pair<double, double> SceneLanes::state(int index) const {
  return machine_->state(static_cast<std::size_t>(index));
}

}  // namespace shortfall
