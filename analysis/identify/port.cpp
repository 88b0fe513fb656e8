// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/port.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kMostFrames = 20'000;
constexpr std::size_t kFewest = 5;

}  // namespace

Port port(const PortQuestion& q) {
  // Every `stride`-th frame of the first engine is one of the second: dt ratio p/r in lowest terms.
  const Rational ratio = q.from_dt / q.to_dt;
  const double stride = ratio.denominator().to_double(), other = ratio.numerator().to_double();
  if (stride > 1000 || other > 1000)
    throw Unable("the two tick rates have hardly a frame in common: give rates whose ratio is simpler");
  const double dt = q.from_dt.to_double();
  const FrameMap map = frame_map(*q.from.tape, q.from.circumstances(dt, q.c, q.k));
  const double longest = q.k != 0 ? 4 * 2 * std::numbers::pi / std::sqrt(q.k) : 4 * q.launch / q.g + 1;
  const auto frames =
      static_cast<std::size_t>(std::clamp(longest / dt, 8 * stride, static_cast<double>(kMostFrames)));
  const Responses r = responses(map, frames + 1);
  Observations o;
  o.axes = {1};
  o.dt = q.to_dt.to_double();
  o.rounding = o.velocity_rounding = {LogRounding::Kind::binary64, 0};
  Port result;
  for (std::size_t i = 0; static_cast<double>(i) * stride <= static_cast<double>(frames); ++i) {
    const auto& row = r.position[i * static_cast<std::size_t>(stride)];
    const double x = row[1] * q.launch - row[2] * q.g;
    if (!std::isfinite(x)) break;
    if (q.k == 0 && x < 0 && o.rows() > kFewest) break;  // it has landed
    o.frame.push_back(i * static_cast<std::size_t>(other));
    o.x.push_back({0, x, 0});
    o.v.push_back({});
    o.most_position = std::max(o.most_position, std::fabs(x));
    result.peak = std::max(result.peak, x);
  }
  if (o.rows() < kFewest) throw Unable("the two tick rates have too few frames in common during this motion");
  // A damping number, a spring constant: guesses from the same rates.
  FitQuestion question;
  question.damping = q.c != 0;
  question.spring = q.k != 0;
  question.rate =
      q.c != 0 ? -std::log(std::max(map.step[1].part[1] + (q.k != 0 ? q.k * dt * dt : 0), 1e-9)) / dt : 0;
  question.stiffness = q.k;
  const std::optional<Fit> found = fit(q.to, o, question);
  if (!found) throw Unable("the second engine cannot make this motion: it explodes");
  result.fit = *found;
  result.held = found->a[1].value + q.g;
  result.frames = o.rows();
  result.duration = static_cast<double>(o.frame.back()) * o.dt;
  result.error = found->worst_position;
  result.exact = result.error <= 1e-11 * std::max(o.most_position, 1e-3) * static_cast<double>(o.rows());
  return result;
}

}  // namespace shortfall
