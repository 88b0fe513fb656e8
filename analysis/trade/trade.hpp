// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/trade/point_store.hpp"
#include "analysis/trade/scene_run.hpp"

namespace shortfall {

/// Does the points 0 .. count - 1, in any order and at once if it can, and returns them in theirs.
using RunPoints = std::function<std::vector<SceneOutcome>(
    std::size_t count, const std::function<SceneOutcome(std::size_t)>& one, const Progress& progress)>;
/// By as many threads as the machine has cores.
std::vector<SceneOutcome> run_points_in_threads(std::size_t count,
                                                const std::function<SceneOutcome(std::size_t)>& one,
                                                const Progress& progress);

/// Which ways of stepping a scene are compared.
struct TradeQuestion {
  std::vector<std::string> integrators;  ///< names of the catalogue; empty: a usual choice
  std::vector<std::string> formats;      ///< empty: those of the scene's budget
  bool launches = true;                  ///< those that have a launch also with it
  std::vector<Rational> steps;           ///< empty: eleven, by factors of two around the scene's dt
  int repeats = 10;                      ///< of each time measurement, interleaved; 0: no times
  RunPoints run_points = run_points_in_threads;
  PointStore* store = nullptr;  ///< where points are kept as they come, and looked up first
  bool peers = true;            ///< GSL's and Boost.odeint's steppers beside ours
  int at_once = 0;              ///< so many motions side by side as series of their own; 0: none
};

/// One way of stepping with all its steps, from the longest to the shortest.
struct TradeSeries {
  std::string label;       ///< "velocity-verlet, f64", "GSL rkf45"
  std::string integrator;  ///< of the catalogue; empty for a peer
  std::string format;
  bool launched = false;
  std::vector<SceneOutcome> points;
  int at_once = 0;  ///< so many motions side by side; the times are those of one of them; 0: one alone
  /// For each observable: the observed order, and the steps between which it holds.
  struct Order {
    double order = 0;
    double longest = 0;
    double shortest = 0;
  };
  std::vector<std::optional<Order>> orders{};
};

/// Work against precision.
struct Trade {
  Scene scene;
  SceneReference reference;
  std::vector<TradeSeries> series;
  /// What no run can do: a way of stepping that is refused, and why.
  std::vector<std::pair<std::string, std::string>> refused;
  /// Of each observable, for each format, the rounding of the true value itself: no run reads better but by
  /// luck.
  std::vector<std::vector<std::pair<std::string, double>>> floors;
  bool timed = false;
};

/// A place in a trade.
struct TradePlace {
  std::size_t series = 0;
  std::size_t point = 0;
};

/// Errors and times of all the points.
///
/// throws  as scene_reference; BadInput for an unknown integrator or format
Trade trade(const Scene& scene, const TradeQuestion& question, const Progress& progress = {});

/// Those points that no other one beats in cost (nanoseconds when measured, force evaluations otherwise) and
/// in the error of an observable, from cheap to precise.
std::vector<TradePlace> pareto_front(const Trade& trade, std::size_t observable);
/// The cheapest point that meets all tolerances. Neither counts motions that are only cheap in company.
std::optional<TradePlace> cheapest(const Trade& trade);
double cost(const Trade& trade, const SceneOutcome& outcome);

/// The observed order between steps h[i] and errors e[i] (0: unknown), and where it holds: the longest run of
/// steps over which the slopes of neighbours differ by less than 0.25, well above `floor`; at least three.
std::optional<TradeSeries::Order> observed_order(const std::vector<double>& steps,
                                                 const std::vector<double>& errors, double floor);

/// A stepper of another library on the same scene; errors are read off in the same way.
struct PeerSeries {
  TradeSeries series;
  std::vector<std::function<void()>> once;  ///< each point again, nothing read, to be measured
};
std::vector<PeerSeries> peer_series(const Scene& scene, const SceneReference& reference,
                                    const std::vector<Rational>& steps);

}  // namespace shortfall
