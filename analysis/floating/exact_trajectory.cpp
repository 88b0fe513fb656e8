// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_trajectory.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_parts.hpp"
#include "analysis/floating/exact_question.hpp"

namespace shortfall {

namespace {

constexpr int kReports = 200;           // calls of `progress` in all
constexpr std::int64_t kNearby = 4096;  // frames over which a power of D is carried on

}  // namespace

const mpz_class& ExactTrajectory::Parts::numerator(bool velocity, mpz_class& room) {
  const std::vector<mpz_class>& z = state.values();
  const ExactStep::Report& r = report(velocity);
  if (r.unit >= 0) return z[r.unit];
  room = 0;
  for (std::size_t j = 0; j < z.size(); ++j)
    if (r.row[j] != 0) mpz_addmul(room.get_mpz_t(), r.row[j].get_mpz_t(), z[j].get_mpz_t());
  return room;
}

mpz_class ExactTrajectory::Parts::denominator(bool velocity) {
  if (step.base != 1 && power_of_ != state.frame()) {
    const auto digits = static_cast<std::int64_t>(mpz_sizeinbase(step.base.get_mpz_t(), 2));
    if (state.frame() > kLongestExactNumber / digits)
      throw Unable("the denominator at frame " + std::to_string(state.frame()) + " has more than " +
                   std::to_string(kLongestExactNumber) + " binary digits");
    const bool near = power_of_ < state.frame() && state.frame() - power_of_ <= kNearby;
    mpz_class rest;
    mpz_pow_ui(rest.get_mpz_t(), step.base.get_mpz_t(),
               static_cast<unsigned long>(near ? state.frame() - power_of_ : state.frame()));
    power_ = near ? power_ * rest : rest;
    power_of_ = state.frame();
  }
  return report(velocity).denominator * step.start_denominator * power_;
}

ExactTrajectory::ExactTrajectory(const Program& program, const NumericQuestion& asked) {
  parts_ = std::make_unique<Parts>(exact_matrix(program, asked), asked.h);
}
ExactTrajectory::ExactTrajectory(ExactTrajectory&&) noexcept = default;
ExactTrajectory& ExactTrajectory::operator=(ExactTrajectory&&) noexcept = default;
ExactTrajectory::~ExactTrajectory() = default;

std::int64_t ExactTrajectory::frame() const { return parts_->state.frame(); }
Rational ExactTrajectory::time() const { return Rational(frame()) * parts_->h; }
void ExactTrajectory::advance(std::int64_t steps) { parts_->state.advance(steps); }
void ExactTrajectory::jump(std::int64_t steps) { parts_->state.jump(steps); }
Rational ExactTrajectory::denominator_of_a_step() const { return shortfall::rational(parts_->step.base); }
bool ExactTrajectory::in_words() const { return parts_->state.in_words(); }
const std::vector<std::string>& ExactTrajectory::assumed() const { return parts_->assumed; }

std::int64_t exact_trajectory(const Program& program, const NumericQuestion& question, std::int64_t frames,
                              const std::function<bool(const ExactTrajectory&)>& visit,
                              const Progress& progress) {
  if (frames < 0) throw BadInput("a number of frames is whole and not negative");
  ExactTrajectory trajectory(program, question);
  const std::int64_t report = std::max<std::int64_t>(frames / kReports, 1);
  for (;;) {
    const std::int64_t n = trajectory.frame();
    if (progress && n % report == 0)
      progress("stepping exactly", static_cast<int>(n / report), static_cast<int>(frames / report));
    if (!visit(trajectory) || n == frames) return n;
    trajectory.advance();
  }
}

}  // namespace shortfall
