// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_state.hpp"

#include <algorithm>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_jump.hpp"

namespace shortfall {

namespace {

constexpr int kMostAtOnce = 64;         // steps by one power of the matrix
constexpr std::size_t kSpareLimbs = 8;  // that a step may need more

std::int64_t size_in_bits(const mpz_class& z) {
  return static_cast<std::int64_t>(mpz_sizeinbase(z.get_mpz_t(), 2));
}

bool fit_words(const std::vector<std::vector<mpz_class>>& matrix) {
  return std::ranges::all_of(matrix, [](const auto& row) {
    return std::ranges::all_of(row, [](const mpz_class& m) { return mpz_fits_slong_p(m.get_mpz_t()) != 0; });
  });
}

Int128 wide(const mpz_class& value) {
  const mpz_class size = abs(value), high = size >> 64, low = size - (high << 64);
  const Int128 w = static_cast<Int128>(static_cast<UInt128>(high.get_ui()) << 64 | low.get_ui());
  return value < 0 ? -w : w;
}

}  // namespace

ExactState::ExactState(const ExactStep& step)
    : step_(step), z_(step.start), next_(step.size()), dyadic_(ExactDyadic::of(step)) {
  enter_words();
}

void ExactState::enter_words() {
  seen_ = frame_;
  if (!fit_words(step_.matrix)) return;
  if (std::ranges::any_of(z_, [](const mpz_class& z) { return size_in_bits(z) > 126; })) return;
  std::vector<std::int64_t> matrix;
  for (const auto& row : step_.matrix)
    for (const mpz_class& m : row) matrix.push_back(m.get_si());
  std::vector<Int128> state;
  for (const mpz_class& z : z_) state.push_back(wide(z));
  words_.emplace(std::move(matrix), std::move(state));
}

void ExactState::leave_words() {
  values();
  words_.reset();
}

void ExactState::advance(std::int64_t steps) {
  if (steps < 0) throw BadInput("an exact trajectory goes forwards only");
  if (words_) {
    const std::int64_t done = words_->advance(steps);
    frame_ += done;
    if (done == steps) return;
    steps -= done;
    leave_words();
  }
  while (steps > 0) {
    // Powers are made when they are first needed: who looks at every frame needs none.
    if (pending_ == static_cast<std::int64_t>(powers_.size()) && !add_power())
      apply(std::exchange(pending_, 0));
    const auto now = std::min(steps, static_cast<std::int64_t>(powers_.size()) - pending_);
    pending_ += now;
    frame_ += now;
    steps -= now;
  }
}

bool ExactState::add_power() {
  if (all_powers_) return false;
  if (powers_.empty()) {
    powers_.push_back(step_.matrix);
  } else {
    auto power = product(step_.matrix, powers_.back());
    all_powers_ = static_cast<int>(powers_.size()) >= kMostAtOnce || !fit_words(power);
    if (all_powers_) return false;
    powers_.push_back(std::move(power));
  }
  ways_.emplace_back();
  return true;
}

void ExactState::apply(std::int64_t steps) {
  if (steps == 1 && dyadic_)
    step_dyadic();
  else
    apply_power(steps);
}

void ExactState::step_dyadic() {
  // frame_ counts the step already.
  if (!std::exchange(in_dyadic_, true)) dyadic_->load(z_, frame_ - 1);
  check_length(dyadic_->limbs());
  dyadic_->step();
}

void ExactState::apply_power(std::int64_t steps) {
  if (std::exchange(in_dyadic_, false) && copied_ != frame_ - steps) {
    z_ = dyadic_->values();
    room_ = 0;
  }
  make_room();
  auto& way = ways_[steps - 1];
  if (std::holds_alternative<std::monostate>(way)) {
    const auto& matrix = powers_[steps - 1];
    if (ExactPair::fits(matrix) && ExactPlan::cost(matrix) > ExactPair::kCost)
      way.emplace<ExactPair>(matrix);
    else
      way.emplace<ExactPlan>(matrix);
  }
  if (const auto* pair = std::get_if<ExactPair>(&way))
    pair->apply(z_);
  else
    std::get<ExactPlan>(way).apply(z_, next_);
}

void ExactState::make_room() {
  std::size_t limbs = 0;
  for (const mpz_class& z : z_) limbs = std::max(limbs, mpz_size(z.get_mpz_t()));
  if (limbs + kSpareLimbs <= room_) return;
  check_length(limbs);
  // For many steps: GMP would make it anew at each.
  room_ = limbs + limbs / 2 + 2 * kSpareLimbs;
  for (auto* vector : {&z_, &next_})
    for (mpz_class& z : *vector) mpz_realloc2(z.get_mpz_t(), static_cast<mp_bitcnt_t>(room_) * GMP_NUMB_BITS);
}

void ExactState::check_length(std::size_t limbs) const {
  if (limbs > kLongestExactNumber / GMP_NUMB_BITS)
    throw Unable("the exact trajectory at frame " + std::to_string(frame_) + " has numbers of more than " +
                 std::to_string(kLongestExactNumber) +
                 " binary digits; numbers after n steps with certain digits need no such memory");
}

void ExactState::settle() {
  if (pending_ > 0) apply(std::exchange(pending_, 0));
}

const std::vector<mpz_class>& ExactState::values() {
  if (words_) {
    if (seen_ != frame_)
      for (std::size_t i = 0; i < z_.size(); ++i) z_[i] = gmp_integer(words_->state()[i]);
    seen_ = frame_;
    return z_;
  }
  settle();
  if (in_dyadic_ && std::exchange(copied_, frame_) != frame_) {
    z_ = dyadic_->values();
    room_ = 0;
  }
  return z_;
}

int ExactState::sign(int entry) {
  if (words_) return sgn(values()[entry]);
  settle();
  return in_dyadic_ ? dyadic_->sign(entry) : sgn(z_[entry]);
}

std::optional<Ball> ExactState::scaled(int entry, int bits) {
  if (words_) return std::nullopt;
  settle();
  if (!in_dyadic_) return std::nullopt;
  return dyadic_->scaled(entry, bits);
}

void ExactState::jump(std::int64_t steps) {
  if (steps < 0) throw BadInput("an exact trajectory goes forwards only");
  z_ = jumped(step_, values(), steps);
  frame_ += steps;
  words_.reset();
  room_ = 0;
  in_dyadic_ = false;
  enter_words();
}

}  // namespace shortfall
