// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/trade.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/float_format.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/trade/scene_lanes.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kMostFrames = 4'000'000;
constexpr double kMostMeasured = 2e8;               ///< nanoseconds of one measurement
constexpr std::int64_t kMostStepsAtOnce = 400'000;  ///< of all motions of one measurement

std::vector<Rational> usual_steps(const Scene& scene, const DoubleDouble& end) {
  std::vector<Rational> steps;
  for (int k = 3; k >= -7; --k) {
    const Rational h = scene.step * Rational(2).pow(k);
    const std::int64_t frames = frames_to(end, h);
    if (frames >= 2 && frames <= kMostFrames) steps.push_back(h);
  }
  return steps;
}

std::vector<std::string> usual_integrators(const Scene& scene) {
  std::vector<std::string> names{"symplectic-euler", "velocity-verlet", "forest-ruth", "rk4",
                                 "dormand-prince"};
  for (const std::string& extra : {scene.naive, scene.budget.integrator})
    if (!extra.empty() && std::ranges::find(names, extra) == names.end()) names.push_back(extra);
  return names;
}

struct Timing {
  SceneOutcome* outcome;
  std::function<void()> once;
  double scenes = 1;  ///< how many of them `once` does
};

/// Each in turn, again and again, so that what else the machine does hits all alike; the least counts.
void measure(std::vector<Timing>& timings, int repeats, const Progress& progress) {
  const int all = static_cast<int>(timings.size());
  for (int r = 0; r < repeats; ++r)
    for (int i = 0; i < all; ++i) {
      if (progress && i % 16 == 0) progress("measuring times", r * all + i, repeats * all);
      const Timing& timing = timings[static_cast<std::size_t>(i)];
      double& best = timing.outcome->nanoseconds;
      if (r > 1 && best * timing.scenes > kMostMeasured) continue;
      // Short runs are repeated within a measurement: a clock has its own grain.
      const bool is_short = best > 0 && best * timing.scenes < 2e4;
      const double one = nanoseconds_of(timing.once, is_short ? 10 : 1) / timing.scenes;
      if (best == 0 || one < best) best = one;
    }
}

/// Series that can be stepped side by side, once more as such: the same errors, other times.
void add_lanes(Trade& trade, int count) {
  const std::size_t alone = trade.series.size();
  for (std::size_t i = 0; i < alone; ++i) {
    if (trade.series[i].launched) continue;
    TradeSeries many = trade.series[i];
    many.label += ", " + std::to_string(count) + " at once";
    many.at_once = count;
    if (const auto why = why_no_lanes(trade.scene, many.points[0].choice))
      trade.refused.emplace_back(many.label, *why);
    else
      trade.series.push_back(std::move(many));
  }
}

/// Runs of the scene, or of enough of it to be measured where it is done many times at once.
Timing timing_of(const Trade& trade, const TradeSeries& series, SceneOutcome& o) {
  const std::int64_t frames = frames_to(trade.reference.end, o.choice.frame);
  o.nanoseconds = 0;
  if (series.at_once == 0) {
    const auto stepping = std::make_shared<SceneStepping>(trade.scene, o.choice);
    return {&o, [stepping, frames] { stepping->run(frames); }};
  }
  const auto lanes = std::make_shared<SceneLanes>(trade.scene, o.choice, series.at_once);
  const std::int64_t of_one =
      std::max<std::int64_t>(1, kMostStepsAtOnce / series.at_once / o.choice.substeps);
  const std::int64_t done = std::min(frames, of_one);
  return {&o, [lanes, done] { lanes->run(done); },
          series.at_once * static_cast<double>(done) / static_cast<double>(frames)};
}

double unit_roundoff(const std::string& format) {
  return format == "f32" ? 0x1p-24 : format == "dd" ? 0x1p-106 : 0x1p-53;
}

/// The size of what an observable reads; an energy's drift is relative already.
double magnitude(const SceneObservable& o, const SceneReading<DoubleDouble>& reading) {
  if (o.kind == SceneObservable::Kind::energy_drift) return 1;
  double largest = 0;
  for (const DoubleDouble& v : reading.value) largest = std::max(largest, std::fabs(v.high()));
  return largest;
}

}  // namespace

