// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_launch.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

constexpr int kFramesTried = 50;         // where frames are all we have
constexpr int kFramesOfRoots = 100'000;  // how far the sign of a polynomial is followed

/// Exactly where that is short.
std::string shown(const Rational& value) {
  return value.digits() <= 12 ? value.str() : "about " + value.significant(10);
}

/// What frame n would need, in units of g, to be where the exact motion is.
Rational needed(const Flight& flight, const Rational& n) {
  const Rational t = n * flight.dt();
  return (flight.fall(n) - t * t / 2) / flight.rise(n);
}

/// Why no correction serves frame n, if so; `first` is what frame 1 needs.
std::string objection(const Flight& flight, const Rational& n, const Rational& first) {
  const Rational t = n * flight.dt();
  if (const Rational gone = flight.rise(n); gone != t)
    return "without gravity the body has moved launch * " + shown(gone) + " s in " + n.str() + " frame" +
           (n.is_one() ? "" : "s") + " instead of launch * " + shown(t) +
           " s, so that what is missing depends on the launch";
  if (const Rational here = needed(flight, n); here != first)
    return "frame 1 needs a launch that is greater by g * " + shown(first) + " s, frame " + n.str() +
           " one by g * " + shown(here) + " s: no velocity serves both";
  return {};
}

bool corrected_for_all_n(const Flight& flight) {
  const auto& rise = flight.rise();
  const auto& fall = flight.fall();
  const Rational& dt = flight.dt();
  return rise[0].is_zero() && rise[1] == dt && rise[2].is_zero() && fall[0].is_zero() &&
         fall[2] == dt * dt / 2;
}

Expr formula_of(const Flight& flight, const Rational& per_gravity) {
  if (const auto& fall = flight.fall_in_letters()) {
    const Fraction linear(fall->numerator().coefficient(kCount, 1), fall->denominator());
    if (!fall->denominator().contains(kCount))
      return formula(linear / Fraction::letter(kStepLetter), name("g"), {flight.letters(), "n", true});
  }
  return number(per_gravity) * name("g");
}

/// With damping: if the heights of a flight are concave from frame 0 on, for every launch, frame 1 is above
/// the ground whenever any frame is. The change of the change is (gain of height)(ratio - 1)^2 ratio^n.
bool first_frame_decides(const Flight& flight) {
  const auto& sums = flight.geometric();
  return sums && sums->from == 0 && sums->ratio.sign() > 0 && sums->rise.gain.sign() <= 0 &&
         sums->fall.gain.sign() >= 0 && flight.rise(1).sign() > 0 && flight.rise(0).is_zero() &&
         flight.fall(0).is_zero();
}

}  // namespace

LaunchCorrection launch_correction(const Flight& flight) {
  LaunchCorrection result;
  if (flight.rise(1).is_zero()) {
    result.reason = "the launch velocity does not move the body in frame 1";
    return result;
  }
  result.per_gravity = needed(flight, 1);
  const bool all = flight.parabolic() && corrected_for_all_n(flight);
  // Two parabolas through the origin that agree in frames 1, 2 and 3 are one, so these frames hold the
  // objection.
  const int tried = flight.settled() + (flight.parabolic() ? 3 : kFramesTried);
  for (int n = 1; n <= tried && result.reason.empty(); ++n)
    result.reason = objection(flight, n, result.per_gravity);
  if (!result.reason.empty()) {
    result.per_gravity = 0;
    return result;
  }
  if (!all)
    throw Unable(
        "frames 1 to " + std::to_string(tried) + " of " + flight.program().name +
        " need the same launch correction, but its flight has no closed form that would prove it for all");
  result.exists = true;
  result.formula = formula_of(flight, result.per_gravity);
  return result;
}

LiftOff lift_off(const Flight& flight, const Rational& g) {
  LiftOff result;
  if (first_frame_decides(flight)) {
    const Rational first = flight.fall(1) / flight.rise(1);
    result.height = first.sign() <= 0 ? Rational(0) : g * first * first / 2;
    return result;
  }
  if (!flight.parabolic()) {
    result.reason = "the flight is no parabola";
    if (flight.rise(1).sign() > 0) {
      const Rational first = std::max(Rational(0), flight.fall(1) / flight.rise(1));
      result.reason += "; frame 1 is above the ground if and only if H > " +
                       (g * first * first / 2).significant(6) + " m (rounded)";
    }
    return result;
  }
  // Frame n is above the ground when launch > g fall(n) / rise(n). The least such quotient decides; from the
  // last sign change of its difference on, it only grows.
  const auto polynomial = [](const Flight::Parabola& p) { return Polynomial::in(kCount, p); };
  const Polynomial rise = polynomial(flight.rise());
  const Polynomial fall = polynomial(flight.fall());
  const Polynomial next = Polynomial::letter(kCount) + Polynomial(1);
  const Polynomial growth = fall.substitute(kCount, next) * rise - fall * rise.substitute(kCount, next);
  Rational bound = flight.settled();
  const auto widen = [&bound](const Polynomial& p) {  // Cauchy: no root lies beyond
    if (p.is_zero()) return;
    const Rational leading = p.coefficient(kCount, p.degree(kCount)).constant();
    for (int k = 0; k < p.degree(kCount); ++k)
      bound = std::max(bound, 1 + (p.coefficient(kCount, k).constant() / leading).abs());
  };
  widen(growth);
  widen(rise);
  const Rational last = bound.floor() + 2;
  if (last > kFramesOfRoots || flight.rise(last).sign() <= 0 ||
      flight.fall(last + 1) * flight.rise(last) < flight.fall(last) * flight.rise(last + 1)) {
    result.reason = "no frame is the easiest one to reach";
    return result;
  }
  std::optional<Rational> least;
  for (Rational n = 1; n <= last; n += 1) {
    const Rational rises = flight.rise(n);
    if (rises.sign() <= 0) {
      result.reason = "a greater launch does not lift frame " + n.str();
      return result;
    }
    const Rational quotient = flight.fall(n) / rises;
    if (!least || quotient < *least) least = quotient;
  }
  result.height = least->sign() <= 0 ? Rational(0) : g * *least * *least / 2;
  return result;
}

}  // namespace shortfall
