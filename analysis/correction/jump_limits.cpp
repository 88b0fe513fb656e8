// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_limits.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

std::optional<LimitMet> limit_met(const Flight& flight, const Surd& launch, const Rational& g,
                                  const Rational& top) {
  const Tape tape = lower(flight.program(), flight.parameters());
  if (tape.limits.empty() && tape.whens.empty()) return std::nullopt;
  std::int64_t last = 0;
  if (!top.fits_int64(last) || last > kLimitFrames)
    throw Unable("whether a limit of " + flight.program().name + " acts before frame " + top.str() +
                 " is not known: we step at most " + std::to_string(kLimitFrames) + " frames");
  const double down = -g.to_double(), up = launch.to_double();
  double push = 0;
  Numbers<double> problem{.force = [&](double, double, double) { return down + push; }};
  Run<Numbers<double>> run(tape, problem, flight.dt().to_double());
  run.begin(0, flight.launch_by() == LaunchBy::velocity ? up : 0, 0);
  if (flight.launch_by() == LaunchBy::impulse) run.give_impulse(up);
  if (flight.launch_by() == LaunchBy::force) push = up / (flight.force_frames() * flight.dt().to_double());
  LimitMet met;
  for (std::int64_t n = 1; n <= kLimitFrames; ++n) {
    run.step();
    if (n >= flight.force_frames()) push = 0;
    const double here = run.read_out().first;
    if (here > met.best_height) {
      met.best_height = here;
      met.best_frame = n;
    } else if (n >= last) {
      break;  // a limit only holds back, so that the top is not much later
    }
  }
  if (!run.deviation() || run.deviation()->step > std::max(last, met.best_frame)) return std::nullopt;
  met.frame = run.deviation()->step;
  met.text = run.deviation()->text;
  return met;
}

}  // namespace shortfall
