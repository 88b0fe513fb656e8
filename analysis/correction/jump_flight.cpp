// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/closed_form.hpp"
#include "analysis/problems/undisturbed_numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// Whether the clock stands anywhere but as an argument of the force.
bool reads_clock(const Expr& e) {
  if (!e || e->op == Expression::Op::force) return false;
  return (e->op == Expression::Op::name && e->name == "t") ||
         std::ranges::any_of(e->operands, [](const Expr& operand) { return reads_clock(operand); });
}

bool reads_clock(const std::vector<Statement>& block) {
  return std::ranges::any_of(block, [](const Statement& s) {
    return reads_clock(s.value) || reads_clock(s.body) ||
           std::ranges::any_of(s.unknowns, [](const Unknown& u) { return reads_clock(u.value); });
  });
}

/// A polynomial in n of degree 2 at most, once every other letter has its value.
std::optional<Flight::Parabola> parabola(Fraction f, const Tape& tape, const Values& parameters,
                                         const Rational& dt) {
  f = f.substitute(kStepLetter, dt);
  for (std::size_t i = 0; i < tape.parameters.size(); ++i) {
    const Letter letter = kFirstParameter + static_cast<Letter>(i);
    if (f.contains(letter)) f = f.substitute(letter, parameters.at(tape.parameters[i].name));
  }
  if (!f.is_polynomial() || f.numerator().degree(kCount) > 2) return std::nullopt;
  Flight::Parabola result;
  for (int k = 0; k < 3; ++k)
    result[static_cast<std::size_t>(k)] =
        f.numerator().coefficient(kCount, k).constant() / f.denominator().constant();
  return result;
}

}  // namespace

/// The two flights of which every other one is made, stepped in exact arithmetic as far as somebody asked.
struct Flight::Steps {
  Steps(const Program& program, const Values& parameters, const Rational& dt, LaunchBy by, int force_frames)
      : tape(lower(program, parameters)),
        pushed(by == LaunchBy::force ? static_cast<std::size_t>(force_frames) : 0),
        free(tape, weightless, dt),
        dropped(tape, heavy, dt) {
    free.begin(0, by == LaunchBy::velocity ? 1 : 0, 0);
    if (by == LaunchBy::impulse) free.give_impulse(1);
    dropped.begin(0, 0, 0);
    record();
    if (pushed > 0) push = Rational(1) / (dt * force_frames);
  }

  const std::pair<Rational, Rational>& frame(std::size_t n) {
    while (frames.size() <= n) {
      free.step();
      if (frames.size() >= pushed) push = 0;
      dropped.step();
      record();
    }
    return frames[n];
  }

  void record() {
    frames.emplace_back(free.read_out().first, dropped.read_out().first);
    rounded.emplace_back(frames.back().first.to_double(), frames.back().second.to_double());
  }

  /// launch * rise - g * fall of a frame in binary64, and more than its error.
  std::pair<double, double> near(std::size_t n, double launch, double g) const {
    constexpr double kManyRoundings = 1e-14;
    const double up = launch * rounded[n].first, down = g * rounded[n].second;
    return {up - down, kManyRoundings * (std::abs(up) + std::abs(down)) + std::numeric_limits<double>::min()};
  }

  Tape tape;
  std::size_t pushed;  ///< how many frames the force that launches is held over
  Rational push;       ///< that force, in the frame that comes next
  UndisturbedNumbers weightless = {
      {.force = [this](const Rational&, const Rational&, const Rational&) { return push; }}};
  UndisturbedNumbers heavy = constant_force(1);
  Run<UndisturbedNumbers> free;
  Run<UndisturbedNumbers> dropped;
  std::vector<std::pair<Rational, Rational>> frames;  ///< rise and fall
  std::vector<std::pair<double, double>> rounded;     ///< the same
};

Flight::Flight(const Program& program, const Rational& dt, int substeps, const Values& given, LaunchBy by,
               int force_frames)
    : program_(substepped(program, substeps)),
      dt_(dt),
      substeps_(substeps),
      parameters_(parameter_values(program, given)),
      by_(by),
      force_frames_(force_frames) {
  if (dt.sign() <= 0) throw BadInput("a time step is longer than 0 s, not " + dt.str() + " s");
  if (by == LaunchBy::impulse && !program.impulse)
    throw BadInput(program.name + " knows no impulse: its launch is a velocity that is set");
  if (force_frames < 1 || force_frames > kForceFrames)
    throw BadInput("a force that launches is held over 1 to " + std::to_string(kForceFrames) +
                   " frames, not " + std::to_string(force_frames));
  steps_ = std::make_unique<Steps>(program_, parameters_, dt_, by, force_frames);
  const bool fitted = fit();
  // In letters, too, for the formula of the correction; each way has flights that only it can solve.
  if ((by == LaunchBy::velocity ? parabolic_ || !fitted : parabolic_) && !adopt(lower(program_, given)))
    adopt(lower(program_, parameters_));
  const auto& rounded = *steps_->weightless.rounded;
  if (!parabolic_ || !fall_in_letters_) rounded_.assign(rounded.begin(), rounded.end());
}

Flight::Flight(Flight&&) noexcept = default;
Flight& Flight::operator=(Flight&&) noexcept = default;
Flight::~Flight() = default;

