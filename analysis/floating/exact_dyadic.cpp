// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_dyadic.hpp"

#include <algorithm>

#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_plan.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kWhole = 2;  // limbs above the point to begin with: a number and its sign

/// The exponent, if the number is a power of two.
std::optional<std::int64_t> exponent_of_two(const mpz_class& value) {
  if (value <= 0 || mpz_popcount(value.get_mpz_t()) != 1) return std::nullopt;
  return static_cast<std::int64_t>(mpz_scan1(value.get_mpz_t(), 0));
}

/// No entry may grow by more than the limb that is a sign before a step has room for.
bool grows_slowly(const ExactStep& step) {
  return std::ranges::all_of(step.matrix, [&](const std::vector<mpz_class>& row) {
    mpz_class sum;
    for (const mpz_class& m : row) sum += abs(m);
    return sum < step.base << (GMP_NUMB_BITS - 2);
  });
}

}  // namespace

Ball powered(const Ball& base, std::int64_t exponent) {
  constexpr std::int64_t kPart = 1 << 30;
  return pow(pow(base, static_cast<int>(kPart)), static_cast<int>(exponent / kPart)) *
         pow(base, static_cast<int>(exponent % kPart));
}

bool ExactDyadic::add_term(Row& row, int source, bool fresh, const mpz_class& coefficient,
                           std::int64_t places) {
  const auto twos = static_cast<std::int64_t>(mpz_scan1(coefficient.get_mpz_t(), 0));
  const mpz_class odd = abs(coefficient) >> static_cast<mp_bitcnt_t>(twos);
  const std::int64_t right = places - twos;  // the coefficient is odd 2^-right
  const std::int64_t down = right > 0 ? (right + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS : 0;
  mpz_class word = odd << static_cast<mp_bitcnt_t>(down * GMP_NUMB_BITS - right);
  for (std::int64_t d = down; word != 0; --d) {
    if (d < 0) return false;
    const mp_limb_t limb = mpz_getlimbn(word.get_mpz_t(), 0);
    if (limb != 0) row.terms.push_back({source, fresh, coefficient < 0, limb, static_cast<std::size_t>(d)});
    word >>= GMP_NUMB_BITS;
  }
  return true;
}

std::optional<ExactDyadic> ExactDyadic::of(const ExactStep& step) {
  const auto places = exponent_of_two(step.base);
  if (!places || *places == 0 || !grows_slowly(step)) return std::nullopt;
  ExactDyadic result;
  result.places_ = *places;
  const std::vector<ExactPlan::Row> rows = ExactPlan::rows(step.matrix);
  result.in_place_ = ExactPlan::in_place(rows);
  for (const ExactPlan::Row& planned : rows) {
    Row row{planned.target, false, {}};
    bool has_own = false;
    for (const ExactPlan::Term& t : planned.terms) {
      const mpz_class coefficient = t.negative ? mpz_class(-t.magnitude) : t.magnitude;
      const bool own = !t.fresh && t.source == planned.target;
      has_own = has_own || own;
      if (own && coefficient == step.base) row.keeps = true;
      // A fresh entry has been divided by D already.
      else if (!result.add_term(row, t.source, t.fresh, coefficient, t.fresh ? 0 : *places))
        return std::nullopt;
    }
    if (has_own && !row.keeps) result.in_place_ = false;
    result.rows_.push_back(std::move(row));
  }
  if (!result.in_place_)
    for (Row& row : result.rows_)
      if (std::exchange(row.keeps, false)) row.terms.push_back({row.target});
  return result;
}

void ExactDyadic::load(const std::vector<mpz_class>& z, std::int64_t frame) {
  frame_ = frame;
  state_.clear();
  for (const mpz_class& value : z) state_.emplace_back(value, places_ * frame, kWhole);
  std::size_t whole = 0;
  for (const GrowingFixedPoint& s : state_) whole = std::max(whole, s.whole());
  for (GrowingFixedPoint& s : state_)
    while (s.whole() < whole) s.widen();
  next_ = in_place_ ? std::vector<GrowingFixedPoint>() : state_;
}

void ExactDyadic::step() {
  if (!std::ranges::all_of(state_, &GrowingFixedPoint::has_guard)) {
    for (GrowingFixedPoint& s : state_) s.widen();
    for (GrowingFixedPoint& s : next_) s.widen();
  }
  std::vector<GrowingFixedPoint>& made = in_place_ ? state_ : next_;
  for (const Row& row : rows_) {
    GrowingFixedPoint& entry = made[row.target];
    if (!row.keeps) entry.clear();
    for (const Term& t : row.terms)
      entry.add_product(t.fresh ? made[t.source] : state_[t.source], t.word, t.down, t.negative);
    entry.trim();
  }
  if (!in_place_) state_.swap(next_);
  ++frame_;
}

std::vector<mpz_class> ExactDyadic::values() const {
  std::vector<mpz_class> z;
  for (const GrowingFixedPoint& s : state_) {
    const std::int64_t shift = places_ * frame_ - static_cast<std::int64_t>(s.fraction()) * GMP_NUMB_BITS;
    mpz_class n = s.numerator();
    // What is dropped on the right is zero: z is whole.
    z.push_back(shift >= 0 ? mpz_class(n << static_cast<mp_bitcnt_t>(shift))
                           : mpz_class(n >> static_cast<mp_bitcnt_t>(-shift)));
  }
  return z;
}

Ball ExactDyadic::scaled(int entry, int bits) const {
  const GrowingFixedPoint& s = state_[entry];
  std::size_t dropped = 0;
  const mpz_class head = s.leading(static_cast<std::size_t>(bits) / GMP_NUMB_BITS + 3, dropped);
  Ball value(rational(head), bits + 3 * GMP_NUMB_BITS);
  if (dropped > 0) value = hull(value, Ball(rational(mpz_class(head + 1)), bits + 3 * GMP_NUMB_BITS));
  const std::int64_t up =
      (static_cast<std::int64_t>(dropped) - static_cast<std::int64_t>(s.fraction())) * GMP_NUMB_BITS;
  const Ball two(2, bits);
  return up >= 0 ? value * powered(two, up) : value / powered(two, -up);
}

std::size_t ExactDyadic::limbs() const {
  std::size_t most = 0;
  for (const GrowingFixedPoint& s : state_) most = std::max(most, s.size());
  return most;
}

}  // namespace shortfall