std::vector<SceneOutcome> run_points_in_threads(std::size_t count,
                                                const std::function<SceneOutcome(std::size_t)>& one,
                                                const Progress& progress) {
  std::vector<SceneOutcome> outcomes(count);
  std::atomic<int> done = 0;
  std::mutex one_voice;
  // The last points have the shortest steps and take longest: they come first.
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        const std::size_t point = count - 1 - i;
        outcomes[point] = one(point);
        const int so_far = ++done;
        if (!progress) return;
        const std::lock_guard lock(one_voice);
        progress("stepping", so_far, static_cast<int>(count));
      },
      tbb::simple_partitioner());
  return outcomes;
}

std::optional<TradeSeries::Order> observed_order(const std::vector<double>& steps,
                                                 const std::vector<double>& errors, double floor) {
  std::vector<double> slopes(steps.size(), 0);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const bool good = errors[i] > 30 * floor && errors[i + 1] > 30 * floor && errors[i + 1] < errors[i];
    slopes[i] = good ? std::log(errors[i] / errors[i + 1]) / std::log(steps[i] / steps[i + 1]) : 0;
  }
  std::optional<TradeSeries::Order> best;
  std::size_t longest = 1;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (slopes[i] == 0) continue;
    std::size_t j = i;
    while (j + 1 < slopes.size() && slopes[j + 1] != 0 && std::fabs(slopes[j + 1] - slopes[i]) < 0.25 &&
           std::fabs(slopes[j + 1] - slopes[j]) < 0.25)
      ++j;
    // Of equally long ranges the one with shorter steps: there the order is what it is said to be.
    if (j - i + 1 > longest || (best && j - i + 1 == longest && longest >= 2)) {
      longest = j - i + 1;
      best = TradeSeries::Order{slopes[j], steps[i], steps[j + 1]};
    }
  }
  return best;
}

double cost(const Trade& trade, const SceneOutcome& outcome) {
  return trade.timed ? outcome.nanoseconds : static_cast<double>(outcome.evaluations);
}

std::vector<TradePlace> pareto_front(const Trade& trade, std::size_t observable) {
  std::vector<TradePlace> all;
  for (std::size_t s = 0; s < trade.series.size(); ++s)
    for (std::size_t p = 0; p < trade.series[s].points.size(); ++p)
      if (!trade.series[s].points[p].failed && trade.series[s].at_once == 0) all.push_back({s, p});
  const auto at = [&](const TradePlace& p) -> const SceneOutcome& {
    return trade.series[p.series].points[p.point];
  };
  const auto error = [&](const TradePlace& p) { return std::fabs(at(p).errors[observable]); };
  std::ranges::sort(all, [&](const TradePlace& a, const TradePlace& b) {
    const double x = cost(trade, at(a)), y = cost(trade, at(b));
    return x < y || (x == y && error(a) < error(b));
  });
  std::vector<TradePlace> front;
  for (const TradePlace& p : all)
    if (front.empty() || error(p) < error(front.back())) front.push_back(p);
  return front;
}

std::optional<TradePlace> cheapest(const Trade& trade) {
  std::optional<TradePlace> best;
  double least = 0;
  for (std::size_t s = 0; s < trade.series.size(); ++s)
    for (std::size_t p = 0; p < trade.series[s].points.size(); ++p) {
      const SceneOutcome& o = trade.series[s].points[p];
      if (!o.meets(trade.scene) || trade.series[s].at_once > 0) continue;
      if (best && cost(trade, o) >= least) continue;
      best = TradePlace{s, p};
      least = cost(trade, o);
    }
  return best;
}

