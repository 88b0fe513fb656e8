// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/accumulator.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kMostRuns = 20'000;
constexpr std::size_t kEnoughRuns = 6'000;  // beyond the additions asked for: a binary64 clock's whole life

mpz_class shifted(const mpz_class& value, long by) {
  return by >= 0 ? mpz_class(value << static_cast<mp_bitcnt_t>(by))
                 : mpz_class(value >> static_cast<mp_bitcnt_t>(-by));
}

/// All values of one accumulator are multiples of 2^grain_; this counts in that.
class Walk {
 public:
  explicit Walk(const Accumulator& clock) : format_(clock.format), rounding_(clock.rounding) {
    const long of_increment = *lowest_bit(clock.increment);
    grain_ = std::min(of_increment, lowest_bit(clock.start).value_or(of_increment));
    grain_ = std::min(grain_, format_.greatest_bit + 1 - format_.precision);  // the largest number counts too
    value_ = counted(clock.start);
    step_ = counted(clock.increment);
    least_ = std::max(0L, format_.least_unit - grain_);
  }

  /// One run more; false at the end, which `overflowed` then tells.
  bool advance(AccumulatorRun& run);
  bool overflowed() const { return overflowed_; }
  const mpz_class& additions() const { return additions_; }

 private:
  mpz_class counted(const Rational& value) const {
    return shifted(gmp_numerator(value), -grain_ - (bit_length(gmp_denominator(value)) - 1));
  }
  Rational uncounted(const mpz_class& count) const {
    return grain_ >= 0 ? rational(shifted(count, grain_)) : rational(count, shifted(1, -grain_));
  }
  /// The spacing of the format's numbers around a sum, as a power of two; 0 where all counts are exact.
  long spacing(const mpz_class& sum) const { return std::max(bit_length(sum) - format_.precision, least_); }
  mpz_class rounded(const mpz_class& sum, long k) const;
  bool too_large(const mpz_class& value) const {
    return bit_length(value) + grain_ > format_.greatest_bit + 1;
  }
  mpz_class largest() const {
    return shifted(shifted(1, format_.precision) - 1, format_.greatest_bit + 1 - format_.precision - grain_);
  }
  /// How many further sums, each `gain` beyond the last, stay where the spacing is that of `sum`.
  mpz_class further(const mpz_class& sum, const mpz_class& gain, long k) const;

  BinaryFormat format_;
  Rounding rounding_;
  long grain_ = 0;
  long least_ = 0;  ///< spacing of the subnormals, counted
  mpz_class value_, step_, additions_;
  bool overflowed_ = false;
};

mpz_class Walk::rounded(const mpz_class& sum, long k) const {
  if (k == 0) return sum;
  const auto shift = static_cast<mp_bitcnt_t>(k);
  mpz_class low, rest;
  mpz_fdiv_q_2exp(low.get_mpz_t(), sum.get_mpz_t(), shift);
  mpz_fdiv_r_2exp(rest.get_mpz_t(), sum.get_mpz_t(), shift);
  const bool negative = sgn(sum) < 0;
  bool up = false;
  switch (rounding_) {
    case Rounding::toward_zero:
      up = negative && rest != 0;
      break;
    case Rounding::up:
      up = rest != 0;
      break;
    case Rounding::down:
      break;
    case Rounding::nearest_even:
    case Rounding::nearest_away: {
      const int against_half = cmp(rest, shifted(1, k - 1));
      const bool on_tie = rounding_ == Rounding::nearest_away ? !negative : mpz_odd_p(low.get_mpz_t()) != 0;
      up = against_half > 0 || (against_half == 0 && on_tie);
      break;
    }
  }
  if (up) ++low;
  return low << shift;
}

mpz_class Walk::further(const mpz_class& sum, const mpz_class& gain, long k) const {
  // The sums that share the spacing 2^k, by size; with their sign where rounding depends on it.
  const bool last = k + format_.precision + grain_ > format_.greatest_bit;  // infinity begins behind them
  mpz_class most = shifted(1, k + format_.precision) - 1;
  if (last && k == 0) most = std::min(most, largest());
  const mpz_class least =
      k == least_ ? mpz_class(k == 0 ? -most : mpz_class(0)) : shifted(1, k + format_.precision - 1);
  const bool outwards = (sgn(sum) < 0) == (sgn(gain) < 0);
  const mpz_class size = abs(sum);
  const mpz_class room = outwards ? mpz_class(most - size) : mpz_class(size - least);
  mpz_class count = room / abs(gain);
  if (!last || !outwards || k == 0) return count;
  // A sum below 2^(greatest_bit + 1) may be rounded up to it: stop at the largest number.
  const mpz_class finite = (largest() - abs(sum - step_ + gain)) / abs(gain);
  return std::min(count, finite);
}

