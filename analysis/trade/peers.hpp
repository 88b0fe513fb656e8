// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/trade/scene_model.hpp"

namespace shortfall {

/// y' for y = (x, v), counted.
struct PeerForce {
  explicit PeerForce(const Scene& scene) : acceleration(scene), m(scene.coordinates()) {}
  void operator()(double t, const double* y, double* slope) {
    ++evaluations;
    for (int i = 0; i < m; ++i) slope[i] = y[m + i];
    acceleration(y, y + m, t, slope + m);
  }
  SceneAcceleration<double> acceleration;
  int m;
  std::int64_t evaluations = 0;
};

/// Told of every step; false: stop.
using PeerFrame = std::function<bool(double t, const std::vector<double>& y)>;

inline constexpr std::int64_t kMostPeerEvaluations = 50'000'000;

/// A stepper of another library, in binary64.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;
  /// Whether it chooses its steps by a tolerance.
  virtual bool adaptive() const = 0;
  /// From y to the end; false when it gave up.
  ///
  /// param  h          the step, or the first one
  ///        tolerance  absolute and relative, for those that choose their steps
  virtual bool run(PeerForce& force, std::vector<double> y, double end, double h, double tolerance,
                   const PeerFrame& frame) const = 0;
};

std::vector<std::unique_ptr<Peer>> gsl_peers();
std::vector<std::unique_ptr<Peer>> odeint_peers();

}  // namespace shortfall
