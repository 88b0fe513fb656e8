// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>

#include "analysis/trade/frame_reader.hpp"
#include "analysis/trade/peers.hpp"

namespace shortfall {

namespace {

/// y = (x, v) as GSL wants it.
int field(double t, const double* y, double* slope, void* data) {
  PeerForce& force = *static_cast<PeerForce*>(data);
  force(t, y, slope);
  return GSL_SUCCESS;
}

/// Its steppers of several steps want to know their driver, so all that choose their steps have one.
struct Driver {
  gsl_odeiv2_driver* driver;
  Driver(const gsl_odeiv2_system& system, const gsl_odeiv2_step_type* type, double h, double tolerance)
      : driver(gsl_odeiv2_driver_alloc_y_new(&system, type, h, tolerance, tolerance)) {}
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  ~Driver() { gsl_odeiv2_driver_free(driver); }
};

class GslPeer : public Peer {
 public:
  GslPeer(std::string name, const gsl_odeiv2_step_type* type, bool adaptive)
      : name_(std::move(name)), type_(type), adaptive_(adaptive) {}
  std::string name() const override { return name_; }
  bool adaptive() const override { return adaptive_; }

  bool run(PeerForce& force, std::vector<double> y, double end, double h, double tolerance,
           const PeerFrame& frame) const override {
    gsl_odeiv2_system system{field, nullptr, y.size(), &force};
    // A driver without a tolerance of its own still makes the stepper; fixed steps do not look at it.
    const Driver with(system, type_, h, adaptive_ ? tolerance : 1);
    double t = 0;
    if (!adaptive_) {
      const auto steps = static_cast<std::int64_t>(std::ceil(end / h - 1e-9));
      for (std::int64_t n = 0; n < steps; ++n) {
        if (gsl_odeiv2_evolve_apply_fixed_step(with.driver->e, nullptr, with.driver->s, &system, &t, h,
                                               y.data()) != GSL_SUCCESS)
          return false;
        t = static_cast<double>(n + 1) * h;
        if (frame && !frame(t, y)) return false;
      }
      return true;
    }
    double width = h;
    while (t < end) {
      if (gsl_odeiv2_evolve_apply(with.driver->e, with.driver->c, with.driver->s, &system, &t, end, &width,
                                  y.data()) != GSL_SUCCESS ||
          !std::isfinite(y[0]) || force.evaluations > kMostPeerEvaluations)
        return false;
      if (frame && !frame(t, y)) return false;
    }
    return true;
  }

 private:
  std::string name_;
  const gsl_odeiv2_step_type* type_;
  bool adaptive_;
};

}  // namespace

std::vector<std::unique_ptr<Peer>> gsl_peers() {
  gsl_set_error_handler_off();  // errors come back as codes
  std::vector<std::unique_ptr<Peer>> peers;
  peers.push_back(std::make_unique<GslPeer>("GSL rk4", gsl_odeiv2_step_rk4, false));
  peers.push_back(std::make_unique<GslPeer>("GSL rkf45, adaptive", gsl_odeiv2_step_rkf45, true));
  peers.push_back(std::make_unique<GslPeer>("GSL rk8pd, adaptive", gsl_odeiv2_step_rk8pd, true));
  peers.push_back(std::make_unique<GslPeer>("GSL msadams, adaptive", gsl_odeiv2_step_msadams, true));
  return peers;
}

}  // namespace shortfall
