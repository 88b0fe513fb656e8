// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/float_format.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall {

namespace {

/// Those that are likely to need the fewest evaluations come first: what cannot beat them is then given up
/// early.
constexpr std::array kUsual{"velocity-verlet",
                            "rk4",
                            "pefrl",
                            "blanes-moan-rkn6",
                            "kutta3",
                            "position-verlet",
                            "midpoint",
                            "dormand-prince",
                            "forest-ruth",
                            "yoshida6",
                            "bogacki-shampine",
                            "heun",
                            "ruth3",
                            "implicit-midpoint",
                            "symplectic-euler",
                            "symplectic-euler-drift-kick",
                            "explicit-euler"};
constexpr std::array kSubsteps{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256, 512, 1024};
constexpr std::int64_t kMostAdvisedSteps = 2'000'000;
constexpr std::size_t kFinalists = 8;
/// An evaluation of one way of stepping costs at most so many of another: what needs more evaluations than
/// that has no chance to be the cheapest.
constexpr double kHopeless = 6;
/// Times of one machine in one minute: nearer than this they are the same, and the evaluations decide. So the
/// same question gets the same answer.
constexpr double kSameTime = 1.25;

class Adviser {
 public:
  Adviser(Advice& advice, const AdviceQuestion& question, const Progress& progress)
      : advice_(advice), scene_(advice.scene), question_(question), progress_(progress) {}

  void search() {
    const std::vector<StepChoice> ways = all_ways();
    std::vector<SceneOutcome> good;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (progress_)
        progress_("trying " + ways[i].label(), static_cast<int>(i), static_cast<int>(ways.size()));
      if (auto found = cheapest_of(ways[i])) good.push_back(std::move(*found));
    }
    std::ranges::stable_sort(
        good, [](const SceneOutcome& a, const SceneOutcome& b) { return a.evaluations < b.evaluations; });
    if (good.size() > kFinalists) good.resize(kFinalists);
    measure(good);
    std::erase_if(good, [&](const SceneOutcome& o) { return !is_fast_enough(o); });
    std::ranges::stable_sort(
        good, [](const SceneOutcome& a, const SceneOutcome& b) { return a.nanoseconds < b.nanoseconds; });
    const auto slower = std::ranges::find_if(
        good, [&](const SceneOutcome& o) { return o.nanoseconds > kSameTime * good.front().nanoseconds; });
    std::stable_sort(good.begin(), slower, [](const SceneOutcome& a, const SceneOutcome& b) {
      return a.evaluations < b.evaluations;
    });
    advice_.considered = good;
    if (!good.empty()) advice_.best = good.front();
  }

  /// The longest step of the scene's naive integrator that is good enough, in the last format, all forces
  /// kept.
  void find_naive() {
    StepChoice choice{
        scene_.naive, {}, false, float_format(scene_.budget.formats.back()).name(), scene_.step};
    if (scene_.naive == scene_.budget.integrator) choice.parameters = scene_.budget.parameters;
    least_evaluations_ = 0;  // it is asked for however expensive it is
    const ForceChoice kept = advice_.kept;
    advice_.kept.clear();
    // As a user would: frames as they are, and smaller steps until it is good enough.
    auto found = with_substeps(choice, scene_.step);
    if (found) {
      std::vector<SceneOutcome> one{std::move(*found)};
      measure(one);
      advice_.naive = std::move(one.front());
    }
    advice_.kept = kept;
  }

 private:
  std::vector<StepChoice> all_ways() const {
    std::vector<std::string> names = question_.integrators;
    if (!scene_.budget.integrator.empty())
      names = {scene_.budget.integrator};
    else if (names.empty())
      for (const char* n : kUsual) names.emplace_back(n);
    std::vector<StepChoice> ways;
    for (const std::string& name : names)
      for (const bool launched : {false, true}) {
        StepChoice way{word_for(find_integrator(name)), {}, launched, "", scene_.step};
        if (way.integrator == scene_.budget.integrator) way.parameters = scene_.budget.parameters;
        try {
          if (launched) way.launch = launch_of(scene_, way, advice_.kept);
        } catch (const Error&) {
          continue;  // it has none for these forces
        }
        for (const std::string& format : scene_.budget.formats) {
          way.format = float_format(format).name();
          ways.push_back(way);
        }
      }
    return ways;
  }

