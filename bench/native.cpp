// SPDX-License-Identifier: GPL-3.0-or-later
// Written classes beside loops by hand, Boost.odeint and GSL: a spring in binary64; and many springs at once.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "analysis/native/native_many.hpp"
#include "analysis/program/catalogue.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/ratios.hpp"
#include "bench/native/spring_lanes.hpp"
#include "native/rk4.hpp"
#include "native/symplectic-euler.hpp"
#include "native/velocity-verlet.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::Spring;
using bench::time_text;

namespace {

constexpr int kRounds = 60;
constexpr double kTurn = 0.004;  // short turns are seldom interrupted
constexpr std::int64_t kSteps = 10'000;

volatile double spring_constant = 1.7, time_step = 0.01, start_x = 1, start_v = 0.25;

using State = std::pair<double, double>;

template <template <class, class, class> class Class>
State written() {
  using Stepper = Class<double, double, Spring>;
  const auto number = [](const char* text) { return Rational::parse(text).to_double(); };
  const double h = time_step, zero = 0;
  static Stepper stepper(h, zero, Spring{spring_constant}, number, typename Stepper::Parameters(number));
  const double x = start_x, v = start_v;
  stepper.begin(x, v, zero);
  stepper.run(kSteps);
  return stepper.read_out();
}

State by_reference(NativeRun<double>& run) {
  double x = start_x, v = start_v;
  run.begin({&x, 1}, {&v, 1}, 0);
  run.run(kSteps);
  run.read_out({&x, 1}, {&v, 1});
  return {x, v};
}

// By hand: the same operations in the same order, and the same trajectory to the last bit.

State euler_by_hand() {
  const double k = spring_constant, h = time_step;
  double x = start_x, v = start_v;
  for (std::int64_t n = 0; n < kSteps; ++n) {
    v += h * -(k * x);
    x += h * v;
  }
  return {x, v};
}

State verlet_by_hand() {
  const double k = spring_constant, h = time_step, half = h / 2, square = h * h / 2;
  double x = start_x, v = start_v, a = -(k * x);
  for (std::int64_t n = 0; n < kSteps; ++n) {
    x = x + h * v + square * a;
    const double next = -(k * x);
    v += half * (a + next);
    a = next;
  }
  return {x, v};
}

State rk4_by_hand() {
  const double k = spring_constant, h = time_step, sixth = 1.0 / 6, third = 1.0 / 3;
  double x = start_x, v = start_v;
  for (std::int64_t n = 0; n < kSteps; ++n) {
    const double a1 = -(k * x);
    const double v2 = v + h * (0.5 * a1);
    const double a2 = -(k * (x + h * (0.5 * v)));
    const double v3 = v + h * (0.5 * a2);
    const double a3 = -(k * (x + h * (0.5 * v2)));
    const double v4 = v + h * a3;
    const double a4 = -(k * (x + h * v3));
    x += h * (sixth * v + third * v2 + third * v3 + sixth * v4);
    v += h * (sixth * a1 + third * a2 + third * a3 + sixth * a4);
  }
  return {x, v};
}

// Boost.odeint, as its documentation uses it.

namespace odeint = boost::numeric::odeint;
using One = std::array<double, 1>;
using Two = std::array<double, 2>;

State euler_by_odeint() {
  odeint::symplectic_euler<One> stepper;
  const double k = spring_constant, h = time_step;
  const auto drift = [](const One& p, One& dq) { dq[0] = p[0]; };
  const auto kick = [k](const One& q, One& dp) { dp[0] = -(k * q[0]); };
  std::pair<One, One> state{{start_x}, {start_v}};
  for (std::int64_t n = 0; n < kSteps; ++n)
    stepper.do_step(std::make_pair(drift, kick), state, static_cast<double>(n) * h, h);
  return {state.first[0], state.second[0]};
}

State verlet_by_odeint() {
  odeint::velocity_verlet<One> stepper;
  const double k = spring_constant, h = time_step;
  const auto force = [k](const One& x, const One&, One& a, double) { a[0] = -(k * x[0]); };
  std::pair<One, One> state{{start_x}, {start_v}};
  for (std::int64_t n = 0; n < kSteps; ++n) stepper.do_step(force, state, static_cast<double>(n) * h, h);
  return {state.first[0], state.second[0]};
}

State rk4_by_odeint() {
  odeint::runge_kutta4<Two> stepper;
  const double k = spring_constant, h = time_step;
  const auto system = [k](const Two& y, Two& dy, double) {
    dy[0] = y[1];
    dy[1] = -(k * y[0]);
  };
  Two y{start_x, start_v};
  for (std::int64_t n = 0; n < kSteps; ++n) stepper.do_step(system, y, static_cast<double>(n) * h, h);
  return {y[0], y[1]};
}

int spring_for_gsl(double, const double y[], double dy[], void* k) {
  dy[0] = y[1];
  dy[1] = -(*static_cast<double*>(k) * y[0]);
  return GSL_SUCCESS;
}

/// GSL's rk4 makes each step twice: whole for its error estimate, and as two halves, which are its result. So
/// half as many steps of 2 h are the same trajectory.
State rk4_by_gsl() {
  double k = spring_constant;
  const double h = 2 * time_step;
  gsl_odeiv2_system system{spring_for_gsl, nullptr, 2, &k};
  static gsl_odeiv2_step* const step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, 2);
  gsl_odeiv2_step_reset(step);
  double y[2] = {start_x, start_v}, error[2];
  for (std::int64_t n = 0; n < kSteps / 2; ++n)
    gsl_odeiv2_step_apply(step, static_cast<double>(n) * h, h, y, error, nullptr, nullptr, &system);
  return {y[0], y[1]};
}

