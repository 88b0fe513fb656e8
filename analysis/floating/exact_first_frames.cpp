// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_first_frames.hpp"

#include <algorithm>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLong = 10'000;  // digits from which on the next step is estimated

}  // namespace

std::vector<std::pair<Rational, Rational>> exact_first_frames(const Program& program,
                                                              const ExactFirstFrames& q, int frames,
                                                              const Progress& progress) {
  if (frames < 0) throw BadInput("a number of frames is whole and not negative");
  if (frames > q.most_frames)
    throw Unable(
        "under a force that is not linear the digits of an exact trajectory multiply in every step "
        "(three times for a cubic force): " +
        std::to_string(q.most_frames) + " frames are the limit, unless more are asked for");
  const Tape tape = lower(substepped(program, q.substeps), parameter_values(program, q.parameters));
  Numbers<Rational> problem{q.force};
  Run<Numbers<Rational>> run(tape, problem, q.h);
  run.begin(q.x0, q.v0, 0);
  std::vector<std::pair<Rational, Rational>> result{run.read_out()};
  std::size_t before = std::max({q.h.digits(), q.x0.digits(), q.v0.digits()});
  for (int n = 1; n <= frames; ++n) {
    if (progress) progress("stepping exactly", n, frames);
    std::size_t digits = 0;
    for (int i = 0; i < static_cast<int>(tape.states.size()); ++i)
      digits = std::max(digits, run.state(i).digits());
    // The next step multiplies them as the last one did.
    if (digits > kLong && digits * digits / before > q.most_digits)
      throw Unable("the exact trajectory has numbers of " + std::to_string(digits) + " digits at frame " +
                   std::to_string(n - 1) + ", and at frame " + std::to_string(n) + " more than " +
                   std::to_string(q.most_digits) + ", which is the limit");
    before = std::max(before, digits);
    run.step();
    result.push_back(run.read_out());
  }
  return result;
}

}  // namespace shortfall