bool Walk::advance(AccumulatorRun& run) {
  const mpz_class sum = value_ + step_;
  const long k = spacing(sum);
  mpz_class next = rounded(sum, k);
  if (too_large(next)) {
    const bool negative = sgn(next) < 0;
    const bool stays = rounding_ == Rounding::toward_zero || (rounding_ == Rounding::up && negative) ||
                       (rounding_ == Rounding::down && !negative);
    if (!stays) {
      overflowed_ = true;
      return false;
    }
    next = negative ? mpz_class(-largest()) : largest();
  }
  const mpz_class gain = next - value_;
  if (gain == 0) return false;
  mpz_class count = 1;
  const auto shift = static_cast<mp_bitcnt_t>(k);
  const bool on_grid = mpz_divisible_2exp_p(value_.get_mpz_t(), shift) != 0;
  // Only after a sum that was halfway is the value sure to be an even multiple of the spacing.
  const bool settled =
      k == 0 || rounding_ != Rounding::nearest_even || mpz_divisible_2exp_p(value_.get_mpz_t(), shift + 1) ||
      mpz_divisible_2exp_p(step_.get_mpz_t(), shift) || !mpz_divisible_2exp_p(step_.get_mpz_t(), shift - 1);
  const bool inside = rounded(sum, k) == next;  // not cut off at the largest number
  if (on_grid && settled && inside) count += further(sum, gain, k);
  run = {rational(additions_), rational(count), uncounted(value_),
         uncounted(gain),      k + grain_,      gain == step_};
  value_ += count * gain;
  additions_ += count;
  return true;
}

}  // namespace

Rational AccumulatorPath::additions() const {
  return runs.empty() ? Rational() : runs.back().before + runs.back().additions;
}

Rational AccumulatorPath::last() const { return runs.empty() ? clock.start : runs.back().to(); }

std::optional<Rational> AccumulatorPath::after(const Rational& n) const {
  if (n.is_zero()) return clock.start;
  const auto beyond = std::ranges::lower_bound(
      runs, n, {}, [](const AccumulatorRun& r) -> const Rational& { return r.before; });
  if (beyond != runs.begin()) {
    const AccumulatorRun& run = *std::prev(beyond);
    const Rational inside = n - run.before;
    if (inside <= run.additions) return run.from + inside * run.increment;
  }
  switch (end) {
    case End::frozen:
      return last();
    case End::overflowed:
      return std::nullopt;
    case End::not_reached:
      break;
  }
  throw Unable("the accumulator was followed for " + additions().str() + " additions only");
}

Rational AccumulatorPath::exact_additions() const {
  for (const AccumulatorRun& r : runs)
    if (!r.exact) return r.before;
  return additions();
}

AccumulatorPath accumulator_path(const Accumulator& clock, const Rational& least) {
  if (clock.increment.is_zero()) throw BadInput("a clock with dt = 0 stands still");
  if (rounded(clock.start, clock.format, clock.rounding) != clock.start)
    throw BadInput(clock.start.significant(8) + " is no number of the format");
  AccumulatorPath result{clock, {}, AccumulatorPath::End::not_reached};
  Walk walk(clock);
  const mpz_class wanted = gmp_numerator(least);
  while (walk.additions() < wanted || result.runs.size() < kEnoughRuns) {
    if (result.runs.size() >= kMostRuns)
      throw Unable("the format is so coarse that " + least.str() + " additions pass more than " +
                   std::to_string(kMostRuns) + " powers of two; after " + rational(walk.additions()).str() +
                   " additions the value is " + result.last().significant(6));
    AccumulatorRun run;
    if (!walk.advance(run)) {
      result.end = walk.overflowed() ? AccumulatorPath::End::overflowed : AccumulatorPath::End::frozen;
      break;
    }
    result.runs.push_back(std::move(run));
  }
  return result;
}

Accumulation part_of(const AccumulatorPath& path, const Rational& additions) {
  if (!additions.is_integer() || additions.sign() < 0)
    throw BadInput("a number of additions is a whole number, 0 or more");
  Accumulation result;
  result.additions = additions;
  result.value = path.after(additions);
  if (const Rational exact = path.exact_additions(); exact < additions) result.exact_additions = exact;
  if (const auto freeze = freeze_of(path); freeze && freeze->additions < additions) result.freezes = freeze;
  for (const AccumulatorRun& r : path.runs) {
    if (r.before >= additions) break;
    const Rational inside = std::min(r.additions, additions - r.before);
    if (!result.stretches.empty() && result.stretches.back().added == r.increment)
      result.stretches.back().additions += inside;
    else
      result.stretches.push_back({r.from, r.increment, inside});
  }
  return result;
}

Accumulation accumulated(const Accumulator& clock, const Rational& additions) {
  return part_of(accumulator_path(clock, additions), additions);
}

std::optional<Accumulation::Freeze> freeze_of(const AccumulatorPath& path) {
  if (path.end != AccumulatorPath::End::frozen) return std::nullopt;
  return Accumulation::Freeze{path.last(), path.additions()};
}

std::optional<Accumulation::Freeze> freezing_point(const Accumulator& clock) {
  return freeze_of(accumulator_path(clock, 0));
}

}  // namespace shortfall
