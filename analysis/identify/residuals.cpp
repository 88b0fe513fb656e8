// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/residuals.hpp"

#include "analysis/identify/observations.hpp"

namespace shortfall {

std::vector<Residual> residuals(const Log& log, const Identification& found, const Match& match) {
  const double dt = found.dt.to_double();
  const Observations o = observations(log, dt, found.first, found.last);
  std::vector<Residual> result;
  const auto add = [&](std::size_t row, const Log::Triple& x) {
    Residual r;
    r.time = dt * static_cast<double>(log.rows[found.first + row].frame - log.rows.front().frame);
    for (const int axis : o.axes) {
      const auto i = static_cast<std::size_t>(axis);
      r.missing[i] = o.x[row][i] - x[i];
    }
    result.push_back(r);
  };
  if (match.exact) {
    fly(match.candidate, o.frame, dt, match.flight,
        [&](std::size_t row, const Log::Triple& x, const Log::Triple&) {
          add(row, x);
          return true;
        });
    return result;
  }
  const Fit& fit = match.fit;
  const Circumstances circumstances = match.candidate.circumstances(dt, fit.c.value, fit.k.value);
  const Responses r = responses(frame_map(*match.candidate.tape, circumstances), o.frames());
  for (std::size_t row = 0; row < o.rows(); ++row) {
    const Responses::Row& weight = r.position[o.frame[row]];
    Log::Triple x{};
    for (const int axis : o.axes) {
      const auto i = static_cast<std::size_t>(axis);
      x[i] = weight[0] * fit.x0[i].value + weight[1] * fit.v0[i].value + weight[2] * fit.a[i].value +
             weight[3] * fit.j[i].value;
    }
    add(row, x);
  }
  return result;
}

}  // namespace shortfall
