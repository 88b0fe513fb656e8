// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/spring_report.hpp"

#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/pi.hpp"
#include "analysis/motion/ball_flow.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kSpringBits = 320;

/// The angle in (0, pi) of cosine and (positive) sine: by Newton's method on the sine and cosine of Ball.
Ball angle(const Ball& cosine, const Ball& sine) {
  const double start = std::atan2(sine.to_double(), cosine.to_double());
  Ball a(Rational(static_cast<long long>(start * 1e15)) / Rational(1'000'000'000'000'000LL), kSpringBits);
  for (int round = 0; round < 6; ++round) {
    // sin(angle - a), which is the angle that is missing up to its cube.
    const Ball missing = sine * cos(a) - cosine * sin(a);
    a = Ball((a + missing).midpoint(), kSpringBits);
  }
  const Ball rest = sine * cos(a) - cosine * sin(a);  // |missing| <= 2 |sin(missing)| here
  return hull(a + rest - abs(rest), a + rest + abs(rest));
}

/// Trace and determinant of one frame where they are rational.
struct ExactFrame {
  Rational trace, determinant;

  Rational discriminant() const { return trace * trace - Rational(4) * determinant; }
  /// Both eigenvalues are in the unit circle or on it, there not twice in one place.
  /// source  Jury (1964), Theory and Application of the z-Transform Method, chapter 3
  bool stable() const {
    return determinant.abs() <= 1 && trace.abs() <= Rational(1) + determinant &&
           !(discriminant().is_zero() && trace.abs() == 2);
  }
};

std::optional<ExactFrame> exact_frame(const LinearDerivation& d, const SpringQuestion& q) {
  if (!d.map.extras.empty()) return std::nullopt;
  const std::map<Letter, Rational> at{{kStepLetter, q.h}, {kStiffness, q.k}, {kDamping, q.c}};
  return ExactFrame{d.trace->evaluate(at), d.determinant->evaluate(at)};
}

/// param   critical  known to have one eigenvalue twice, which no ball can tell
EffectiveSpring effective(const Ball& trace, const Ball& determinant, const Rational& h, bool critical) {
  EffectiveSpring e{trace, determinant, false, {}, {}, {}, {}};
  const Ball one(1, kSpringBits), two(2, kSpringBits), step(h, kSpringBits);
  const Ball discriminant = trace * trace - Ball(4, kSpringBits) * determinant;
  e.oscillates = !critical && discriminant.sign() == -1;
  if (e.oscillates) {
    const Ball size = sqrt(determinant);
    const Ball rate = -log(size) / step;
    const Ball cosine = trace / (two * size);
    const Ball theta = angle(cosine, sqrt(one - cosine * cosine)) / step;
    const Ball omega = sqrt(rate * rate + theta * theta);
    e.growth = exp(-rate);
    e.frequency = omega / (two * pi(kSpringBits));
    e.damping_ratio = rate / omega;
    const Ball excess = determinant - one;
    if (const auto sign = excess.sign()) e.stable = *sign <= 0;
    return e;
  }
  if (!critical && !discriminant.sign())
    throw Unable("whether the eigenvalues of one frame are real or complex is not decided by " +
                 std::to_string(kSpringBits) + " bits: they are nearly equal");
  const Ball root = critical ? Ball(0, kSpringBits) : sqrt(discriminant);
  const Ball larger = (abs(trace) + root) / two;
  e.growth = exp(log(larger) / step);
  if (const auto sign = (larger - one).sign()) e.stable = *sign < 0;
  return e;
}

/// Of the physics itself, whose frequency frames may be too few to show.
///
/// param   critical  known to be so, which no ball can tell
EffectiveSpring true_spring(const Ball& trace, const Ball& determinant, const Ball& k, const Ball& c,
                            bool critical) {
  EffectiveSpring e{trace, determinant, false, true, {}, {}, {}};  // c >= 0 and k > 0
  const Ball two(2, kSpringBits), omega = sqrt(k), rate = c / two;
  const Ball excess = rate * rate - k;
  e.oscillates = !critical && excess.sign() == -1;
  if (!e.oscillates && !critical && !excess.sign())
    throw Unable("whether the spring is damped beyond the critical is not decided by " +
                 std::to_string(kSpringBits) + " bits");
  e.growth = exp(critical || e.oscillates ? -rate : sqrt(excess) - rate);
  if (e.oscillates) {
    e.frequency = omega / (two * pi(kSpringBits));
    e.damping_ratio = rate / omega;
  }
  return e;
}

/// A whole number of half turns a frame, up to the digits to which a frequency was made a stiffness.
bool turns_by_halves(const EffectiveSpring& truth, const SpringQuestion& q) {
  if (!truth.oscillates || !q.rounded) return false;
  const Ball sine_squared = truth.determinant - truth.trace * truth.trace / Ball(4, kSpringBits);
  return std::abs(sine_squared.to_double()) < 1e-50 * truth.determinant.to_double();
}

}  // namespace

void set_spring(SpringQuestion& q, const Rational& frequency, const Rational& damping_ratio) {
  const Ball omega = Ball(frequency * 2, kSpringBits) * pi(kSpringBits);
  const auto rounded = [](const Ball& b) {
    return b.is_zero() ? Rational() : Rational::parse(b.midpoint().significant(60));
  };
  q.k = rounded(omega * omega);
  q.c = rounded(Ball(damping_ratio * 2, kSpringBits) * omega);
  q.rounded = true;
}

Program held_over_substeps(const Program& program, int substeps) {
  Program result = substepped(program, substeps);
  result.holds_force = true;
  return result;
}

SpringReport spring_report(const Program& program, const SpringQuestion& q) {
  if (q.k.sign() <= 0) throw BadInput("the stiffness of a spring is positive, not " + q.k.str());
  if (q.c.sign() < 0) throw BadInput("the damping of a spring is 0 or more, not " + q.c.str());
  SpringReport report;
  report.integrator = program.name;
  report.question = q;
  const Program frame = q.held ? held_over_substeps(program, q.substeps) : substepped(program, q.substeps);
  const Values values = parameter_values(frame, q.parameters);
  Force force = force_named(q.c.is_zero() ? "spring" : "damped-spring");
  Values fixed = q.parameters;
  for (const auto& [name, value] : values) fixed.emplace(name, value);
  // The integrator's own damping counts as well: it is given as a number.
  if (program.solves && force.damper) {
    const Force whole = with_own_equation(force_named("spring"), program, fixed);
    if (whole.own_c)
      throw BadInput("'" + program.name +
                     "' has damping of its own: give it by --param, and the spring without --c or "
                     "--damping-ratio");
  }
  const LinearDerivation d = linear_derivation(frame, force, fixed, 1);
  if (!d.trace || !d.determinant)
    throw Unable("position and velocity alone do not carry the motion of '" + program.name +
                 "': it has no trace and determinant of its own");
  const Wording w{d.map.letters, "n", false};
  report.trace = formula(*d.trace, w);
  report.determinant = formula(*d.determinant, w);
  std::map<std::string, Ball> at{{"h", Ball(q.h, kSpringBits)},
                                 {d.map.letters[kStiffness], Ball(q.k, kSpringBits)},
                                 {d.map.letters[kDamping], Ball(q.c, kSpringBits)}};
  const std::optional<ExactFrame> exact = exact_frame(d, q);
  report.effective =
      effective(ball_value(report.trace, at, kSpringBits), ball_value(report.determinant, at, kSpringBits),
                q.h, exact && exact->discriminant().is_zero());
  if (exact) report.effective.stable = exact->stable();
  // The damping that is meant: the user's, or the integrator's own, which may be a logarithm.
  const Ball k(q.k, kSpringBits), h(q.h, kSpringBits);
  const Fraction meant = d.force.own_c.value_or(Fraction(q.c));
  const Ball true_c = ball_value(meant, letter_balls(d.map.extras, kSpringBits), kSpringBits);
  const BallFlow flow =
      meant.is_constant() ? ball_flow(q.k, meant.constant(), q.h, kSpringBits) : ball_flow(k, true_c, h);
  const bool critical = meant.is_constant() && (meant * meant).constant() == Rational(4) * q.k;
  report.truth = true_spring(flow.cosine + flow.sine_rate, exp(-true_c * h), k, true_c, critical);
  // An undamped step with determinant 1 exactly is as stable as its physics.
  if (d.determinant->is_one() && report.effective.oscillates) report.effective.stable = true;
  if (q.held && q.substeps > 1) {
    report.no_kit =
        "with the force held over the substeps the kit is solved for by: correct, with a file that says "
        "'hold a'";
    return report;
  }
  if (turns_by_halves(report.truth, q)) {
    report.no_kit =
        "the spring turns by a whole number of half turns each frame: where it is on the frames says nothing "
        "of its velocity, and no launch does";
    return report;
  }
  try {
    Force numeric = force;
    numeric.k = q.k;
    if (force.damper) numeric.c = q.c;
    const LinearKit kit = linear_kit(program, numeric, fixed, q.substeps);
    if (!kit.exists)
      report.no_kit = kit.obstruction;
    else
      report.kit = kit_numbers(kit, with_own_equation(numeric, program, fixed), fixed, q.h, 12);
  } catch (const Unable& e) {
    report.no_kit = e.what();
  }
  return report;
}

}  // namespace shortfall
