// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "analysis/trade/peers.hpp"

namespace shortfall {

namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;

/// Thrown through odeint to end a run.
struct Stop {};

class FixedPeer : public Peer {
 public:
  std::string name() const override { return "odeint runge_kutta4"; }
  bool adaptive() const override { return false; }
  bool run(PeerForce& force, std::vector<double> y, double end, double h, double,
           const PeerFrame& frame) const override {
    odeint::runge_kutta4<State> stepper;
    const auto system = [&](const State& s, State& slope, double t) { force(t, s.data(), slope.data()); };
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
  AdaptivePeer(std::string name, Controlled (*make)(double)) : name_(std::move(name)), make_(make) {}
  std::string name() const override { return name_; }
  bool adaptive() const override { return true; }
  bool run(PeerForce& force, std::vector<double> y, double end, double h, double tolerance,
           const PeerFrame& frame) const override {
    Controlled stepper = make_(tolerance);
    const auto system = [&](const State& s, State& slope, double t) { force(t, s.data(), slope.data()); };
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
  Controlled (*make_)(double);
};

using Dopri = odeint::result_of::make_controlled<odeint::runge_kutta_dopri5<State>>::type;

}  // namespace

std::vector<std::unique_ptr<Peer>> odeint_peers() {
  std::vector<std::unique_ptr<Peer>> peers;
  peers.push_back(std::make_unique<FixedPeer>());
  peers.push_back(std::make_unique<AdaptivePeer<Dopri>>("odeint dopri5, adaptive", [](double tolerance) {
    return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<State>());
  }));
  peers.push_back(std::make_unique<AdaptivePeer<odeint::bulirsch_stoer<State>>>(
      "odeint bulirsch_stoer, adaptive",
      [](double tolerance) { return odeint::bulirsch_stoer<State>(tolerance, tolerance); }));
  return peers;
}

}  // namespace shortfall