Trade trade(const Scene& scene, const TradeQuestion& question, const Progress& progress) {
  Trade result;
  result.scene = scene;
  result.timed = question.repeats > 0;
  std::vector<Program> programs;
  for (const std::string& name :
       question.integrators.empty() ? usual_integrators(scene) : question.integrators)
    programs.push_back(find_integrator(name));
  std::vector<std::string> formats;
  for (const std::string& f : question.formats.empty() ? scene.budget.formats : question.formats)
    formats.push_back(float_format(f).name());
  result.reference = scene_reference(scene, 30, {}, progress);
  const std::vector<Rational> steps =
      question.steps.empty() ? usual_steps(scene, result.reference.end) : question.steps;
  if (steps.empty())
    throw BadInput("no step of the scene '" + scene.name + "' is short enough to be compared");

  struct Point {
    std::size_t series;
    StepChoice choice;
  };
  std::vector<Point> points;
  for (const Program& program : programs)
    for (const std::string& format : formats)
      for (const bool launched : {false, true}) {
        if (launched && !question.launches) continue;
        StepChoice choice{word_for(program), {}, launched, format, steps[0]};
        if (choice.integrator == scene.budget.integrator) choice.parameters = scene.budget.parameters;
        try {
          if (launched) choice.launch = launch_of(scene, choice);
          SceneStepping(scene, choice);
        } catch (const BadInput&) {
          throw;
        } catch (const Error& e) {  // that it has no launch is no news
          if (!launched) result.refused.emplace_back(choice.label(), e.what());
          continue;
        }
        result.series.push_back({choice.label(), choice.integrator, format, launched, {}});
        for (const Rational& h : steps) {
          choice.frame = h;
          points.push_back({result.series.size() - 1, choice});
        }
      }
  const auto one = [&](std::size_t i) {
    const std::string key = question.store ? point_key(scene, points[i].choice) : "";
    if (question.store)
      if (auto kept = question.store->find(key)) return *kept;
    SceneOutcome outcome = SceneStepping(scene, points[i].choice).observe(result.reference);
    if (question.store) question.store->put(key, outcome);
    return outcome;
  };
  std::vector<SceneOutcome> outcomes = question.run_points(points.size(), one, progress);
  for (std::size_t i = 0; i < points.size(); ++i) {
    outcomes[i].choice = points[i].choice;
    result.series[points[i].series].points.push_back(std::move(outcomes[i]));
  }
  if (result.series.empty())
    throw Unable("none of these can step the scene: " +
                 (result.refused.empty() ? std::string() : result.refused[0].second));
  if (question.at_once > 0) add_lanes(result, question.at_once);
  std::vector<Timing> timings;
  for (TradeSeries& s : result.series)
    for (SceneOutcome& o : s.points)
      if (!o.failed) timings.push_back(timing_of(result, s, o));
  std::vector<PeerSeries> peers;
  if (question.peers) peers = peer_series(scene, result.reference, steps);
  for (PeerSeries& p : peers)
    for (std::size_t i = 0; i < p.series.points.size(); ++i)
      if (!p.series.points[i].failed) timings.push_back({&p.series.points[i], p.once[i]});
  measure(timings, question.repeats, progress);
  if (question.store && result.timed)
    for (const TradeSeries& s : result.series)
      if (s.at_once == 0)
        for (const SceneOutcome& o : s.points) question.store->put(point_key(scene, o.choice), o);
  for (PeerSeries& p : peers) result.series.push_back(std::move(p.series));

  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    result.floors.emplace_back();
    for (const std::string& f : formats)
      result.floors.back().emplace_back(
          f, unit_roundoff(f) * magnitude(scene.observables[i], result.reference.readings[i]));
  }
  for (TradeSeries& s : result.series)
    for (std::size_t i = 0; i < scene.observables.size(); ++i) {
      std::vector<double> h, e;
      for (const SceneOutcome& o : s.points) {
        h.push_back(o.choice.frame.to_double());
        e.push_back(o.failed ? 0 : std::fabs(o.errors[i]));
      }
      const double floor = unit_roundoff(s.format) *
                           std::max(magnitude(scene.observables[i], result.reference.readings[i]), 1e-300);
      s.orders.push_back(s.integrator.empty() ? std::nullopt : observed_order(h, e, floor));
    }
  return result;
}

}  // namespace shortfall
