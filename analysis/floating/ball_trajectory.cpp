// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/ball_trajectory.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/number_field.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/motion/step_matrix.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kLeastPlan = 512;  ///< frames
constexpr int kRoom = 128;                ///< bits besides

Ball dot(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  Ball sum(0, a.front().bits());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!a[i].is_zero() && !b[i].is_zero()) sum.add_product(a[i], b[i]);
  return sum;
}

}  // namespace

BallTrajectory::BallTrajectory(const Program& program, const NumericQuestion& question)
    : program_(program), question_(question) {
  restart(0, 2);
}

void BallTrajectory::restart(std::int64_t frame, int bits) {
  bits_ = std::max(bits, bits_);
  planned_ = std::max(kLeastPlan, 2 * frame);
  const int working = bits_ + kRoom + static_cast<int>(planned_ / 2);
  const NumberField field;
  const Values values = parameter_values(program_, question_.parameters);
  ExtraLetters extras(letter_names(lower(program_, values)));
  NumericQuestion q = question_;
  q.force = with_own_equation(question_.force, program_, values, extras);
  const StepMatrix matrix = step_matrix(program_, q);
  const std::vector<Ball> letters = letter_balls(matrix.map.extras, working);
  const auto converted = [&](const std::vector<Fraction>& row) {
    std::vector<Ball> result;
    for (const Fraction& f : row) result.push_back(ball_value(f, letters, working));
    return result;
  };
  step_.clear();
  for (const auto& row : matrix.step) step_.push_back(converted(row));
  state_ = converted(matrix.start);
  report_ = converted(matrix.position);
  frame_ = 0;
}

Ball BallTrajectory::position(std::int64_t frame, int bits) {
  if (bits > bits_ || frame > planned_) restart(frame, bits);
  std::vector<Ball> next(state_.size());
  for (; frame_ < frame; ++frame_) {
    for (std::size_t i = 0; i < step_.size(); ++i) next[i] = dot(step_[i], state_);
    std::swap(state_, next);
  }
  return dot(report_, state_);
}

}  // namespace shortfall
