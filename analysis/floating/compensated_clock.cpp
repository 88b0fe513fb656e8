// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/compensated_clock.hpp"

#include <algorithm>
#include <bit>

#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/wide.hpp"

namespace shortfall {

namespace {

/// The spacing of the numbers of a format around a dyadic value.
Rational spacing(const Rational& value, const BinaryFormat& format) {
  if (value.is_zero()) return power_of_two(format.least_unit);
  return power_of_two(std::max(leading_bit(value.abs()) - (format.precision - 1), format.least_unit));
}

bool to_nearest(Rounding rounding) {
  return rounding == Rounding::nearest_even || rounding == Rounding::nearest_away;
}

using shortfall::bit_length;  // of GMP's integers

int bit_length(Int128 value) {
  const auto size = static_cast<UInt128>(value < 0 ? -value : value);
  const auto high = static_cast<std::uint64_t>(size >> 64);
  return static_cast<int>(high ? 64 + std::bit_width(high)
                               : std::bit_width(static_cast<std::uint64_t>(size)));
}

/// A whole number rounded to so many bits.
Int128 rounded(Int128 value, int precision, Rounding rounding) {
  const int k = bit_length(value) - precision;
  if (k <= 0) return value;
  const Int128 one = static_cast<Int128>(1) << k;
  const Int128 rest = value & (one - 1);  // of the floor, for negative values too
  const Int128 low = value - rest;
  const Int128 half = one >> 1;
  bool up = false;
  switch (rounding) {
    case Rounding::toward_zero:
      up = value < 0 && rest != 0;
      break;
    case Rounding::up:
      up = rest != 0;
      break;
    case Rounding::down:
      break;
    case Rounding::nearest_even:
      up = rest > half || (rest == half && (low & one) != 0);
      break;
    case Rounding::nearest_away:
      up = rest > half || (rest == half && value > 0);
      break;
  }
  return up ? low + one : low;
}

Int128 to_int128(const mpz_class& value) {
  const mpz_class size = abs(value);
  const mpz_class high = size >> 64, low = size & mpz_class("18446744073709551615");
  const auto whole = static_cast<Int128>((static_cast<UInt128>(high.get_ui()) << 64) | low.get_ui());
  return sgn(value) < 0 ? -whole : whole;
}

struct Question {
  Rational start, increment, n;
  BinaryFormat format;
  Rounding rounding;
  long grain;  ///< all numbers are multiples of 2^grain
  Rational exact() const { return start + n * increment; }
  Rational greatest() const { return std::max(start.abs(), exact().abs()); }
};

/// For how many additions y is sure to be exact.
Rational closed_additions(const Question& q) {
  if (!to_nearest(q.rounding) || q.grain < q.format.least_unit) return 0;
  const Rational room = power_of_two(q.grain + q.format.precision) - q.increment.abs();
  if (room.sign() <= 0) return 0;
  // The largest spacing u with u/2 <= room, and the sums below where the next one begins.
  const long widest = q.grain + bit_length(gmp_numerator(room / power_of_two(q.grain)));
  const long unit = std::min(widest, q.format.greatest_bit - q.format.precision + 1);
  const Rational below = power_of_two(unit + q.format.precision);
  if (q.start.abs() >= below) return 0;
  const Rational outwards =
      (q.start.sign() < 0) == (q.increment.sign() < 0) ? below - q.start.abs() : below + q.start.abs();
  const Rational most = outwards / q.increment.abs();
  const Rational whole = most.floor();
  return whole == most ? whole - Rational(1) : whole;  // the sum stays below
}

/// |start + n increment - s|, to nearest: half a spacing for c and half a spacing of y in each step.
std::optional<Rational> bound(const Question& q) {
  // Fast2Sum needs |s| >= |y|: from 0, or far enough from it and moving away.
  const bool moves_away = q.start.is_zero() || ((q.start.sign() < 0) == (q.increment.sign() < 0) &&
                                                q.start.abs() >= q.increment.abs() * Rational(2));
  if (!to_nearest(q.rounding) || !moves_away || q.format.precision < 3) return std::nullopt;
  const Rational greatest = q.greatest();
  if (leading_bit(greatest) + 1 > q.format.greatest_bit) return std::nullopt;  // sums up to twice as large
  const Rational half(1, 2);
  const Rational u = spacing(greatest * Rational(2), q.format);
  const Rational of_y = spacing(q.increment.abs() + u, q.format);
  Rational result = half * u + q.n * half * of_y;
  if (result > greatest) return std::nullopt;  // then sums might be more than twice as large
  return result;
}

/// All additions, one by one; false where the numbers do not fit into 128 bits.
bool step_through(const Question& q, CompensatedClock& clock, const Progress& progress) {
  const Rational grain = power_of_two(q.grain);
  const long width = leading_bit(q.greatest()) - q.grain + 1;
  const long of_increment = leading_bit(q.increment.abs()) - q.grain + 1;
  if (q.grain < q.format.least_unit || std::max(width, of_increment) > 118) return false;
  std::int64_t n = 0;
  if (!q.n.fits_int64(n)) return false;
  const int p = q.format.precision;
  const long top = q.format.greatest_bit + 1 - q.grain;  // finite numbers have so many bits
  const Rounding r = q.rounding;
  const Int128 d = to_int128(gmp_numerator(q.increment / grain));
  Int128 s = to_int128(gmp_numerator(q.start / grain)), c = 0;
  constexpr std::int64_t kReport = 1 << 22;
  for (std::int64_t i = 0; i < n; ++i) {
    const Int128 y = rounded(d - c, p, r);
    const Int128 t = rounded(s + y, p, r);
    if (bit_length(t) > top || bit_length(y) > top) {
      if (!to_nearest(r)) return false;  // it may stay at the largest number
      clock.value.reset();
      return true;
    }
    if (bit_length(t) > 122) return false;
    const Int128 lost = rounded(rounded(t - s, p, r) - y, p, r);
    if (t == s && lost == c) {
      clock.frozen_after = i;
      break;
    }
    s = t;
    c = lost;
    if (progress && i % kReport == 0)
      progress("compensated additions, in millions", static_cast<int>(i / 1'000'000),
               static_cast<int>(n / 1'000'000));
  }
  clock.value = rational(gmp_integer(s)) * grain;
  return true;
}

/// The same for numbers of any size, far more slowly.
bool step_through_wide(const Question& q, CompensatedClock& clock) {
  const Rational most(100'000);
  if (q.n > most) return false;
  const auto stored = [&](const Rational& value) { return rounded(value, q.format, q.rounding); };
  Rational s = q.start, c = 0;
  for (Rational i = 0; i < q.n; i += 1) {
    const auto y = stored(q.increment - c);
    const auto t = y ? stored(s + *y) : std::nullopt;
    if (!t) {
      clock.value.reset();
      return to_nearest(q.rounding);  // otherwise it may stay at the largest number
    }
    const auto moved = stored(*t - s);
    const auto lost = moved ? stored(*moved - *y) : std::nullopt;
    if (!lost) return false;
    if (*t == s && *lost == c) {
      clock.frozen_after = i;
      break;
    }
    s = *t;
    c = *lost;
  }
  clock.value = s;
  return true;
}

}  // namespace

CompensatedClock compensated_clock(const Rational& start, const Rational& increment,
                                   const BinaryFormat& format, Rounding rounding, const Rational& n,
                                   const Rational& most_stepped, const Progress& progress) {
  using Kind = CompensatedClock::Kind;
  CompensatedClock clock;
  if (increment.is_zero() || n.is_zero()) {
    clock.kind = Kind::closed_form;
    clock.value = start;
    clock.closed_until = n;
    return clock;
  }
  const long grain = std::min(*lowest_bit(increment), lowest_bit(start).value_or(*lowest_bit(increment)));
  const Question q{start, increment, n, format, rounding, grain};
  clock.closed_until = closed_additions(q);
  if (n <= clock.closed_until) {
    clock.kind = Kind::closed_form;
    clock.value = rounded(q.exact(), format, rounding);
    if (clock.value) return clock;
  }
  clock.value.reset();
  if (n <= most_stepped && (step_through(q, clock, progress) || step_through_wide(q, clock))) {
    clock.kind = Kind::stepped;
    return clock;
  }
  clock.value.reset();
  clock.bound = bound(q);
  clock.kind = clock.bound ? Kind::bounded : Kind::unknown;
  return clock;
}

}  // namespace shortfall
