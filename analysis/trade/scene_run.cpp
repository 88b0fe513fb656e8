// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_run.hpp"

#include <cmath>
#include <ctime>

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_run.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/trade/frame_reader.hpp"
#include "analysis/trade/interpreted_run.hpp"
#include "analysis/trade/rounded_number.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kMostSteps = 200'000'000;

template <class S>
S nearest(const DoubleDouble& value) {
  // A pair's high part is the nearest binary64; binary32 is asked of the exact sum.
  if constexpr (std::is_same_v<S, float>)
    return (Rational::from_double(value.high()) + Rational::from_double(value.low())).to_float();
  else if constexpr (std::is_same_v<S, double>)
    return value.high();
  else
    return value;
}

DoubleDouble widened(const DoubleDouble& value) { return value; }
DoubleDouble widened(double value) { return DoubleDouble(value); }

}  // namespace

std::string StepChoice::label() const {
  std::string text = integrator;
  for (const auto& [name, value] : parameters)
    if (name != "substeps") text += " " + name + "=" + value.significant(4);
  if (substeps > 1) text += " x " + std::to_string(substeps);
  if (launched) text += " + launch";
  return text + ", " + format;
}

ChosenSteps chosen_steps(const StepChoice& choice) {
  ChosenSteps steps{find_integrator(choice.integrator), choice.parameters, choice.frame, choice.substeps};
  if (const auto own = substep_parameter(steps.program); own && choice.substeps > 1) {
    steps.parameters[*own] = choice.substeps;
    steps.a_frame = 1;
  } else {
    steps.h /= Rational(choice.substeps);
  }
  return steps;
}

bool SceneOutcome::meets(const Scene& scene, double share) const {
  if (failed) return false;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!(std::fabs(errors[i]) <= share * scene.observables[i].tolerance.to_double())) return false;
  return true;
}

