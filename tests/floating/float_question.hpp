// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bodies that float formats are asked about.

#include <string>
#include <utility>

#include "analysis/floating/float_run.hpp"
#include "analysis/motion/force.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall::testing {

/// At x = 1, at rest.
inline FloatQuestion resting_body(Program program, const std::string& force, const Rational& h) {
  FloatQuestion q;
  q.program = std::move(program);
  q.force = force_named(force);
  q.h = h;
  q.x0 = 1;
  return q;
}

inline FloatQuestion resting_body(const std::string& integrator, const std::string& force,
                                  const Rational& h) {
  return resting_body(find_integrator(integrator), force, h);
}

/// At x = 1, with v = -1/3.
inline FloatQuestion moving_body(const std::string& integrator, const std::string& force, const Rational& h) {
  FloatQuestion q = resting_body(integrator, force, h);
  q.v0 = Rational(-1, 3);
  return q;
}

}  // namespace shortfall::testing
