// SPDX-License-Identifier: GPL-3.0-or-later
// A force that a user wrote as an expression beside the same force of the library, and the advice for the
// shipped scenes beside their naive choices.
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/advice.hpp"
#include "analysis/trade/scene_lanes.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/ratios.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::time_text;

namespace {

constexpr int kRounds = 12;
constexpr std::int64_t kSteps = 20'000;
constexpr int kAtOnce = 1024;
constexpr std::int64_t kStepsAtOnce = 200;

struct Pair {
  const char* what;
  int dimension;
  const char* start;
  const char* library;
  const char* written;
};

// The same force, once as a kind of the library and once as an expression.
const Pair kPairs[] = {
    {"spring", 1, "position = 1", "kind = \"spring\"\nstiffness = 2",
     "kind = \"expression\"\nacceleration = \"-2*x\""},
    {"pendulum", 1, "position = 1", "kind = \"pendulum\"\ngravity = 2\nlength = 1",
     "kind = \"expression\"\nacceleration = \"-2*sin(x)\""},
    {"Kepler", 2, "position = [1, 0]\nvelocity = [0, 1]", "kind = \"kepler\"\nmu = 1",
     "kind = \"expression\"\nacceleration = [\"-x/(sqrt(x*x + y*y)*sqrt(x*x + y*y)*sqrt(x*x + y*y))\", "
     "\"-y/(sqrt(x*x + y*y)*sqrt(x*x + y*y)*sqrt(x*x + y*y))\"]"},
};

Scene scene_with(const Pair& p, const char* force) {
  const std::string angles = std::string(p.what) == "pendulum" ? "coordinates = \"angles\"\n" : "";
  return scene_of(angles + "until = 200\ndt = 0.01\ndimension = " + std::to_string(p.dimension) +
                      "\n[[body]]\n" + p.start + "\n[[force]]\n" + force +
                      "\n[[observable]]\nkind = \"position\"\ntolerance = 1\n",
                  "bench.toml");
}

void expressions() {
  std::printf(
      "\nA force written as an expression, beside the library's: velocity Verlet in binary64, %lld steps\n",
      static_cast<long long>(kSteps));
  for (const Pair& p : kPairs) {
    const Scene library = scene_with(p, p.library), written = scene_with(p, p.written);
    const StepChoice choice{"velocity-verlet", {}, false, "f64", Rational(1, 100)};
    SceneStepping ours(library, choice), theirs(written, choice);
    std::vector<Contender> all{here("library", [&] { ours.run(kSteps); }),
                               here("expression", [&] { theirs.run(kSteps); })};
    const std::vector<double> least = bench::least_times(all, kRounds, 2e-3);
    const double ratio = least[1] / least[0];
    std::printf("  %-10s %10s a step, as an expression %10s: %5.2f times   target 3%s\n", p.what,
                time_text(least[0] / static_cast<double>(kSteps)).c_str(),
                time_text(least[1] / static_cast<double>(kSteps)).c_str(), ratio,
                ratio <= 3 ? "   met" : "   MISSED");
    const std::string work = std::string(p.what) + " written as an expression, velocity Verlet";
    bench::note_ratio(work, "the library's force", least[1], least[0]);
    if (why_no_lanes(written, choice)) continue;
    SceneLanes many_ours(library, choice, kAtOnce), many_theirs(written, choice, kAtOnce);
    std::vector<Contender> lanes{here("library", [&] { ours.run(kSteps); }),
                                 here("library in lanes", [&] { many_ours.run(kStepsAtOnce); }),
                                 here("expression in lanes", [&] { many_theirs.run(kStepsAtOnce); })};
    const std::vector<double> times = bench::least_times(lanes, kRounds, 2e-3);
    const double one = times[0] / static_cast<double>(kSteps);
    const auto in_lanes = [](double time) { return time / static_cast<double>(kStepsAtOnce * kAtOnce); };
    std::printf(
        "  %-10s %10s a step in lanes, as an expression %10s: %5.2f times one alone   target below 1%s\n", "",
        time_text(in_lanes(times[1])).c_str(), time_text(in_lanes(times[2])).c_str(),
        in_lanes(times[2]) / one, in_lanes(times[2]) < one ? "   met" : "   MISSED");
    bench::note_ratio(work + ", 1024 in lanes", "one motion alone", in_lanes(times[2]), one);
  }
}

void scenes() {
  std::printf("\nAdvice for the shipped scenes, beside the naive choice with as many steps as it needs\n");
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SHORTFALL_SCENES)) files.insert(entry.path());
  for (const auto& file : files) {
    if (file.extension() != ".toml") continue;
    try {
      const Scene scene = read_scene(file.string());
      const Advice a = advise(scene, {});
      if (!a.best)
        std::printf("  %-20s nothing is good enough\n", scene.name.c_str());
      else if (!a.naive)
        std::printf("  %-20s %10s  %s; %s is never good enough\n", scene.name.c_str(),
                    time_text(a.best->nanoseconds * 1e-9).c_str(), a.best->choice.label().c_str(),
                    scene.naive.c_str());
      else
        std::printf("  %-20s %10s  %s; %s: %.2f times\n", scene.name.c_str(),
                    time_text(a.best->nanoseconds * 1e-9).c_str(), a.best->choice.label().c_str(),
                    a.naive->choice.label().c_str(), a.naive->nanoseconds / a.best->nanoseconds);
    } catch (const Error& e) {
      std::printf("  %-20s %s\n", file.stem().c_str(), e.what());
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main() {
  expressions();
  scenes();
}
