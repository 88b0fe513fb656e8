// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/segments.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/program/catalogue.hpp"

namespace shortfall {

namespace {

const Candidate& proxy() {
  static const Program program = find_integrator("symplectic-euler");
  static const Candidate c = candidate(program, std::nullopt);
  return c;
}

bool same_place(const Log& log, std::size_t a, std::size_t b) {
  return std::ranges::all_of(log.axes, [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    return log.rows[a].x[i] == log.rows[b].x[i];
  });
}

/// How far a fit may be off: rounding, and the arithmetic of whatever engine it was.
bool fits(const Fit& f, const Observations& o) {
  const double narrow = o.rounding.kind == LogRounding::Kind::binary64 ? 0x1p-53 : 0x1p-24;
  const double n = static_cast<double>(o.frames());
  // A velocity that loses half a unit in every frame is off by n/2 units in the end, and the position by
  // their sum.
  const double step = o.frames() > 1 ? o.largest_position() : 0;
  const double noise = narrow * (o.largest_position() + step) * (8 + 0.5 * n);
  const double half = o.rounding.exact() ? 0 : o.half_position(o.largest_position());
  return f.worst_position <= 1.02 * half + noise;
}

std::optional<FitQuestion> explained(const Observations& o) {
  FitQuestion q;
  if (const auto f = fit(proxy(), o, q); f && fits(*f, o)) return q;
  for (const bool spring : {false, true}) {
    q.damping = true;
    q.spring = spring;
    for (const std::size_t stride : {1U, 2U, 4U, 8U}) {
      if (o.exact() && stride > 1) break;
      const RateGuess guess = rate_guess(o, stride, spring);
      q.rate = guess.rate;
      q.stiffness = guess.stiffness;
      const auto f = fit(proxy(), o, q);
      if (!f || !fits(*f, o)) continue;
      q.rate = f->c.value;
      q.stiffness = f->k.value;
      const FrameMap m = frame_map(*proxy().tape, proxy().circumstances(o.dt, q.rate, q.stiffness));
      q.invariants = true;
      q.trace = m.step[0].part[0] + m.step[1].part[1];
      q.determinant = m.step[0].part[0] * m.step[1].part[1] - m.step[0].part[1] * m.step[1].part[0];
      return q;
    }
  }
  return std::nullopt;
}

double speed(const Log& log, std::size_t row) {
  double square = 0;
  for (const double v : log.rows[row].v) square += v * v;
  return std::sqrt(square);
}

}  // namespace

std::optional<FitQuestion> needed(const Observations& observations) {
  Observations positions = observations;
  positions.velocities = false;
  return explained(positions);
}

void trim(const Log& log, std::size_t& first, std::size_t& last, std::vector<Break>& breaks) {
  constexpr std::size_t kStill = 3;
  std::size_t begin = first;
  while (begin + 1 < last && same_place(log, begin, begin + 1)) ++begin;
  if (begin - first >= 2) {
    breaks.push_back({Break::Kind::rest_before, begin, "until then the body rests"});
    first = begin;
  }
  std::size_t end = last;
  while (end > first + 1 && same_place(log, end - 1, end - 2)) --end;
  if (last - end >= kStill - 1) {
    // An engine that puts a body to sleep takes its velocity away after it has moved it.
    if (log.velocities && end > first + 2 && speed(log, end - 1) == 0 && speed(log, end - 2) > 0) --end;
    breaks.push_back(
        {Break::Kind::sleep, end, "from here on the body stands still: it was put to sleep, or it lies"});
    last = end;
  }
}

std::size_t longest(const Log& log, double dt, std::size_t first, std::size_t last) {
  constexpr std::size_t kFew = 6;
  const auto good = [&](std::size_t end) { return needed(observations(log, dt, first, end)).has_value(); };
  std::size_t low = first + kFew, high = last + 1;
  if (low > last || !good(low)) return first;
  while (high - low > 1) (good((low + high) / 2) ? low : high) = (low + high) / 2;
  // Few rows are explained by anything: the fit must hold for more rows than it has numbers.
  return low;
}

Break break_at(const Log& log, std::size_t first, std::size_t row) {
  Break result{Break::Kind::unexplained, row, "from here on the log shows something else"};
  const std::size_t n = log.rows.size();
  if (row + 1 < n && log.velocities && speed(log, row) > 0 &&
      std::fabs(speed(log, row + 1) / speed(log, row) - 1) < 1e-6 &&
      std::fabs(speed(log, row - 1) - speed(log, row)) > 1e-6)
    return {Break::Kind::limit, row, "from here on the speed stays the same: it has reached a limit"};
  for (const int axis : log.axes) {
    const auto i = static_cast<std::size_t>(axis);
    if (row + 1 >= n || row < first + 2) continue;
    const double before = log.rows[row - 1].x[i] - log.rows[row - 2].x[i];
    const double after = log.rows[row + 1].x[i] - log.rows[row].x[i];
    if (before * after < 0 && std::fabs(before - after) > 0.5 * (std::fabs(before) + std::fabs(after)) &&
        std::fabs(before) > 0.2 * std::fabs(after) && std::fabs(after) > 0.05 * std::fabs(before))
      return {Break::Kind::contact, row, "the velocity turns round within a frame: a contact"};
  }
  return result;
}

}  // namespace shortfall