std::int64_t frames_to(const DoubleDouble& end, const Rational& frame) {
  const Rational exact = Rational::from_double(end.high()) + Rational::from_double(end.low());
  const Rational frames = exact / frame;
  std::int64_t whole = 0;
  if (!frames.floor().fits_int64(whole) || whole > kMostSteps)
    throw BadInput("a run of " + (exact / frame).significant(3) + " steps would take too long; the most is " +
                   std::to_string(kMostSteps));
  // A last frame that misses the end by rounding counts as one that reaches it.
  return frames - Rational(whole) > Rational(1, 1'000'000'000) ? whole + 1 : whole;
}

ForceChoice asked_forces(const Scene& scene, const std::string& integrator, const ForceChoice& chosen) {
  ForceChoice result = chosen.empty() ? ForceChoice(scene.forces.size(), true) : chosen;
  if (integrator.empty() || integrator != scene.budget.integrator) return result;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (scene.forces[i].by_engine) result[i] = false;
  return result;
}

std::shared_ptr<const Processing> launch_of(const Scene& scene, const StepChoice& choice,
                                            const ForceChoice& chosen) {
  const SmoothTape stepped = acceleration_tape(scene, asked_forces(scene, choice.integrator, chosen));
  auto launch = launch_for(find_integrator(choice.integrator), choice.parameters, force_read_by(stepped));
  if (!launch) throw Unable(choice.integrator + " has no launch that raises its order for these forces");
  return std::make_shared<const Processing>(std::move(*launch));
}

struct SceneStepping::Machine {
  virtual ~Machine() = default;
  virtual SceneOutcome observe(const SceneReference& reference) = 0;
  virtual void step_through(std::int64_t frames) = 0;
};

template <class S>
struct SceneStepping::MachineOf : Machine {
  MachineOf(const Scene& the_scene, const StepChoice& how, const ForceChoice& chosen)
      : scene(the_scene),
        choice(how),
        acceleration(the_scene, asked_forces(the_scene, how.integrator, chosen)) {
    const auto [program, parameters, h, a_frame] = chosen_steps(choice);
    steps_a_frame = a_frame;
    x0 = initial_positions(scene);
    v0 = initial_velocities(scene);
    if (choice.launched) {
      const SmoothTape stepped = acceleration_tape(scene, asked_forces(scene, choice.integrator, chosen));
      const auto launch = choice.launch ? choice.launch : launch_of(scene, choice, chosen);
      step = double_double(h);
      read_out.emplace(stepped, launch->read_out);
      LaunchTerms(stepped, launch->launch).add(x0, v0, DoubleDouble(0), step);
    }
    const auto m = static_cast<std::size_t>(scene.coordinates());
    // Of a file of the user's there is no compiled code, of pairs of binary64 neither.
    constexpr bool compiled = !std::is_same_v<S, DoubleDouble>;
    if constexpr (compiled) {
      if (!choice.interpreted && !why_not_native(program))
        run = native_run<S>(program, parameters, rounded_number<S>(h), m, ForceReference<S>(force));
    }
    if (!run) run = interpreted_run<S>(program, parameters, h, m, ForceReference<S>(force));
    for (const DoubleDouble& c : x0) start_x.push_back(nearest<S>(c));
    for (const DoubleDouble& c : v0) start_v.push_back(nearest<S>(c));
    x.resize(m);
    v.resize(m);
  }

  void begin() {
    acceleration.begin_frame(start_x.data(), start_v.data(), rounded_number<S>(0));
    run->begin(start_x, start_v, rounded_number<S>(0));
  }

  void frame() {
    if (acceleration.holds()) {
      run->read_out(x, v);
      acceleration.begin_frame(x.data(), v.data(), run->time());
    }
    run->run(steps_a_frame);
  }

  SceneOutcome observe(const SceneReference& reference) override {
    SceneOutcome outcome;
    outcome.choice = choice;
    const std::int64_t frames = frames_to(reference.end, choice.frame);
    if (frames > kMostSteps / choice.substeps)
      throw BadInput("a run of " + std::to_string(frames) + " frames of " + std::to_string(choice.substeps) +
                     " substeps would take too long");
    FrameReader reader(scene, reference, choice.frame.to_double());
    try {
      begin();
      const std::int64_t before = run->force_evaluations();
      reader.frame(DoubleDouble(0), initial_positions(scene), initial_velocities(scene));
      const DoubleDouble width = double_double(choice.frame);
      for (std::int64_t n = 1; !reader.is_done() && n <= 2 * frames + 2; ++n) {
        frame();
        if (!show(reader, DoubleDouble(static_cast<double>(n)) * width)) {
          outcome.failed = true;
          outcome.why = "not finite after frame " + std::to_string(n);
          return outcome;
        }
        if (n != frames) continue;
        outcome.steps = frames * choice.substeps;
        outcome.evaluations = run->force_evaluations() - before;
      }
    } catch (const Undefined& e) {
      outcome.failed = true;
      outcome.why = e.what();
      return outcome;
    }
    reader.finish(outcome);
    return outcome;
  }

  /// What the run says now; false when it is not finite.
  bool show(FrameReader& reader, const DoubleDouble& t) {
    run->read_out(x, v);
    std::vector<DoubleDouble> at, moving;
    for (const S& c : x) at.push_back(widened(c));
    for (const S& c : v) moving.push_back(widened(c));
    if (read_out && std::isfinite(at[0].high())) read_out->add(at, moving, t, step);
    return reader.frame(t, at, moving);
  }

  void step_through(std::int64_t frames) override {
    begin();
    if (!acceleration.holds())
      run->run(frames * steps_a_frame);
    else
      for (std::int64_t n = 0; n < frames; ++n) frame();
    run->read_out(x, v);
  }

  const Scene& scene;
  StepChoice choice;
  SceneAcceleration<S> acceleration;
  int steps_a_frame = 1;
  std::vector<DoubleDouble> x0, v0;
  DoubleDouble step;
  std::optional<LaunchTerms> read_out;
  /// What the run calls; it refers to this object, which therefore never moves.
  struct Force {
    MachineOf* machine;
    void operator()(std::span<const S> at, std::span<const S> moving, S t, std::span<S> a) const {
      machine->acceleration(at.data(), moving.data(), t, a.data());
    }
  } force{this};
  std::unique_ptr<NativeRun<S>> run;
  std::vector<S> start_x, start_v, x, v;
};

SceneStepping::SceneStepping(const Scene& scene, const StepChoice& choice, const ForceChoice& chosen) {
  if (choice.format == "f32" || choice.format == "float")
    machine_ = std::make_unique<MachineOf<float>>(scene, choice, chosen);
  else if (choice.format == "f64" || choice.format == "double")
    machine_ = std::make_unique<MachineOf<double>>(scene, choice, chosen);
  else if (choice.format == "dd")
    machine_ = std::make_unique<MachineOf<DoubleDouble>>(scene, choice, chosen);
  else
    throw Unable("scenes are stepped in f32, f64 and dd; the error of other formats: shortfall budget");
}

SceneStepping::~SceneStepping() = default;
SceneStepping::SceneStepping(SceneStepping&&) noexcept = default;

SceneOutcome SceneStepping::observe(const SceneReference& reference) { return machine_->observe(reference); }
void SceneStepping::run(std::int64_t frames) { machine_->step_through(frames); }

double nanoseconds_of(const std::function<void()>& once, int times) {
  const auto now = [] {
    std::timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  };
  const double from = now();
  for (int i = 0; i < times; ++i) once();
  return (now() - from) / times;
}

}  // namespace shortfall
