// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/frame_flight.hpp"

#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

std::vector<Rational> checked(std::vector<Rational> steps) {
  if (steps.empty()) throw BadInput("a list of frames has at least one step");
  for (const Rational& h : steps)
    if (h.sign() <= 0) throw BadInput("a frame takes longer than 0 s, not " + h.str() + " s");
  return steps;
}

}  // namespace

FrameFlight::FrameFlight(const Program& program, std::vector<Rational> steps, bool repeat, int substeps,
                         const Values& given)
    : program_(substepped(program, substeps)),
      tape_(lower(program_, parameter_values(program_, given))),
      steps_(checked(std::move(steps))),
      repeat_(repeat),
      weightless_(constant_force(0)),
      heavy_(constant_force(1)),
      free_(tape_, weightless_, steps_.front()),
      dropped_(tape_, heavy_, steps_.front()) {
  free_.begin(0, 1, 0);
  dropped_.begin(0, 0, 0);
  record(0, 0);
}

const FlownFrame& FrameFlight::frame(std::size_t n) {
  if (n > kMost || !has(n))
    throw Unable("we step at most " + std::to_string(kMost) + " frames of a list exactly, not " +
                 std::to_string(n));
  while (frames_.size() <= n) {
    const Rational h = steps_[(frames_.size() - 1) % steps_.size()];
    for (Run<UndisturbedNumbers>* run : {&free_, &dropped_}) {
      run->set_step(h);
      run->step();
    }
    record(frames_.back().t + h, h);
  }
  return frames_[n];
}

void FrameFlight::record(const Rational& t, const Rational& h) {
  auto [rise, rise_velocity] = free_.read_out();
  auto [fall, fall_velocity] = dropped_.read_out();
  frames_.push_back(
      {t, h, std::move(rise), std::move(fall), std::move(rise_velocity), std::move(fall_velocity)});
}

}  // namespace shortfall
