// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/peers.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
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
    try {
      finite = reader.frame(DoubleDouble(t), x, v);
    } catch (const Undefined&) {  // too wild to be read between frames; not through their code
      finite = false;
    }
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

constexpr int kTolerances = 11;

/// Those that choose their steps by a tolerance go through tolerances instead of steps.
double tolerance_of(int k) { return std::pow(10.0, -2 - k); }

std::vector<std::shared_ptr<const Peer>> all_peers() {
  std::vector<std::shared_ptr<const Peer>> peers;
  for (auto& p : gsl_peers()) peers.push_back(std::move(p));
  for (auto& p : odeint_peers()) peers.push_back(std::move(p));
  return peers;
}

}  // namespace

std::vector<PeerSeries> peer_series(const Scene& scene, const SceneReference& reference,
                                    const std::vector<Rational>& steps) {
  const double end = reference.end.high();
  std::vector<PeerSeries> all;
  for (const auto& peer : all_peers()) {
    PeerSeries series{{peer->name(), {}, "f64", false, {}}, {}};
    const int count = peer->adaptive() ? kTolerances : static_cast<int>(steps.size());
    for (int i = 0; i < count; ++i) {
      const Rational step = peer->adaptive() ? steps[0] : steps[static_cast<std::size_t>(i)];
      const double h = step.to_double(), tolerance = peer->adaptive() ? tolerance_of(i) : 0;
      SceneOutcome outcome = observed(*peer, scene, reference, h, tolerance);
      outcome.choice.integrator = peer->name();
      outcome.choice.frame = peer->adaptive() ? Rational(0) : step;
      outcome.tolerance = tolerance;
      series.series.points.push_back(std::move(outcome));
      series.once.push_back([peer, force = std::make_shared<PeerForce>(scene), y = start(scene), end, h,
                             tolerance] { peer->run(*force, y, end, h, tolerance, {}); });
    }
    all.push_back(std::move(series));
  }
  return all;
}

}  // namespace shortfall
