// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>

#include "analysis/trade/peers.hpp"

namespace shortfall {

namespace {

namespace odeint = boost::numeric::odeint;
using Doubles = std::vector<double>;

/// Thrown through odeint to end a run.
struct Stop {};

class FixedPeer : public Peer {
 public:
  std::string name() const override { return "odeint runge_kutta4"; }
  bool adaptive() const override { return false; }
  bool run(PeerForce& force, std::vector<double> y, double end, double h, double,
           const PeerFrame& frame) const override {
    odeint::runge_kutta4<Doubles> stepper;
    const auto system = [&](const Doubles& s, Doubles& slope, double t) { force(t, s.data(), slope.data()); };
    const auto steps = static_cast<std::int64_t>(std::ceil(end / h - 1e-9));
    for (std::int64_t n = 0; n < steps; ++n) {
      stepper.do_step(system, y, static_cast<double>(n) * h, h);
      if (frame && !frame(static_cast<double>(n + 1) * h, y)) return false;
    }
    return true;
  }
};

template <class Controlled>
class AdaptivePeer : public Peer {
 public:
  AdaptivePeer(std::string name, std::function<Controlled(double)> make)
      : name_(std::move(name)), make_(std::move(make)) {}
  std::string name() const override { return name_; }
  bool adaptive() const override { return true; }
  bool run(PeerForce& force, std::vector<double> y, double end, double h, double tolerance,
           const PeerFrame& frame) const override {
    Controlled stepper = make_(tolerance);
    const auto system = [&](const Doubles& s, Doubles& slope, double t) { force(t, s.data(), slope.data()); };
    double t = 0, width = h;
    while (t < end) {
      if (t + width > end) width = end - t;
      if (!std::isfinite(y[0]) || !(width > 1e-14 * end) || force.evaluations > kMostPeerEvaluations)
        return t >= end * (1 - 1e-12);
      if (stepper.try_step(system, y, t, width) != odeint::success) continue;
      if (frame && !frame(t, y)) return false;
    }
    return true;
  }

 private:
  std::string name_;
  std::function<Controlled(double)> make_;
};

template <class Make>
std::unique_ptr<Peer> adaptive_peer(std::string name, Make make) {
  return std::make_unique<AdaptivePeer<decltype(make(0.0))>>(std::move(name), make);
}

}  // namespace

std::vector<std::unique_ptr<Peer>> odeint_peers() {
  std::vector<std::unique_ptr<Peer>> peers;
  peers.push_back(std::make_unique<FixedPeer>());
  peers.push_back(adaptive_peer("odeint dopri5, adaptive", [](double tolerance) {
    return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<Doubles>());
  }));
  peers.push_back(adaptive_peer("odeint bulirsch_stoer, adaptive", [](double tolerance) {
    return odeint::bulirsch_stoer<Doubles>(tolerance, tolerance);
  }));
  return peers;
}

}  // namespace shortfall
