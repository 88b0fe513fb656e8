// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/clock.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

Rational stored(const Rational& value, const ClockArithmetic& a, const char* what) {
  const auto result = rounded(value, a.format, a.rounding);
  if (!result)
    throw BadInput(std::string(what) + " is too large for the format " + a.format_name +
                   ", whose largest number is " + a.format.largest().significant(6));
  return *result;
}

void check(const ClockQuestion& q) {
  if (q.dt.is_zero()) throw BadInput("dt is 0: such a clock stands still");
  if (q.velocity && q.velocity->is_zero()) throw BadInput("the velocity is 0: such a body stays where it is");
  if (q.additions.sign() < 0 || !q.additions.is_integer())
    throw BadInput("a number of steps is a whole number, 0 or more, not " + q.additions.significant(6));
  if (q.compensated && q.fixed_point)
    throw BadInput("fixed-point sums are not rounded: there is nothing that Kahan's sum could compensate");
  if (q.compensated && q.fused)
    throw BadInput("Kahan's sum adds a stored increment: it has no fused product");
}

/// Runs that share a spacing, put together.
std::vector<ClockSpeed> speeds(const AccumulatorPath& a, const Rational& advance) {
  std::vector<ClockSpeed> result;
  Rational most;  // additions of the longest run of the last row
  for (const AccumulatorRun& r : a.runs) {
    const bool same =
        !result.empty() && result.back().exact == r.exact &&
        (r.exact || (result.back().unit == r.unit && (result.back().to.sign() < 0) == (r.to().sign() < 0)));
    if (!same) {
      result.push_back({r.before, 0, r.from, r.from, r.unit, r.exact, 0, 0, 0});
      most = 0;
    }
    ClockSpeed& row = result.back();
    row.additions += r.additions;
    row.to = r.to();
    // The last of equally long ones: what is constant comes after what is not.
    if (r.additions >= most) {
      most = r.additions;
      row.increment = r.increment;
      row.entering = row.additions - most;
      row.rate = row.increment / advance;
    }
  }
  return result;
}

/// What a clock reads that counts steps and makes a time of them only when it is read.
std::optional<Rational> read_out(const ClockQuestion& q, const Rational& start, const Rational& factor,
                                 bool divide) {
  const BinaryFormat& f = q.format;
  const Rounding r = q.rounding;
  const auto count = rounded(q.additions, f, r);
  if (!count) return std::nullopt;
  const auto moved = rounded(divide ? *count / factor : *count * factor, f, r);
  if (!moved) return std::nullopt;
  return rounded(start + *moved, f, r);
}

void set_value(ClockAlternative& a, std::optional<Rational> value, const Rational& exact) {
  if (value) a.shortfall = exact - *value;
  a.value = std::move(value);
}

/// The power of two nearest to a positive number, by ratio rounded down to a factor 3/2.
Rational nearest_power_of_two(const Rational& value) {
  Rational power(1);
  while (power > value) power /= Rational(2);
  while (power * Rational(2) <= value) power *= Rational(2);
  return value - power <= power * Rational(2) - value ? power : power * Rational(2);
}

/// The same additions in a wider format, which is given dt as it is meant.
std::optional<ClockAlternative> wider(const ClockQuestion& q) {
  ClockArithmetic wide = clock_arithmetic(q.format.precision < 53 ? "f64" : "f128");
  wide.rounding = q.rounding;
  const auto stored = [&](const Rational& value) { return rounded(value, wide.format, wide.rounding); };
  const auto dt = stored(q.dt), v = stored(q.velocity.value_or(1)), start = stored(q.start);
  if (!dt || !v || !start) return std::nullopt;
  const auto step = q.fused ? std::optional(*dt * *v) : stored(*dt * *v);
  if (!step || step->is_zero()) return std::nullopt;
  ClockAlternative a{.kind = ClockAlternative::Kind::wider, .arithmetic = wide};
  set_value(a, accumulated(Accumulator{wide.format, wide.rounding, *start, *step}, q.additions).value,
            q.start + q.additions * q.advance());
  return a;
}

