// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <barrier>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/outcome_text.hpp"
#include "analysis/trade/trade.hpp"
#include "tests/scratch_folder.hpp"

using namespace shortfall;

namespace {

const char* const kScene =
    "until = 2\ndt = 0.1\n[[body]]\nposition = 1\n[[force]]\nkind = \"spring\"\nstiffness = "
    "1\n[[observable]]\n"
    "kind = \"position\"\ntolerance = 1e-3\n";

SceneOutcome sample() {
  SceneOutcome o;
  o.choice = {"rk4", {}, true, "f32", Rational(1, 3)};
  o.choice.substeps = 4;
  o.steps = 1'000'000'007;
  o.evaluations = 4'000'000'028;
  o.errors = {0.1, -1.0 / 3, 5e-324, std::numeric_limits<double>::infinity()};
  o.nanoseconds = 1e9 / 7;
  return o;
}

bool same(const SceneOutcome& a, const SceneOutcome& b) {
  return a.steps == b.steps && a.evaluations == b.evaluations && a.failed == b.failed && a.why == b.why &&
         a.errors == b.errors && a.nanoseconds == b.nanoseconds;
}

}  // namespace

TEST_CASE("outcomes come back from a store and from a line with all their bits") {
  const ScratchFolder scratch;
  SceneOutcome failed;
  failed.failed = true;
  failed.why = "not finite after frame 3,\n\"quoted\" 'text'";
  {
    PointStore store(scratch.path("s.sqlite"));
    CHECK(!store.find("a"));
    store.put("a", sample());
    store.put("b", failed);
    store.put("a", sample());
    CHECK(store.size() == 2);
  }
  const PointStore again(scratch.path("s.sqlite"));
  REQUIRE(again.find("a"));
  CHECK(same(*again.find("a"), sample()));
  CHECK(again.find("a")->choice.frame == Rational(1, 3));
  CHECK(again.find("a")->choice.launched);
  CHECK(same(*again.find("b"), failed));
  CHECK(same(outcome_of_line(as_line(sample())), sample()));
  CHECK(outcome_of_line(as_line(failed)).failed);
  CHECK_THROWS_AS(outcome_of_line("nonsense"), Error);
}

TEST_CASE("what is no store is refused, and left as it is") {
  const ScratchFolder scratch;
  CHECK_THROWS_AS(PointStore("/nowhere/store.sqlite"), UnreadableFile);
  const auto file = scratch.root() / "letter.txt";
  std::FILE* f = std::fopen(file.c_str(), "w");
  std::fputs("Dear reader, this is no database, and it is long enough to be looked at as one.", f);
  std::fclose(f);
  CHECK_THROWS_AS(PointStore(file.string()), UnreadableFile);
  CHECK(std::filesystem::file_size(file) == 79);
}

TEST_CASE("a key knows the scene, its end, the way of stepping and the integrator itself") {
  const Scene scene = scene_of(kScene, "s.toml");
  const StepChoice choice{"rk4", {}, false, "f64", Rational(1, 10)};
  const std::string key = point_key(scene, choice);
  Scene later = scene;
  later.until = 3;
  Scene other = scene_of(std::string(kScene) + "\n# a remark", "s.toml");
  StepChoice launched = choice, narrow = choice, shorter = choice, several = choice;
  launched.launched = true;
  narrow.format = "f32";
  shorter.frame = Rational(1, 20);
  several.substeps = 2;
  CHECK(point_key(scene, choice) == key);
  CHECK(point_key(later, choice) != key);
  CHECK(point_key(other, choice) != key);
  for (const StepChoice& c : {launched, narrow, shorter, several}) CHECK(point_key(scene, c) != key);
}

TEST_CASE("threads, one after the other, and from a store: the same points give the same bits") {
  const ScratchFolder scratch;
  const Scene scene = scene_of(kScene, "s.toml");
  TradeQuestion question;
  question.integrators = {"symplectic-euler", "rk4", "implicit-midpoint"};
  question.repeats = 0;
  question.peers = false;
  const Trade threads = trade(scene, question);
  question.run_points = [](std::size_t count, const auto& one, const Progress&) {
    std::vector<SceneOutcome> outcomes;
    for (std::size_t i = 0; i < count; ++i) outcomes.push_back(one(i));
    return outcomes;
  };
  const Trade in_turn = trade(scene, question);
  PointStore store(scratch.path("s.sqlite"));
  question.store = &store;
  const Trade kept = trade(scene, question);
  const std::int64_t points = store.size();
  question.run_points = [](std::size_t count, const auto& one, const Progress&) {
    std::vector<SceneOutcome> outcomes;
    for (std::size_t i = 0; i < count; ++i) outcomes.push_back(one(i));
    return outcomes;
  };
  const Trade again = trade(scene, question);
  CHECK(store.size() == points);
  REQUIRE(threads.series.size() == in_turn.series.size());
  REQUIRE(threads.series.size() == again.series.size());
  std::int64_t seen = 0;
  for (std::size_t s = 0; s < threads.series.size(); ++s)
    for (std::size_t p = 0; p < threads.series[s].points.size(); ++p) {
      CHECK(same(threads.series[s].points[p], in_turn.series[s].points[p]));
      CHECK(same(threads.series[s].points[p], kept.series[s].points[p]));
      CHECK(same(threads.series[s].points[p], again.series[s].points[p]));
      ++seen;
    }
  CHECK(seen == points);
}

TEST_CASE("a store can be made by many at once") {
  const ScratchFolder scratch;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const std::string path = scratch.path(std::to_string(round) + ".sqlite");
    std::barrier together(4);
    std::mutex said;
    std::vector<std::string> errors;
    std::vector<std::thread> openers;
    for (int i = 0; i < 4; ++i)
      openers.emplace_back([&, i] {
        together.arrive_and_wait();
        try {
          PointStore(path).put(std::to_string(i), sample());
        } catch (const Error& e) {
          const std::lock_guard lock(said);
          errors.emplace_back(e.what());
        }
      });
    for (std::thread& opener : openers) opener.join();
    for (const std::string& error : errors) FAIL_CHECK(error);
    CHECK(PointStore(path).size() == 4);
  }
}
