// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/clock.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

/// The binade of a number: 2^low <= |value| < 2^(low + 1); subnormals share the lowest one with zero.
struct Binade {
  Rational low, high;
  bool operator==(const Binade&) const = default;
};
Binade binade_of(const Rational& value, const BinaryFormat& format) {
  const long lowest = format.least_unit + format.precision - 1;  // of normal numbers
  const long e = value.is_zero() ? lowest : std::max(leading_bit(value.abs()), lowest);
  return {e == lowest ? Rational() : power_of_two(e), power_of_two(e + 1)};
}

class Walk {
 public:
  explicit Walk(const Accumulator& clock) : clock_(clock), at_(clock.start) {}

  const Rational& at() const { return at_; }
  const Rational& done() const { return done_; }
  Binade binade() const { return binade_of(at_, clock_.format); }
  bool infinite() const { return infinite_; }
  bool frozen() const { return frozen_; }
  const std::optional<Rational>& exact_additions() const { return exact_additions_; }
  std::vector<Stretch> stretches;

  /// One addition.
  void step() {
    const auto next = rounded(at_ + clock_.increment, clock_.format, clock_.rounding);
    if (!next) {
      infinite_ = true;
      return;
    }
    advance(*next - at_, 1);
  }

  /// As many additions of the size of the last one as stay inside the binade, at most `most`.
  void jump(const Rational& most) {
    if (stretches.empty() || frozen_) return;
    const Rational added = stretches.back().added;
    const Binade binade = this->binade();
    const Rational size = at_.abs(), margin = clock_.increment.abs() + added.abs();
    const bool outwards = at_.is_zero() || (at_.sign() > 0) == (added.sign() > 0);
    // All sums on the way stay clear of the binade's ends, so that they are rounded to the same unit.
    const Rational room = outwards ? binade.high - size - margin : size - binade.low - margin;
    if (room.sign() <= 0) return;
    const Rational times = std::min((room / added.abs()).floor(), most);
    if (times.sign() > 0) advance(added, times);
  }

 private:
  void advance(const Rational& added, const Rational& times) {
    if (!exact_additions_ && added != clock_.increment) exact_additions_ = done_;
    if (!stretches.empty() && stretches.back().added == added)
      stretches.back().additions += times;
    else
      stretches.push_back({at_, added, times});
    at_ += added * times;
    done_ += times;
    frozen_ = added.is_zero();
  }

  const Accumulator& clock_;
  Rational at_, done_;
  std::optional<Rational> exact_additions_;
  bool infinite_ = false, frozen_ = false;
};

void check(const Accumulator& clock) {
  if (clock.increment.is_zero()) throw BadInput("a clock with dt = 0 stands still");
  for (const Rational* r : {&clock.start, &clock.increment})
    if (rounded(*r, clock.format) != std::optional<Rational>(*r))
      throw BadInput(r->significant(8) + " is no number of the format");
}

/// Three additions, then as far as the binade allows. The first may come from another binade, the second
/// leaves what a tie leaves, the third is what all others are.
void advance(Walk& walk, const Rational& most) {
  const auto goes_on = [&] { return walk.done() < most && !walk.infinite() && !walk.frozen(); };
  if (goes_on()) walk.step();
  const Binade binade = walk.binade();
  for (int k = 0; k < 2; ++k) {
    if (!goes_on()) return;
    walk.step();
    if (walk.infinite() || walk.binade() != binade) return;
  }
  if (goes_on()) walk.jump(most - walk.done());
}

/// An addition that changes nothing is the last that matters: a tie needs no second look, as the value stays.
std::optional<Accumulation::Freeze> freeze_of(const Walk& walk) {
  if (!walk.frozen()) return std::nullopt;
  Rational before = walk.done();
  before -= walk.stretches.back().additions;
  return Accumulation::Freeze{walk.at(), before};
}

}  // namespace

Accumulation accumulated(const Accumulator& clock, const Rational& additions) {
  check(clock);
  if (!additions.is_integer() || additions.sign() < 0)
    throw BadInput("a number of additions is a whole number, 0 or more");
  Walk walk(clock);
  while (walk.done() < additions && !walk.infinite() && !walk.frozen()) advance(walk, additions);
  Accumulation result;
  result.additions = additions;
  if (!walk.infinite()) result.value = walk.at();
  result.exact_additions = walk.exact_additions();
  result.freezes = freeze_of(walk);
  result.stretches = std::move(walk.stretches);
  return result;
}

std::optional<Accumulation::Freeze> freezing_point(const Accumulator& clock) {
  check(clock);
  Walk walk(clock);
  const Rational always = Rational(10).pow(400'0);  // more additions than any format's numbers
  while (!walk.infinite() && !walk.frozen()) advance(walk, always);
  return freeze_of(walk);
}

ClockReport clock_report(const ClockQuestion& q) {
  ClockReport r;
  r.question = q;
  const auto stored = [&](const Rational& value, const char* what) {
    const auto kept = rounded(value, q.format, q.rounding);
    if (!kept) throw BadInput(std::string(what) + " is infinite in " + q.format_name);
    return *kept;
  };
  const Rational dt = stored(q.kept_dt.value_or(q.dt), "dt");
  r.increment = q.velocity ? stored(stored(*q.velocity, "the velocity") * dt, "the move of a step") : dt;
  if (r.increment.is_zero())
    throw BadInput("what is added is 0 in " + q.format_name + ": too small a number");
  const Accumulator clock{q.format, q.rounding, stored(q.start, "the start"), r.increment};
  r.meant = q.start + q.additions * (q.velocity ? *q.velocity * q.dt : q.dt);
  r.stored_meant = clock.start + q.additions * r.increment;
  r.run = accumulated(clock, q.additions);
  r.freezes = freezing_point(clock);
  if (const auto n = rounded(q.additions, q.format, q.rounding))
    if (const auto product = rounded(*n * r.increment, q.format, q.rounding))
      r.by_multiplication = rounded(clock.start + *product, q.format, q.rounding);
  const Rational u =
      power_of_two((q.rounding == Rounding::nearest_even || q.rounding == Rounding::nearest_away ? 0 : 1) -
                   q.format.precision);
  const Rational terms = q.additions + Rational(clock.start.is_zero() ? 0 : 1);
  r.compensated_bound =
      (Rational(2) * u + Rational(4) * terms * u * u) * (clock.start.abs() + q.additions * r.increment.abs());
  return r;
}

}  // namespace shortfall
