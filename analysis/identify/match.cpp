// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/match.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

namespace {

constexpr double kStandardGravities[] = {9.81, 9.80665, 9.8, 10};
constexpr double kHopeful = 10;
constexpr int kNeighbours = 80;  // of a launch that was not recorded, in units of its last place

/// The shortest decimal within a distance, or the simplest fraction where that is much simpler.
std::optional<Rational> nice(const Fitted& number, double bias, double wider) {
  const double reach =
      std::isfinite(number.spread) ? wider * (4 * number.spread + bias) + 4e-15 * std::fabs(number.value) : 0;
  if (std::fabs(number.value) <= reach || number.value == 0) return Rational(0);
  if (!(reach > 0) || reach > 0.02 * std::fabs(number.value)) return std::nullopt;
  const Rational fraction = simplest(number.value, reach);
  const double digits = 2 * std::log10(fraction.denominator().to_double()) + 0.3;
  for (int d = 0; d <= digits && d < 16; ++d) {
    const double scale = std::pow(10.0, d);
    const double whole = std::round(number.value * scale);
    if (std::fabs(whole) < 9e15 && std::fabs(whole / scale - number.value) <= reach)
      return Rational(static_cast<std::int64_t>(whole), static_cast<std::int64_t>(scale));
  }
  return fraction;
}

double neighbour(double value, int steps, bool narrow) {
  for (int i = 0; i < std::abs(steps); ++i) {
    const double to = steps > 0 ? HUGE_VAL : -HUGE_VAL;
    value = narrow ? static_cast<double>(std::nextafter(static_cast<float>(value), static_cast<float>(to)))
                   : std::nextafter(value, to);
  }
  return value;
}

class Matching {
 public:
  Matching(const Candidate& candidate, const Observations& o, const Known& known, Match& match)
      : candidate_(candidate), o_(o), known_(known), match_(match) {}

  /// The largest difference that arithmetic explains, in units of the last place.
  double noise() const {
    const double x_unit = 2 * o_.half_position(o_.largest_position());
    const double v_unit = o_.velocities ? 2 * o_.half_velocity(o_.largest_velocity()) : 1;
    const double narrow = o_.rounding.kind == LogRounding::Kind::binary64 ? 0x1p-29 : 1;
    double most = 0;
    if (candidate_.tape->solves.empty()) {
      std::vector<Log::Triple> xs, vs;
      EngineFlight flight = match_.flight;
      flight.arithmetic = Arithmetic::binary64;
      fly(candidate_, o_.frame, o_.dt, flight, [&](std::size_t, const Log::Triple& x, const Log::Triple& v) {
        xs.push_back(x);
        vs.push_back(v);
        return true;
      });
      flight.arithmetic = Arithmetic::binary32;
      fly(candidate_, o_.frame, o_.dt, flight,
          [&](std::size_t row, const Log::Triple& x, const Log::Triple& v) {
            for (const int axis : o_.axes) {
              const auto i = static_cast<std::size_t>(axis);
              most = std::max(most, std::fabs(x[i] - xs[row][i]) / x_unit);
              if (o_.velocities) most = std::max(most, std::fabs(v[i] - vs[row][i]) / v_unit);
            }
            return true;
          });
    }
    const double nominal =
        0x1p-24 * std::sqrt(static_cast<double>(o_.frames())) *
        std::max(o_.largest_position() / x_unit, o_.velocities ? o_.largest_velocity() / v_unit : 0);
    // A method may lose far more than that to rounding; such a one says nothing about a log.
    return std::min(std::max(most, nominal), 30 * nominal) * narrow;
  }

  /// The numbers that a program would have been given.
  ///
  /// param   wider  how many times farther than its spread a number is looked for: roundings add up along a
  ///                log, which the spread does not know
  void set_flight(double wider) {
    EngineFlight& f = match_.flight;
    const Fit& fit = match_.fit;
    // Errors of one sign in each addition of a frame look like another parameter.
    const double unit = narrow() || !o_.exact() ? 0x1p-24 : 0x1p-53;
    const double speed = o_.velocities
                             ? o_.largest_velocity()
                             : 2 * o_.largest_position() / (o_.dt * static_cast<double>(o_.frames()));
    match_.c = nice(fit.c, unit / o_.dt, wider);
    match_.k = nice(fit.k, unit / (o_.dt * o_.dt), wider);
    f.c = match_.c ? match_.c->to_double() : fit.c.value;
    f.k = match_.k ? match_.k->to_double() : fit.k.value;
    f.launch = fit.launch;
    for (const int axis : o_.axes) {
      const auto i = static_cast<std::size_t>(axis);
      match_.a[i] = nice(fit.a[i], unit * speed / o_.dt + fit.k.value * unit * o_.largest_position(), wider);
      f.gravity[i] = match_.a[i] ? match_.a[i]->to_double() : fit.a[i].value;
      f.x0[i] = o_.exact() ? o_.x[0][i] : fit.x0[i].value;
      f.v0[i] = o_.exact() && velocity_known() ? o_.v[0][i] : fit.v0[i].value;
      f.impulse[i] = fit.j[i].value;
    }
    f.arithmetic =
        o_.rounding.kind == LogRounding::Kind::binary32 ? Arithmetic::binary32 : Arithmetic::binary64;
  }