  /// One run; remembered when it comes nearer than all others.
  std::optional<SceneOutcome> run(const StepChoice& choice) {
    ++advice_.tried;
    SceneOutcome outcome = SceneStepping(scene_, choice, advice_.kept).observe(advice_.reference);
    const double share = worst_share(scene_, outcome);
    if (std::isfinite(share) && share < nearest_) {
      nearest_ = share;
      advice_.closest = outcome;
    }
    if (share < best_of_way_ * 0.7) {
      best_of_way_ = share;
      without_gain_ = 0;
    } else {
      ++without_gain_;
    }
    return outcome.meets(scene_, 1 / question_.margin) ? std::optional(std::move(outcome)) : std::nullopt;
  }

  /// Shorter steps no longer help: the rounding of the format is in the way. Far from the tolerance it is the
  /// step that is still too long to be stable.
  bool is_stuck() const { return without_gain_ >= 4 && best_of_way_ < 1000; }
  void begin_way() {
    best_of_way_ = INFINITY;
    without_gain_ = 0;
  }

  bool is_hopeless(std::int64_t steps) const {
    return least_evaluations_ > 0 &&
           static_cast<double>(steps) > kHopeless * static_cast<double>(least_evaluations_);
  }

  std::optional<SceneOutcome> noted(std::optional<SceneOutcome> found) {
    if (found && (least_evaluations_ == 0 || found->evaluations < least_evaluations_))
      least_evaluations_ = found->evaluations;
    return found;
  }

  std::optional<SceneOutcome> cheapest_of(const StepChoice& way) {
    try {
      if (scene_.budget.steps.empty()) return noted(with_any_step(way));
      std::optional<SceneOutcome> best;
      for (const Rational& frame : scene_.budget.steps) {
        auto found = with_substeps(way, frame);
        if (found && (!best || found->evaluations < best->evaluations)) best = std::move(found);
      }
      return noted(std::move(best));
    } catch (const Unable&) {
      return std::nullopt;  // no launch, or no such step for this scene
    } catch (const Undefined&) {
      return std::nullopt;
    }
  }

  /// The fewest substeps of a frame that are good enough.
  std::optional<SceneOutcome> with_substeps(StepChoice choice, const Rational& frame) {
    choice.frame = frame;
    begin_way();
    const std::int64_t frames = frames_to(advice_.reference.end, frame);
    for (int n : kSubsteps) {
      if (n > scene_.budget.most_substeps || frames * n > kMostAdvisedSteps || is_hopeless(frames * n) ||
          is_stuck())
        return std::nullopt;
      choice.substeps = n;
      if (auto found = run(choice)) return found;
    }
    return std::nullopt;
  }

  /// The fewest steps that are good enough, when any step is allowed: by doubling, then between.
  std::optional<SceneOutcome> with_any_step(StepChoice choice) {
    const Rational whole = Rational::from_double(advice_.reference.end.high());
    const auto with = [&](std::int64_t steps) {
      // A step that a person can write down.
      choice.frame = Rational::parse((whole / Rational(steps)).significant(4));
      return run(choice);
    };
    begin_way();
    for (std::int64_t steps = 4; steps <= kMostAdvisedSteps && !is_hopeless(steps) && !is_stuck();
         steps *= 2) {
      std::optional<SceneOutcome> found = with(steps);
      // An error can pass through zero by accident: a shorter step must be good as well.
      if (!found || !with(steps + steps / 4 + 1)) continue;
      std::int64_t bad = steps / 2, good = steps;
      for (int halving = 0; halving < 5 && good - bad > std::max<std::int64_t>(1, good / 24); ++halving) {
        const std::int64_t middle = (bad + good) / 2;
        auto between = with(middle);
        if (between && with(middle + middle / 8 + 1)) {
          good = middle;
          found = std::move(between);
        } else {
          bad = middle;
        }
      }
      return found;
    }
    return std::nullopt;
  }

