// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/trade/launch_terms.hpp"
#include "analysis/trade/reference.hpp"

namespace shortfall {

/// How a scene is stepped.
struct StepChoice {
  std::string integrator;
  Values parameters{};
  bool launched = false;       ///< with the launch and read-out that raise its order
  std::string format = "f64";  ///< f32 or f64
  Rational frame;              ///< the frame time, in the scene's unit of time
  int substeps = 1;            ///< steps of frame/substeps between two frames
  /// What the launch is; null: the stepping finds it itself.
  std::shared_ptr<const Processing> launch{};
  bool interpreted = false;  ///< not by compiled code, even where there is some

  std::string label() const;  ///< "symplectic-euler + launch, f32"
};

/// The steps of a choice: substeps are the integrator's own where it has some, shorter steps otherwise.
struct ChosenSteps {
  Program program;
  Values parameters;
  Rational h;       ///< of one step
  int a_frame = 1;  ///< how many steps make a frame
};
ChosenSteps chosen_steps(const StepChoice& choice);

/// What stepping a scene in a certain way gives.
struct SceneOutcome {
  StepChoice choice;
  std::int64_t steps = 0;        ///< substeps counted each, up to the end of the scene
  std::int64_t evaluations = 0;  ///< of the force, likewise
  bool failed = false;
  std::string why;             ///< when it failed
  std::vector<double> errors;  ///< of each observable, see reading_error; empty when it failed
  double tolerance = 0;        ///< of a peer that chooses its steps by one
  double nanoseconds = 0;      ///< of the whole scene, measured; 0: not measured

  /// Whether every error is at most so much of its tolerance.
  bool meets(const Scene& scene, double share = 1) const;
};

/// A scene stepped by compiled code. The true motion between frames is that of the whole scene.
class SceneStepping {
 public:
  /// param   chosen  the forces that are stepped; all when empty
  /// throws  Unable  when the integrator has no native code, or no launch;  BadInput
  SceneStepping(const Scene& scene, const StepChoice& choice, const ForceChoice& chosen = {});
  ~SceneStepping();
  SceneStepping(SceneStepping&&) noexcept;

  /// Steps to the end of the scene and reads the observables.
  SceneOutcome observe(const SceneReference& reference);
  /// So many frames from the start, nothing read: to be measured.
  void run(std::int64_t frames);

 private:
  struct Machine;
  template <class S>
  struct MachineOf;
  std::unique_ptr<Machine> machine_;
};

/// The launch of an integrator for the forces of a scene, to be used for all steps.
///
/// throws  Unable  when there is none
std::shared_ptr<const Processing> launch_of(const Scene& scene, const StepChoice& choice,
                                            const ForceChoice& chosen = {});

/// How many frames reach the end.
std::int64_t frames_to(const DoubleDouble& end, const Rational& frame);

/// The forces that an integrator is asked for: those of the scene, without what the budget's engine does
/// itself.
ForceChoice asked_forces(const Scene& scene, const std::string& integrator, const ForceChoice& chosen = {});

/// The processor time that something takes in this thread (the turns of other programs do not count), the
/// mean of so many times.
double nanoseconds_of(const std::function<void()>& once, int times);

}  // namespace shortfall
