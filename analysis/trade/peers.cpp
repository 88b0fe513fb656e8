// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/peers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "analysis/trade/frame_reader.hpp"
#include "analysis/trade/trade.hpp"

namespace shortfall {

namespace {

std::vector<double> start(const Scene& scene) {
  std::vector<double> y;
  for (const DoubleDouble& c : initial_positions(scene)) y.push_back(c.high());
  for (const DoubleDouble& c : initial_velocities(scene)) y.push_back(c.high());
  return y;
}

SceneOutcome observed(const Peer& peer, const Scene& scene, const SceneReference& reference, double h,
                      double tolerance) {
  SceneOutcome outcome;
  const double end = reference.end.high();
  FrameReader reader(scene, reference, end);
  reader.frame(DoubleDouble(0), initial_positions(scene), initial_velocities(scene));
  PeerForce force(scene);
  const auto m = static_cast<std::size_t>(scene.coordinates());
  bool finite = true;
  const PeerFrame frame = [&](double t, const std::vector<double>& y) {
    std::vector<DoubleDouble> x, v;
    for (std::size_t i = 0; i < m; ++i) x.emplace_back(y[i]);
    for (std::size_t i = 0; i < m; ++i) v.emplace_back(y[m + i]);
    if (t <= end * (1 + 1e-12)) {
      ++outcome.steps;
      outcome.evaluations = force.evaluations;
    }
    finite = reader.frame(DoubleDouble(t), x, v);
    return finite && !reader.is_done();
  };
  // An event that ends the scene may come a little later than the true one.
  const bool events =
      std::ranges::any_of(scene.observables, [](const auto& o) { return o.event.has_value(); });
  peer.run(force, start(scene), events ? 1.5 * end : end, h, tolerance, frame);
  if (!finite) {
    outcome.failed = true;
    outcome.why = "not finite";
    return outcome;
  }
  reader.finish(outcome);
  return outcome;
}

double timed(const Peer& peer, const Scene& scene, double end, double h, double tolerance) {
  using Clock = std::chrono::steady_clock;
  PeerForce force(scene);
  std::vector<double> y = start(scene);
  const auto from = Clock::now();
  peer.run(force, std::move(y), end, h, tolerance, {});
  return std::chrono::duration<double, std::nano>(Clock::now() - from).count();
}

constexpr int kTolerances = 11;
constexpr double kMostMeasured = 2e8;  ///< nanoseconds of one measurement

/// Those that choose their steps by a tolerance go through tolerances instead of steps.
double tolerance_of(int k) { return std::pow(10.0, -2 - k); }

}  // namespace

std::vector<TradeSeries> peer_series(const Scene& scene, const SceneReference& reference,
                                     const std::vector<Rational>& steps, int repeats) {
  const double end = reference.end.high();
  std::vector<std::unique_ptr<Peer>> peers = gsl_peers();
  for (auto& p : odeint_peers()) peers.push_back(std::move(p));
  std::vector<TradeSeries> all;
  std::vector<std::vector<std::pair<double, double>>> asked;  // step, tolerance
  for (const auto& peer : peers) {
    TradeSeries series{peer->name(), {}, "f64", false, {}};
    asked.emplace_back();
    const int count = peer->adaptive() ? kTolerances : static_cast<int>(steps.size());
    for (int i = 0; i < count; ++i) {
      const double h =
          peer->adaptive() ? steps[0].to_double() : steps[static_cast<std::size_t>(i)].to_double();
      const double tolerance = peer->adaptive() ? tolerance_of(i) : 0;
      SceneOutcome outcome = observed(*peer, scene, reference, h, tolerance);
      outcome.choice.integrator = peer->name();
      outcome.choice.frame = peer->adaptive() ? Rational(0) : steps[static_cast<std::size_t>(i)];
      outcome.tolerance = tolerance;
      series.points.push_back(std::move(outcome));
      asked.back().emplace_back(h, tolerance);
    }
    all.push_back(std::move(series));
  }
  for (int r = 0; r < repeats; ++r)
    for (std::size_t p = 0; p < all.size(); ++p)
      for (std::size_t i = 0; i < all[p].points.size(); ++i) {
        SceneOutcome& o = all[p].points[i];
        if (o.failed || (r > 1 && o.nanoseconds > kMostMeasured)) continue;
        const double one = timed(*peers[p], scene, end, asked[p][i].first, asked[p][i].second);
        if (o.nanoseconds == 0 || one < o.nanoseconds) o.nanoseconds = one;
      }
  return all;
}

}  // namespace shortfall
