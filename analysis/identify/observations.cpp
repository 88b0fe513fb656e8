// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/observations.hpp"

#include <algorithm>
#include <cmath>

namespace shortfall {

namespace {

double largest(const std::vector<Log::Triple>& values, const std::vector<int>& axes) {
  double result = 0;
  for (const Log::Triple& value : values)
    for (const int axis : axes) result = std::max(result, std::fabs(value[static_cast<std::size_t>(axis)]));
  return result;
}

double half(const LogRounding& rounding, double value, double most) {
  if (!rounding.exact()) return rounding.half(value);
  return std::max(most, 1e-30) * (rounding.kind == LogRounding::Kind::binary32 ? 0x1p-24 : 0x1p-53);
}

}  // namespace

double Observations::half_position(double value) const {
  return half(rounding, value, rounding.exact() ? largest_position() : 0);
}
double Observations::half_velocity(double value) const {
  return half(velocity_rounding, value, velocity_rounding.exact() ? largest_velocity() : 0);
}

Observations observations(const Log& log, double dt, std::size_t first, std::size_t last) {
  Observations o;
  o.axes = log.axes;
  o.velocities = log.velocities;
  o.rounding = log.position_rounding;
  o.velocity_rounding = log.velocity_rounding;
  o.dt = dt;
  for (std::size_t i = first; i < last; ++i) {
    const Log::Row& row = log.rows[i];
    o.frame.push_back(static_cast<std::size_t>(row.frame - log.rows[first].frame));
    o.x.push_back(row.x);
    o.v.push_back(row.v);
  }
  o.most_position = largest(o.x, o.axes);
  o.most_velocity = largest(o.v, o.axes);
  return o;
}

}  // namespace shortfall