bool Flight::adopt(const Tape& tape) try {
  const StepMap map = step_map(tape, 0);
  const NumberField field(map.generators);
  const ClosedForm form = closed_form(map);
  const Sequence& rise = form.position[1];
  const Sequence& fall = form.position[2];
  if (!rise.is_polynomial() || !fall.is_polynomial()) return false;
  const auto up = parabola(rise.polynomial(), tape, parameters_, dt_);
  const auto down = parabola(fall.polynomial(), tape, parameters_, dt_);
  if (!up || !down) return false;
  if (by_ == LaunchBy::velocity) {  // the fall alone does not know how the body was launched
    rise_ = *up;
    fall_ = *down;
    settled_ = form.valid_from;
  }
  fall_in_letters_ = fall.polynomial();
  letters_ = map.letters;
  return parabolic_ = true;
} catch (const Unable&) {
  return false;
} catch (const Undefined&) {
  return false;
}

/// From the first frames, in numbers: a parabola, or a sum of powers.
bool Flight::fit() {
  if (reads_clock(program_.start) || reads_clock(program_.step) || reads_clock(program_.finish)) return false;
  // The carried vectors and the constant 1: an affine step satisfies a recurrence of this order.
  const int order = static_cast<int>(program_.states.size()) + 3;
  const auto frame = [this](std::size_t n) { return steps_->frame(n); };
  // A force that acts for several frames has to be over: the motion is another one before.
  const int first = by_ == LaunchBy::force && force_frames_ > 1 ? force_frames_ : 0;
  if (const auto parabolas = parabolic_flight(frame, order, first)) {
    settled_ = parabolas->from;
    rise_ = parabolas->rise;
    fall_ = parabolas->fall;
    return parabolic_ = true;
  }
  geometric_ = geometric_flight(frame, order, first);
  return geometric_.has_value();
}

const std::pair<Rational, Rational>& Flight::stepped(const Rational& n) const {
  std::int64_t count = 0;
  if (!n.fits_int64(count) || count < 0 || count > kStepped)
    throw Unable("the flight of " + program_.name + " has no closed form that we know; we step at most " +
                 std::to_string(kStepped) + " frames of it exactly, not " + n.str());
  return steps_->frame(static_cast<std::size_t>(count));
}

Rational Flight::rise(const Rational& n) const {
  if (parabolic_ && n >= settled_) return parabola_at(rise_, n);
  if (geometric_ && n >= geometric_->from) return geometric_->at(geometric_->rise, n);
  return stepped(n).first;
}

Rational Flight::fall(const Rational& n) const {
  if (parabolic_ && n >= settled_) return parabola_at(fall_, n);
  if (geometric_ && n >= geometric_->from) return geometric_->at(geometric_->fall, n);
  return stepped(n).second;
}

Surd Flight::height(const Surd& launch, const Rational& g, const Rational& n) const {
  return launch * rise(n) - Surd(g * fall(n));
}

std::array<Surd, 3> Flight::heights(const Surd& launch, const Rational& g) const {
  std::array<Surd, 3> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = launch * rise_[k] - Surd(g * fall_[k]);
  return result;
}

Frame Flight::highest(const Surd& launch, const Rational& g) const {
  if (geometric_)
    if (const auto top = geometric_->top(launch, g)) return highest_until(*top, launch, g);
  if (!parabolic_) return highest_by_steps(launch, g);
  const auto [c0, c1, c2] = heights(launch, g);
  if (c2.sign() >= 0) return highest_by_steps(launch, g);
  // Concave from frame settled() on: the vertex lies between two frames, one of which is the highest of
  // these.
  Rational below = (-c1 / (c2 * Surd(2))).floor();
  if (below < settled_) below = settled_;
  Frame best = highest_until(below, launch, g);
  if (Surd there = height(launch, g, below + 1); there > best.height) best = {below + 1, std::move(there)};
  return best;
}

/// Of the frames before the form holds, and `last`, which is the highest of those after.
Frame Flight::highest_until(const Rational& last, const Surd& launch, const Rational& g) const {
  Frame best{0, height(launch, g, 0)};
  const auto meet = [&](const Rational& n) {
    if (Surd there = height(launch, g, n); there > best.height) best = {n, std::move(there)};
  };
  const int settled = parabolic_ ? settled_ : geometric_->from;
  for (int n = 1; n < settled; ++n) meet(n);
  meet(last);
  return best;
}

Frame Flight::highest_by_steps(const Surd& launch, const Rational& g) const {
  // Binary64 decides wherever the difference is beyond its error; the other comparisons are exact.
  const double launch_near = launch.to_double(), g_near = g.to_double();
  const auto above = [&](int n, int m) {
    stepped(std::max(n, m));
    const auto [a, error_a] = steps_->near(static_cast<std::size_t>(n), launch_near, g_near);
    const auto [b, error_b] = steps_->near(static_cast<std::size_t>(m), launch_near, g_near);
    if (std::abs(a - b) > error_a + error_b) return a > b;
    return height(launch, g, n) > height(launch, g, m);
  };
  int best = 0;
  for (int n = 1; n <= kStepped; ++n) {
    if (above(n, best))
      best = n;
    else if (n > settled_ + 1 && !above(n, 0))
      return {best, height(launch, g, best)};
  }
  throw Unable("the body is not back on the ground after " + std::to_string(kStepped) +
               " frames, and the flight of " + program_.name + " has no closed form that we know");
}

}  // namespace shortfall
