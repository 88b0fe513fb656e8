// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/advice.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace shortfall;

namespace {

Scene shipped(const std::string& name) {
  return read_scene(SHORTFALL_SOURCE_DIR "/scenes/" + name + ".toml");
}

AdviceQuestion quick() {
  AdviceQuestion question;
  question.repeats = 1;
  return question;
}

}  // namespace

TEST_CASE("advice is good enough by an independent run, and no dearer than the naive choice") {
  for (const char* name :
       {"jump", "grenade", "spring-door", "feather", "stiff-spring", "jump-rapier", "jump-godot"}) {
    CAPTURE(std::string(name));
    const Scene scene = shipped(name);
    const Advice advice = advise(scene, quick());
    REQUIRE(advice.best);
    const SceneReference reference = scene_reference(scene, 45);
    SceneOutcome again = SceneStepping(scene, advice.best->choice, advice.kept).observe(reference);
    CHECK(again.meets(scene, 0.5 * (1 + 1e-12)));
    CHECK(worst_share(scene, again) <= 0.5);
    // Which of those is the fastest is measured; that none needs more evaluations than the naive choice is
    // not luck.
    if (advice.naive) {
      std::int64_t fewest = advice.best->evaluations;
      for (const SceneOutcome& o : advice.considered) fewest = std::min(fewest, o.evaluations);
      CHECK(fewest <= advice.naive->evaluations);
    }
    for (const SceneOutcome& o : advice.considered) CHECK(o.meets(scene, 0.5));
    // Of those that take the same time, as nearly as times are known, it needs the fewest evaluations.
    double least = advice.best->nanoseconds;
    for (const SceneOutcome& o : advice.considered) least = std::min(least, o.nanoseconds);
    CHECK(advice.best->nanoseconds <= 1.25 * least);
    for (const SceneOutcome& o : advice.considered)
      if (o.nanoseconds <= 1.25 * least) CHECK(o.evaluations >= advice.best->evaluations);
    // The parts of an error that is one number add up to it.
    for (std::size_t i = 0; i < advice.errors.size(); ++i) {
      const AdviceError& e = advice.errors[i];
      if (scene.observables[i].is_vector() || scene.observables[i].kind == SceneObservable::Kind::path)
        continue;
      CHECK(e.modelling + e.method + e.rounding == doctest::Approx(e.total).epsilon(1e-9));
    }
  }
}

TEST_CASE(
    "a force is left out when it changes nothing that is asked, and kept when the tolerance is smaller") {
  Scene scene = shipped("jump");
  Advice advice = advise(scene, quick());
  CHECK(advice.kept == ForceChoice{true, false});
  CHECK(advice.dropped[0] > 1e-9);
  CHECK(advice.dropped[0] == doctest::Approx(advice.effects[1].changes[0]));
  for (SceneObservable& o : scene.observables) o.tolerance = Rational(1, 1'000'000);
  advice = advise(scene, quick());
  CHECK(advice.kept == ForceChoice{true, true});
}

TEST_CASE("an engine that is fixed stays, with the substeps that it needs") {
  const Scene scene = shipped("jump-godot");
  const Advice advice = advise(scene, quick());
  REQUIRE(advice.best);
  CHECK(advice.best->choice.integrator == "godot");
  CHECK(advice.best->choice.frame == Rational(1, 60));
  CHECK(advice.best->choice.substeps > 1);
  StepChoice fewer = advice.best->choice;
  fewer.substeps /= 2;
  CHECK(!SceneStepping(scene, fewer).observe(advice.reference).meets(scene, 0.5));
}

TEST_CASE("when nothing is good enough, that is said with what comes closest") {
  Scene scene = shipped("spring-door");
  for (SceneObservable& o : scene.observables) o.tolerance = Rational(1, 1'000'000'000);
  const Advice advice = advise(scene, quick());
  CHECK(!advice.best);
  REQUIRE(advice.closest);
  CHECK(worst_share(scene, *advice.closest) > 0.5);
}