int wrong = 0;

/// The same trajectory up to rounding, or the comparison means nothing.
void check(const char* what, const State& ours, const State& theirs, double tolerance) {
  const double apart = std::abs(ours.first - theirs.first) + std::abs(ours.second - theirs.second);
  if (apart <= tolerance) return;
  std::printf("  %s: THE TRAJECTORIES DIFFER by %g\n", what, apart);
  ++wrong;
}

Contender stepping(State (*run)()) {
  return here("", [run] { bench::keep(run()); });
}

void row(const char* what, double theirs, double ours, const char* target, bool met) {
  std::printf("  %-46s %9s a step, times the written class's: %5.2f   %s%s\n", what,
              time_text(theirs / static_cast<double>(kSteps)).c_str(), theirs / ours, target,
              *target == 0 ? ""
              : met        ? "   met"
                           : "   MISSED");
  std::fflush(stdout);
}

void one_spring(const char* name, State (*ours)(), State (*hand)(), State (*odeint_run)(), double apart,
                State (*gsl)()) {
  const double x0 = start_x;
  const double k = spring_constant;
  const auto force = [k](std::span<const double> x, std::span<const double>, double, std::span<double> a) {
    a[0] = -(k * x[0]);
  };
  const auto run = native_run<double>(find_integrator(name), {}, time_step, 1, force);
  check("by hand", ours(), hand(), 0);
  check("by reference", ours(), by_reference(*run), 0);
  check("Boost.odeint", ours(), odeint_run(), apart * std::abs(x0));
  std::vector<Contender> all{stepping(ours), stepping(hand), stepping(odeint_run),
                             here("", [&run] { bench::keep(by_reference(*run)); })};
  if (gsl) {
    check("GSL", ours(), gsl(), 1e-11);
    all.push_back(stepping(gsl));
  }
  const std::vector<double> t = bench::least_times(all, kRounds, kTurn);
  std::printf("%s\n", name);
  row("the written class, force compiled in", t[0], t[0], "", true);
  row("a loop by hand", t[1], t[0], "target: class / hand at most 1.05", t[0] <= 1.05 * t[1]);
  row("Boost.odeint", t[2], t[0], "target 1.00", t[2] >= t[0]);
  row("native_run, force by reference", t[3], t[0], "", true);
  const std::string work = std::string(name) + ", a spring in binary64, 10,000 steps";
  bench::note_ratio(work, "a loop by hand", t[0], t[1]);
  bench::note_ratio(work, "Boost.odeint", t[0], t[2]);
  bench::note_ratio(work + ", force by reference", "a loop by hand", t[3], t[1]);
  if (gsl) bench::note_ratio(work, "GSL's rk4", t[0], t[4]);
  if (gsl) row("GSL's rk4, two of our steps in one of its", t[4], t[0], "target 8.00", t[4] >= 8 * t[0]);
}

