// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/trade.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/float_format.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/trade/taylor_numbers.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kMostFrames = 4'000'000;
constexpr double kMostMeasured = 2e8;  ///< nanoseconds of one measurement

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
  SceneStepping stepping;
  std::int64_t frames;
  double best = 0;
};

/// Each in turn, again and again, so that what else the machine does hits all alike; the least counts.
void measure(std::vector<Timing>& timings, int repeats, const Progress& progress) {
  for (int r = 0; r < repeats; ++r) {
    int done = 0;
    for (Timing& t : timings) {
      if (progress && done++ % 16 == 0)
        progress("measuring times", r * static_cast<int>(timings.size()) + done,
                 repeats * static_cast<int>(timings.size()));
      if (r > 1 && t.best > kMostMeasured) continue;
      // Short runs are repeated within a measurement: a clock has its own grain.
      const int inner = t.best > 0 && t.best < 2e4 ? 10 : 1;
      double sum = 0;
      for (int i = 0; i < inner; ++i) sum += t.stepping.time(t.frames);
      const double one = sum / inner;
      if (t.best == 0 || one < t.best) t.best = one;
    }
  }
  for (Timing& t : timings) t.outcome->nanoseconds = t.best;
}

double unit_roundoff(const std::string& format) {
  return format == "f32" ? 0x1p-24 : format == "dd" ? 0x1p-106 : 0x1p-53;
}

/// The size of what an observable reads.
double magnitude(const SceneReading<DoubleDouble>& reading) {
  double largest = 0;
  for (const DoubleDouble& v : reading.value) largest = std::max(largest, std::fabs(v.high()));
  return largest;
}

}  // namespace

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
    while (j + 1 < slopes.size() && slopes[j + 1] != 0 && std::fabs(slopes[j + 1] - slopes[i]) < 0.35 &&
           std::fabs(slopes[j + 1] - slopes[j]) < 0.35)
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
      if (!trade.series[s].points[p].failed) all.push_back({s, p});
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
      if (!o.meets(trade.scene)) continue;
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

  std::vector<Timing> timings;
  int done = 0;
  const int all = static_cast<int>(programs.size() * formats.size());
  for (const Program& program : programs)
    for (const std::string& format : formats) {
      if (progress) progress("stepping " + program.name + " in " + format, done++, all);
      for (const bool launched : {false, true}) {
        if (launched && !question.launches) continue;
        StepChoice choice{program.name, {}, launched, format, steps[0]};
        if (program.name == scene.budget.integrator) choice.parameters = scene.budget.parameters;
        TradeSeries series{choice.label(), program.name, format, launched, {}};
        for (const Rational& h : steps) {
          choice.frame = h;
          try {
            series.points.push_back(SceneStepping(scene, choice).observe(result.reference));
          } catch (const Unable& e) {
            if (!launched) result.refused.emplace_back(choice.label(), e.what());
            break;
          } catch (const Undefined& e) {
            if (!launched) result.refused.emplace_back(choice.label(), e.what());
            break;
          }
        }
        if (!series.points.empty()) result.series.push_back(std::move(series));
      }
    }
  if (result.series.empty())
    throw Unable("none of these can step the scene: " +
                 (result.refused.empty() ? std::string() : result.refused[0].second));
  if (result.timed) {
    for (TradeSeries& s : result.series)
      for (SceneOutcome& o : s.points) {
        if (o.failed) continue;
        timings.push_back(
            {&o, SceneStepping(scene, o.choice), frames_to(result.reference.end, o.choice.frame)});
      }
    measure(timings, question.repeats, progress);
  }
  if (question.peers)
    for (TradeSeries& s : peer_series(scene, result.reference, steps, question.repeats))
      result.series.push_back(std::move(s));

  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    result.floors.emplace_back();
    for (const std::string& f : formats)
      result.floors.back().emplace_back(f, unit_roundoff(f) * magnitude(result.reference.readings[i]));
  }
  for (TradeSeries& s : result.series)
    for (std::size_t i = 0; i < scene.observables.size(); ++i) {
      std::vector<double> h, e;
      for (const SceneOutcome& o : s.points) {
        h.push_back(o.choice.frame.to_double());
        e.push_back(o.failed ? 0 : std::fabs(o.errors[i]));
      }
      const double floor =
          unit_roundoff(s.format) * std::max(magnitude(result.reference.readings[i]), 1e-300);
      s.orders.push_back(s.integrator.empty() ? std::nullopt : observed_order(h, e, floor));
    }
  return result;
}

}  // namespace shortfall