  /// Looks for numbers with which the map makes the log bit by bit.
  void search() {
    for (const double wider : {1.0, 8.0, 64.0}) {
      const EngineFlight before = match_.flight;
      set_flight(wider);
      if (wider > 1 && same_numbers(before, match_.flight)) continue;
      search_near();
      if (match_.exact) return;
    }
    set_flight(1);
    if (match_.flight.k != 0 && velocity_known()) try_round_numbers();
  }

 private:
  /// Along an oscillation roundings add up to far more than round numbers are off: those of a program may
  /// come nearer than the best that a fit finds.
  void try_round_numbers() {
    std::optional<EngineFlight> best;
    double best_wider = 1;
    for (const double wider : {1.0, 8.0, 64.0}) {
      set_flight(wider);
      const EngineFlight told = match_.flight;
      for (const EngineFlight& flight : {told, stretched()}) {
        const double ulp = compare(candidate_, o_, flight).ulp;
        if (!(ulp < match_.ulp)) continue;
        match_.ulp = ulp;
        best = flight;
        best_wider = wider;
      }
    }
    set_flight(best_wider);
    if (best) match_.flight = *best;
  }

  static bool same_numbers(const EngineFlight& a, const EngineFlight& b) {
    return a.c == b.c && a.k == b.k && a.gravity == b.gravity;
  }

  void search_near() {
    std::vector<Arithmetic> arithmetics = {match_.flight.arithmetic};
    if (match_.flight.arithmetic == Arithmetic::binary32)
      arithmetics.push_back(Arithmetic::binary64_stored_32);
    for (const Arithmetic arithmetic : arithmetics)
      for (const EngineFlight& split : splits())
        for (const Adding adding : addings(split))
          for (const double c : damping_numbers()) {
            EngineFlight flight = split;
            flight.arithmetic = arithmetic;
            flight.adding = adding;
            flight.c = c;
            if (!launched(flight)) continue;
            match_.flight = flight;
            match_.exact = true;
            match_.ulp = 0;
            return;
          }
  }

  bool velocity_known() const { return o_.velocities && o_.first_velocity; }
  bool narrow() const { return o_.rounding.kind == LogRounding::Kind::binary32; }

  /// A spring pulls towards the place where it rests: in exact arithmetic the same as a constant part.
  EngineFlight stretched() const {
    EngineFlight f = match_.flight;
    for (const int axis : o_.axes) {
      const auto i = static_cast<std::size_t>(axis);
      const bool both = match_.a[i] && match_.k && !match_.k->is_zero();
      f.rest[i] = both ? (*match_.a[i] / *match_.k).to_double() : f.gravity[i] / f.k;
      f.gravity[i] = 0;
    }
    return f;
  }

  /// Gravity and force are two summands for an engine; a log shows their sum.
  std::vector<EngineFlight> splits() const {
    std::vector<EngineFlight> result;
    const auto split = [&](double g) {
      EngineFlight f = match_.flight;
      for (const int axis : o_.axes) {
        const auto i = static_cast<std::size_t>(axis);
        const Rational pull = axis == known_.up ? -simplest(g, 1e-12 * g) : Rational(0);
        f.force[i] =
            match_.a[i] ? (*match_.a[i] - pull).to_double() : match_.flight.gravity[i] - pull.to_double();
        f.gravity[i] = pull.to_double();
      }
      result.push_back(f);
    };
    if (known_.g && *known_.g > 0) split(*known_.g);
    result.push_back(match_.flight);
    if (match_.flight.k != 0) result.push_back(stretched());
    if (known_.g) return result;
    const auto up = static_cast<std::size_t>(known_.up);
    const bool pushed = std::ranges::any_of(o_.axes, [&](int axis) {
      return axis != known_.up && match_.flight.gravity[static_cast<std::size_t>(axis)] != 0;
    });
    if (pushed || (match_.flight.gravity[up] != 0 && match_.flight.k == 0))
      for (const double g : kStandardGravities)
        if (std::fabs(match_.flight.gravity[up] + g) > 1e-9) split(g);
    return result;
  }

  std::vector<Adding> addings(const EngineFlight& f) const {
    const bool pushed = f.k != 0 || std::ranges::any_of(f.force, [](double a) { return a != 0; }) ||
                        (!candidate_.own_damping && f.c != 0);
    if (!pushed) return {Adding::at_once};
    return {Adding::at_once, Adding::after_scaling, Adding::gravity_first, Adding::force_first};
  }

  std::vector<double> damping_numbers() const {
    const double c = match_.flight.c;
    if (c == 0) return {0};
    return {c, neighbour(c, 1, narrow()), neighbour(c, -1, narrow())};
  }