  bool is_fast_enough(const SceneOutcome& o) const {
    if (!scene_.budget.microseconds || o.nanoseconds == 0) return true;
    const auto frames = static_cast<double>(frames_to(advice_.reference.end, o.choice.frame));
    return o.nanoseconds / frames <= 1e3 * scene_.budget.microseconds->to_double();
  }

  void measure(std::vector<SceneOutcome>& outcomes) {
    std::vector<SceneStepping> steppings;
    for (const SceneOutcome& o : outcomes) steppings.emplace_back(scene_, o.choice, advice_.kept);
    for (int r = 0; r < question_.repeats; ++r)
      for (std::size_t i = 0; i < outcomes.size(); ++i) {
        SceneOutcome& o = outcomes[i];
        if (r > 1 && o.nanoseconds > 2e8) continue;
        const std::int64_t frames = frames_to(advice_.reference.end, o.choice.frame);
        const double one = nanoseconds_of([&] { steppings[i].run(frames); },
                                          o.nanoseconds > 0 && o.nanoseconds < 2e4 ? 20 : 1);
        if (o.nanoseconds == 0 || one < o.nanoseconds) o.nanoseconds = one;
      }
  }

  Advice& advice_;
  const Scene& scene_;
  const AdviceQuestion& question_;
  const Progress& progress_;
  std::int64_t least_evaluations_ = 0;
  double nearest_ = INFINITY;
  double best_of_way_ = INFINITY;
  int without_gain_ = 0;
};

/// The parts of the error of the best.
std::vector<AdviceError> parts_of(const Advice& advice) {
  const Scene& scene = advice.scene;
  const SceneReference modelled = scene_reference(scene, 30, advice.kept, {}, advice.reference.end);
  StepChoice wide = advice.best->choice;
  wide.format = "dd";
  const SceneOutcome exact = SceneStepping(scene, wide, advice.kept).observe(modelled);
  const SceneOutcome in_wide = SceneStepping(scene, wide, advice.kept).observe(advice.reference);
  std::vector<AdviceError> errors;
  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    AdviceError e;
    e.total = advice.best->errors[i];
    if (scene.observables[i].kind != SceneObservable::Kind::energy_drift)
      e.modelling = reading_error(scene, i, advice.reference.readings[i], modelled.readings[i]);
    if (!exact.failed) e.method = exact.errors[i];
    if (!in_wide.failed) e.rounding = e.total - in_wide.errors[i];
    errors.push_back(e);
  }
  return errors;
}

}  // namespace

double worst_share(const Scene& scene, const SceneOutcome& outcome) {
  if (outcome.failed || outcome.errors.empty()) return INFINITY;
  double worst = 0;
  for (std::size_t i = 0; i < outcome.errors.size(); ++i) {
    const double share = std::fabs(outcome.errors[i]) / scene.observables[i].tolerance.to_double();
    if (!(share <= worst)) worst = share;
  }
  return worst;
}

Advice advise(const Scene& scene, const AdviceQuestion& question, const Progress& progress) {
  if (!(question.margin >= 1))
    throw BadInput("a margin is 1 or more: errors are at most the tolerance over it");
  Advice advice;
  advice.scene = scene;
  advice.margin = question.margin;
  advice.reference = scene_reference(scene, 30, {}, progress);
  advice.effects = force_effects(advice.scene, advice.reference, question.modelling_share, advice.kept,
                                 advice.dropped, progress);
  Adviser adviser(advice, question, progress);
  adviser.search();
  if (advice.best) {
    // Once more, by a run of its own: what is advised is what was seen.
    SceneOutcome again =
        SceneStepping(advice.scene, advice.best->choice, advice.kept).observe(advice.reference);
    if (again.errors != advice.best->errors) throw Error("the run that is advised does not repeat itself");
    advice.errors = parts_of(advice);
  }
  adviser.find_naive();
  return advice;
}

}  // namespace shortfall