std::vector<ClockAlternative> alternatives(const ClockReport& c, const Progress& progress) {
  using Kind = ClockAlternative::Kind;
  const ClockQuestion& q = c.question;
  const ClockArithmetic& own = q;
  std::vector<ClockAlternative> result;
  const Rational rate = Rational(1) / q.advance().abs();
  if (!q.velocity && rate.is_integer() && rounded(rate, own.format, own.rounding) == rate) {
    ClockAlternative a{.kind = Kind::divided, .rate = rate};
    set_value(a, read_out(q, c.stored_start, q.dt.sign() < 0 ? -rate : rate, true), c.meant);
    result.push_back(std::move(a));
  }
  ClockAlternative product{.kind = Kind::multiplied};
  set_value(product, c.by_multiplication, c.meant);
  result.push_back(std::move(product));
  if (own.fixed_point) return result;
  if (!own.compensated) {
    ClockAlternative a{.kind = Kind::compensated};
    if (rounded(c.increment, own.format, own.rounding) == c.increment) {
      a.sum = compensated_clock(c.stored_start, c.increment, own.format, own.rounding, q.additions,
                                std::min(q.most_stepped, Rational(1'000'000)), progress);
      set_value(a, a.sum->value, c.meant);
      result.push_back(std::move(a));
    }
  }
  if (own.format.precision < 113) {
    if (auto wide = wider(q)) result.push_back(std::move(*wide));
  }
  const Rational power = nearest_power_of_two(q.dt.abs());
  const Rational exact_until = Rational(2).pow(own.format.precision);
  if (!q.velocity && q.start.is_zero() && power != q.dt.abs() &&
      rounded(power, own.format, own.rounding) == power &&
      rounded(exact_until * power, own.format, own.rounding)) {
    ClockAlternative a{.kind = Kind::dyadic, .step = q.dt.sign() < 0 ? -power : power};
    a.exact_additions = exact_until;
    result.push_back(std::move(a));
  }
  return result;
}

}  // namespace

ClockReport clock_report(const ClockQuestion& q, const Progress& progress) {
  check(q);
  ClockReport c;
  c.question = q;
  c.stored_dt = stored(q.kept_dt.value_or(q.dt), q, "dt");
  c.stored_start = stored(q.start, q, "the start");
  Rational product = c.stored_dt;
  if (q.velocity) {
    c.stored_velocity = stored(*q.velocity, q, "the velocity");
    product *= *c.stored_velocity;
  }
  c.increment = q.velocity && !q.fused ? stored(product, q, "v dt") : product;
  if (c.increment.is_zero())
    throw BadInput("what is added is 0 in " + q.format_name + ", whose smallest number is " +
                   q.format.smallest().significant(6) + ": such a clock stands still");
  c.meant = q.start + q.additions * q.advance();
  c.stored_meant = c.stored_start + q.additions * product;
  c.representation = c.meant - c.stored_meant;
  // Sums in a fixed-point word are never rounded: it is full or it is not.
  const Rounding of_sums = q.fixed_point ? Rounding::nearest_even : q.rounding;
  c.path = accumulator_path({q.format, of_sums, c.stored_start, c.increment}, q.additions);
  c.run = part_of(c.path, q.additions);
  c.freezes = freeze_of(c.path);
  c.speeds = speeds(c.path, q.advance());
  if (q.compensated) {
    c.kahan = compensated_clock(c.stored_start, c.increment, q.format, q.rounding, q.additions,
                                q.most_stepped, progress);
    c.value = c.kahan->value;
  } else {
    c.value = c.run.value;
  }
  if (c.value) {
    c.rounding_part = c.stored_meant - *c.value;
    c.shortfall = c.meant - *c.value;
  }
  c.by_multiplication = read_out(q, c.stored_start, c.increment, false);
  c.instead = alternatives(c, progress);
  return c;
}

}  // namespace shortfall
