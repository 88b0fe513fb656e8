// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/closed_form.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

Numbers<Rational> constant_force(int value) {
  return {.force = [value](const Rational&, const Rational&, const Rational&) { return Rational(value); }};
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

template <class T>
T at(const std::array<T, 3>& p, const T& n) {
  return p[0] + n * (p[1] + n * p[2]);
}

}  // namespace

/// The two flights of which every other one is made, stepped in exact arithmetic as far as somebody asked.
struct Flight::Steps {
  Steps(const Program& program, const Values& parameters, const Rational& dt)
      : tape(lower(program, parameters)), free(tape, weightless, dt), dropped(tape, heavy, dt) {
    free.begin(0, 1, 0);
    dropped.begin(0, 0, 0);
    record();
  }

  const std::pair<Rational, Rational>& frame(std::size_t n) {
    while (frames.size() <= n) {
      free.step();
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
  Numbers<Rational> weightless = constant_force(0);
  Numbers<Rational> heavy = constant_force(1);
  Run<Numbers<Rational>> free;
  Run<Numbers<Rational>> dropped;
  std::vector<std::pair<Rational, Rational>> frames;  ///< rise and fall
  std::vector<std::pair<double, double>> rounded;     ///< the same
};

Flight::Flight(const Program& program, const Rational& dt, int substeps, const Values& given)
    : program_(substepped(program, substeps)),
      dt_(dt),
      substeps_(substeps),
      parameters_(parameter_values(program, given)) {
  if (dt.sign() <= 0) throw BadInput("a time step is longer than 0 s, not " + dt.str() + " s");
  // In letters where it can be done, then with numbers; each has flights that only it can solve.
  if (!adopt(lower(program_, given))) adopt(lower(program_, parameters_));
  steps_ = std::make_unique<Steps>(program_, parameters_, dt_);
}

Flight::Flight(Flight&&) noexcept = default;
Flight& Flight::operator=(Flight&&) noexcept = default;
Flight::~Flight() = default;

bool Flight::adopt(const Tape& tape) try {
  const StepMap map = step_map(tape, 0);
  const ClosedForm form = closed_form(map);
  const Sequence& rise = form.position[1];
  const Sequence& fall = form.position[2];
  if (!rise.is_polynomial() || !fall.is_polynomial()) return false;
  const auto up = parabola(rise.polynomial(), tape, parameters_, dt_);
  const auto down = parabola(fall.polynomial(), tape, parameters_, dt_);
  if (!up || !down) return false;
  rise_ = *up;
  fall_ = *down;
  settled_ = form.valid_from;
  fall_in_letters_ = fall.polynomial();
  letters_ = map.letters;
  return parabolic_ = true;
} catch (const Unable&) {
  return false;
} catch (const Undefined&) {
  return false;
}

const std::pair<Rational, Rational>& Flight::stepped(const Rational& n) const {
  std::int64_t count = 0;
  if (!n.fits_int64(count) || count < 0 || count > kStepped)
    throw Unable("the flight of " + program_.name +
                 " has no closed form that is a parabola; we step at most " + std::to_string(kStepped) +
                 " frames of it exactly, not " + n.str());
  return steps_->frame(static_cast<std::size_t>(count));
}

Rational Flight::rise(const Rational& n) const {
  return parabolic_ && n >= settled_ ? at(rise_, n) : stepped(n).first;
}

Rational Flight::fall(const Rational& n) const {
  return parabolic_ && n >= settled_ ? at(fall_, n) : stepped(n).second;
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
  if (!parabolic_) return highest_by_steps(launch, g);
  const auto [c0, c1, c2] = heights(launch, g);
  if (c2.sign() >= 0) return highest_by_steps(launch, g);
  // Concave from frame settled() on: the vertex lies between two frames, one of which is the highest of
  // these.
  Rational below = (-c1 / (c2 * Surd(2))).floor();
  if (below < settled_) below = settled_;
  Frame best{0, height(launch, g, 0)};
  const auto meet = [&](const Rational& n) {
    if (Surd there = height(launch, g, n); there > best.height) best = {n, std::move(there)};
  };
  for (int n = 1; n < settled_; ++n) meet(n);
  meet(below);
  meet(below + 1);
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
               " frames, and the flight of " + program_.name + " has no closed form that is a parabola");
}

}  // namespace shortfall