  /// Launches that a program would have been given; the fit of one may be more last places away than are
  /// tried.
  std::vector<double> round_launches(Launch launch, int axis) const {
    const auto i = static_cast<std::size_t>(axis);
    const Fitted& fitted = launch == Launch::impulse ? match_.fit.j[i] : match_.fit.v0[i];
    std::vector<double> values;
    if (std::fabs(fitted.value) < 1e-9) values.push_back(0);
    for (const double wider : {1.0, 64.0})
      if (const auto told = nice(fitted, 0, wider);
          told && std::ranges::find(values, told->to_double()) == values.end())
        values.push_back(told->to_double());
    return values;
  }

  /// Where a body is in the second row when it is launched so.
  double first_position(EngineFlight& flight, double& number, double value, int axis) const {
    number = value;
    double x = 0;
    fly(candidate_, {o_.frame[0], o_.frame[1]}, o_.dt, flight,
        [&](std::size_t, const Log::Triple& at, const Log::Triple&) {
          x = at[static_cast<std::size_t>(axis)];
          return true;
        });
    return x;
  }

  /// The first neighbour of a launch with which the body comes as far in the second row as the log says: it
  /// goes the farther the faster it starts. kNeighbours + 1 when none does.
  int first_that_reaches(EngineFlight& flight, double& number, double middle, int axis) const {
    const double wanted = o_.x[1][static_cast<std::size_t>(axis)];
    int low = -kNeighbours - 1, high = kNeighbours + 1;
    while (high - low > 1) {
      const int between = low + (high - low) / 2;
      const bool reaches =
          first_position(flight, number, neighbour(middle, between, narrow()), axis) >= wanted;
      (reaches ? high : low) = between;
    }
    return high;
  }

  /// Whether there is a launch that makes the log; a launch that was recorded is it.
  bool launched(EngineFlight& flight) const {
    if (velocity_known() && flight.launch == Launch::velocity)
      return compare(candidate_, o_, flight, -1, false).exact;
    // The axis that moves most refutes soonest.
    std::vector<int> axes = o_.axes;
    std::ranges::stable_sort(axes, std::greater<>(), [&](int axis) {
      const auto i = static_cast<std::size_t>(axis);
      double most = 0;
      for (const Log::Triple& x : o_.x) most = std::max(most, std::fabs(x[i] - o_.x[0][i]));
      return most;
    });
    for (const int axis : axes) {
      double& number =
          (flight.launch == Launch::impulse ? flight.impulse : flight.v0)[static_cast<std::size_t>(axis)];
      const double middle = number;
      if (velocity_known() == false && flight.launch == Launch::impulse)
        flight.v0[static_cast<std::size_t>(axis)] = 0;
      const auto makes = [&](double value) {
        number = value;
        return compare(candidate_, o_, flight, axis, false).exact;
      };
      bool found = false;
      for (const double value : round_launches(flight.launch, axis)) found = found || makes(value);
      if (found) continue;
      for (int i = first_that_reaches(flight, number, middle, axis); !found && i <= kNeighbours; ++i) {
        const double value = neighbour(middle, i, narrow());
        if (first_position(flight, number, value, axis) > o_.x[1][static_cast<std::size_t>(axis)]) break;
        found = makes(value);
      }
      if (!found) return false;
    }
    return true;
  }

  const Candidate& candidate_;
  const Observations& o_;
  const Known& known_;
  Match& match_;
};

}  // namespace

Rational simplest(double value, double distance) {
  if (std::fabs(value) <= distance) return 0;
  const Rational low = Rational::from_double(std::fabs(value) - distance);
  const Rational high = Rational::from_double(std::fabs(value) + distance);
  const Rational found = simplest_between(low, high);
  return value < 0 ? -found : found;
}

std::optional<Match> match(const Candidate& candidate, const Observations& o, const FitQuestion& question,
                           const Known& known) {
  const std::optional<Fit> found = fit(candidate, o, question);
  if (!found) return std::nullopt;
  Match result;
  result.candidate = candidate;
  result.fit = *found;
  result.ulp = found->worst / 2;
  result.allowed = 0.5;
  // A damping or a stiffness below zero is no map of the family.
  const auto negative = [](const Fitted& n) { return n.value < -4 * n.spread - 1e-12; };
  Matching matching(candidate, o, known, result);
  matching.set_flight(1);
  const bool acts = !candidate.tape->limits.empty() || !candidate.tape->whens.empty();
  const double range = std::max(o.largest_position(), 1e-30);
  const bool near = found->worst < 1e5 || (acts && found->worst_position < 1e-3 * range);
  if (near && !negative(found->c) && !negative(found->k)) {
    result.allowed += 1.5 * matching.noise() + (o.exact() ? 1.5 : 1e-6);
    // So far from it no choice of the last bits helps.
    const bool switches = !candidate.tape->whens.empty() || (acts && !question.spring);
    const bool hopeful = switches || result.ulp <= kHopeful * result.allowed;
    if (hopeful && o.exact() && candidate.tape->solves.empty()) matching.search();
  }
  if (negative(found->c) || negative(found->k)) result.allowed = -1;
  return result;
}

}  // namespace shortfall