void many_springs() {
  constexpr std::size_t kCount = 10'000;
  constexpr std::int64_t kShort = 1000;
  const double k = spring_constant, h = time_step;
  const Program program = find_integrator("symplectic-euler");
  const auto starts = [](double scale) {
    std::vector<double> s(kCount);
    for (std::size_t i = 0; i < kCount; ++i) s[i] = scale * std::sin(static_cast<double>(i + 1));
    return s;
  };
  const std::vector<double> x0 = starts(1), v0 = starts(0.3);
  std::vector<double> x(kCount), v(kCount), sx, sv;
  const auto force = [k](std::span<const double> p, std::span<const double>, double, std::span<double> a) {
    for (std::size_t i = 0; i < p.size(); ++i) a[i] = -(k * p[i]);
  };
  const auto scalar = [&] {
    for (std::size_t i = 0; i < kCount; ++i) {
      double p = x0[i], u = v0[i];
      for (std::int64_t n = 0; n < kShort; ++n) {
        u += h * -(k * p);
        p += h * u;
      }
      x[i] = p;
      v[i] = u;
    }
    bench::keep(x.back());
  };
  const auto begun = [&](auto&& work) {
    return [&, work] {
      x = x0;
      v = v0;
      work();
      bench::keep(x.back());
    };
  };
  const auto lanes = begun([&] { bench::spring_lanes(x, v, k, h, kShort); });
  const auto door = begun([&] { native_many<double>(program, {}, h, force, x, v, 0, kShort); });
  const auto alone =
      begun([&] { native_many<double>(program, {}, h, force, x, v, 0, kShort, NativeLanes::never); });
  scalar();
  sx = x;
  sv = v;
  std::printf("%zu springs, %lld steps each, symplectic Euler\n", kCount, static_cast<long long>(kShort));
  const bool has = has_lanes(program);
  if (!has) std::printf("  this processor has no AVX2\n");
  std::vector<Contender> all{here("", scalar), here("", alone), here("", door)};
  if (has) all.push_back(here("", lanes));
  for (const auto& work : {std::function<void()>(alone), std::function<void()>(door)}) {
    work();
    if (x != sx || v != sv) std::printf("  THE BITS DIFFER\n"), ++wrong;
  }
  if (has) {
    lanes();
    if (x != sx || v != sv) std::printf("  THE BITS DIFFER\n"), ++wrong;
  }
  const std::vector<double> t = bench::least_times(all, 10, 0);
  const auto print = [&](const char* what, double time, const char* target, bool met) {
    std::printf("  %-46s %9s a step of one, scalar loop / it: %5.2f   %s%s\n", what,
                time_text(time / static_cast<double>(kCount * kShort)).c_str(), t[0] / time, target,
                *target == 0 ? ""
                : met        ? "   met"
                             : "   MISSED");
  };
  print("a scalar loop by hand, one after the other", t[0], "", true);
  print("native_many one by one, force by reference", t[1], "", true);
  print("native_many in lanes, force by reference", t[2], "", true);
  if (has) print("lanes, force compiled in", t[3], "target 10.00", t[0] >= 10 * t[3]);
  const std::string work = "10,000 springs, 1000 steps of symplectic Euler";
  bench::note_ratio(work + ", one by one, force by reference", "a scalar loop by hand", t[1], t[0]);
  bench::note_ratio(work + ", in lanes, force by reference", "a scalar loop by hand", t[2], t[0]);
  if (has) bench::note_ratio(work + ", in lanes", "a scalar loop by hand", t[3], t[0]);
}

}  // namespace

int main() {
  std::printf("A spring in binary64, %lld steps\n", static_cast<long long>(kSteps));
  // odeint's symplectic Euler drifts first, which is another trajectory: as far apart as one step.
  one_spring("symplectic-euler", written<native::SymplecticEuler>, euler_by_hand, euler_by_odeint, 0.05,
             nullptr);
  one_spring("velocity-verlet", written<native::VelocityVerlet>, verlet_by_hand, verlet_by_odeint, 1e-10,
             nullptr);
  one_spring("rk4", written<native::Rk4>, rk4_by_hand, rk4_by_odeint, 1e-10, rk4_by_gsl);
  many_springs();
  return wrong == 0 ? 0 : 1;
}
