// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/by_dt.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/candidate.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall {

namespace {

/// How far an undamped map is too high under a = -1 after a time t, in units of t dt/2.
double share_of(const Candidate& candidate) {
  constexpr double kDt = 0.01;
  constexpr std::size_t kFrames = 100;
  const Responses r = responses(frame_map(*candidate.tape, candidate.circumstances(kDt, 0, 0)), kFrames + 1);
  const double t = kDt * kFrames;
  return (-r.position[kFrames][2] + t * t / 2) / (t * kDt / 2);
}

}  // namespace

ByDt by_dt(std::vector<ByDtPoint> points, std::optional<double> g) {
  if (points.size() < 3)
    throw BadInput("--by-dt needs three points or more: 30Hz:165px 60Hz:150px 120Hz:142.5px");
  std::ranges::sort(points, [](const auto& a, const auto& b) { return a.dt > b.dt; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].dt == points[i - 1].dt) throw BadInput("--by-dt: two points have the same step");
  const auto h = [&](std::size_t i) { return points[i].dt.to_double(); };
  const auto y = [&](std::size_t i) { return points[i].value.to_double(); };
  const double first = y(0) - y(1), second = y(1) - y(2);
  if (first == 0 && second == 0)
    throw Undefined("the values do not depend on the step: there is no error to be seen");
  const double ratio = first / second;
  const auto shape = [&](double p) {
    return (std::pow(h(0), p) - std::pow(h(1), p)) / (std::pow(h(1), p) - std::pow(h(2), p));
  };
  double low = 0.05, high = 12;
  if (!(ratio > shape(low)) || !(ratio < shape(high)))
    throw Undefined("the values do not approach a limit as the steps get shorter: no order explains them");
  for (int i = 0; i < 200; ++i) (shape((low + high) / 2) < ratio ? low : high) = (low + high) / 2;
  ByDt result;
  result.order = (low + high) / 2;
  if (const double whole = std::round(result.order); std::fabs(whole - result.order) < 0.1 && whole >= 1) {
    result.whole_order = true;
    result.order = whole;
  }
  const double p = result.order;
  const std::size_t last = points.size() - 1;
  result.slope = (y(0) - y(last)) / (std::pow(h(0), p) - std::pow(h(last), p));
  result.limit = y(last) - result.slope * std::pow(h(last), p);
  for (std::size_t i = 0; i <= last; ++i)
    result.misfit =
        std::max(result.misfit, std::fabs(result.limit + result.slope * std::pow(h(i), p) - y(i)));
  if (!result.whole_order || p != 1) return result;
  if (g && result.limit > 0) result.share = 2 * result.slope / std::sqrt(2 * *g * result.limit);
  for (const Candidate& c : known_candidates()) {
    const double share = share_of(c);
    const bool side = share * result.slope > 0 && std::fabs(share) > 1e-6;
    const bool plain = c.substeps == 1;
    if (result.share ? std::fabs(share - *result.share) < 0.05 * std::fabs(*result.share)
                     : side && plain &&
                           (!c.counts || *c.counts == candidate(*c.program, std::nullopt).substep_count()))
      result.maps.push_back(c.str());
  }
  return result;
}

}  // namespace shortfall
