// SPDX-License-Identifier: GPL-3.0-or-later
// A step run in the formats, beside the same step written out by hand: a spring by symplectic Euler.
#include <mpfr.h>
#include <quadmath.h>

#include <cstdio>
#include <vector>

#include "analysis/floating/accumulator.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/floating/tracked.hpp"
#include "analysis/program/catalogue.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/ratios.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::time_text;

namespace {

constexpr int kRounds = 12;
constexpr int kSteps = 1000;

FloatQuestion spring() {
  FloatQuestion q;
  q.program = find_integrator("symplectic-euler");
  q.force = force_named("spring:k=1");
  q.h = Rational(1, 50);
  q.x0 = 1;
  return q;
}

Contender ours(const char* format, const char* name = "interpreted") {
  const std::shared_ptr<FloatRun> run = float_run(float_format(format), spring());
  return here(name, [run] {
    run->begin();
    for (int n = 0; n < kSteps; ++n) run->step();
    bench::keep(run->rough());
  });
}

/// The step as the file has it, in native code; T may be a number that tracks its error.
template <class T, class Native>
[[gnu::always_inline]] inline void steps_by_hand() {
  volatile Native start = 1;
  const Native h = start / Native(50), k = start;  // they have no error
  T x(start), v(start - 1);
  for (int n = 0; n < kSteps; ++n) {
    v = v + h * -(k * x);
    x = x + h * v;
  }
  bench::keep(x);
}

template <class T>
Contender by_hand() {
  return here("a loop by hand", [] { steps_by_hand<T, T>(); });
}

// Fused multiply-adds as instructions, as a program has that wants them; both are compiled alike.
#if defined(__x86_64__)
#define SHORTFALL_WITH_FMA [[gnu::target("fma,avx2")]]
bool has_fma() { return __builtin_cpu_supports("fma") != 0 && __builtin_cpu_supports("avx2") != 0; }
#else
#define SHORTFALL_WITH_FMA
bool has_fma() { return true; }
#endif
SHORTFALL_WITH_FMA void plain_steps() { steps_by_hand<double, double>(); }
SHORTFALL_WITH_FMA void tracked_steps() { steps_by_hand<Tracked<double>, double>(); }

Contender tracked(const char* format) {
  const std::shared_ptr<FloatRun> run = tracked_run(float_format(format), spring());
  return here(format, [run] {
    run->begin();
    for (int n = 0; n < kSteps; ++n) run->step();
    bench::keep(run->rough());
  });
}

/// MPFR as a careful user writes it, in place.
Contender raw_mpfr(int digits, int steps = kSteps) {
  return here("raw MPFR, in place", [digits, steps] {
    const mpfr_prec_t bits = static_cast<mpfr_prec_t>(digits) * 1000 / 301 + 2;
    mpfr_t x, v, h, k, t;
    for (mpfr_ptr p : {x, v, h, k, t}) mpfr_init2(p, bits);
    mpfr_set_si(x, 1, MPFR_RNDN);
    mpfr_set_si(v, 0, MPFR_RNDN);
    mpfr_set_si(k, 1, MPFR_RNDN);
    mpfr_set_si(h, 1, MPFR_RNDN);
    mpfr_div_si(h, h, 50, MPFR_RNDN);
    for (int n = 0; n < steps; ++n) {
      mpfr_mul(t, k, x, MPFR_RNDN);
      mpfr_neg(t, t, MPFR_RNDN);
      mpfr_mul(t, h, t, MPFR_RNDN);
      mpfr_add(v, v, t, MPFR_RNDN);
      mpfr_mul(t, h, v, MPFR_RNDN);
      mpfr_add(x, x, t, MPFR_RNDN);
    }
    bench::keep(mpfr_get_d(x, MPFR_RNDN));
    for (mpfr_ptr p : {x, v, h, k, t}) mpfr_clear(p);
  });
}

void compare(const char* what, const std::vector<Contender>& pair, const char* beside = "by hand") {
  const std::vector<double> times = bench::least_times(pair, kRounds, 0.01);
  std::printf("  %-34s %9s a step, %s %9s: %.2f times\n", what, time_text(times[0] / kSteps).c_str(), beside,
              time_text(times[1] / kSteps).c_str(), times[0] / times[1]);
  std::fflush(stdout);
  bench::note_ratio(std::string(what) + ", a spring by symplectic Euler, 1000 steps", pair[1].name, times[0],
                    times[1]);
}

/// All four parts of an error, beside the one number that a run at 60 digits gives by hand.
void budgets() {
  constexpr int kMany = 10'000;
  std::printf("Budgets of %d steps, all parts to 60 digits, beside MPFR's trajectory at 60 digits\n", kMany);
  const FloatQuestion q = spring();
  for (const char* format : {"f32", "f64"}) {
    const std::vector<Contender> both{here("", [&] { bench::keep(budget(float_format(format), q, kMany)); }),
                                      raw_mpfr(60, kMany)};
    const std::vector<double> times = bench::least_times(both, kRounds, 0.01);
    std::printf("  %-34s %9s, MPFR alone %9s: %.2f times\n", format, time_text(times[0]).c_str(),
                time_text(times[1]).c_str(), times[0] / times[1]);
    bench::note_ratio(std::string("budget of 10,000 steps in ") + format, "raw MPFR's trajectory, 60 digits",
                      times[0], times[1]);
  }
}

void clocks() {
  constexpr long kAdditions = 1'000'000;
  std::printf("t += 0.1f, %ld times\n", kAdditions);
  const BinaryFormat single = BinaryFormat::binary32();
  const Accumulator clock{single, Rounding::nearest_even, 0, Rational::from_double(0.1F)};
  const std::vector<double> times = bench::least_times(
      {here("", [&] { bench::keep(accumulated(clock, kAdditions)); }), here("",
                                                                            [] {
                                                                              volatile float dt = 0.1F;
                                                                              float t = 0;
                                                                              for (long n = 0; n < kAdditions;
                                                                                   ++n)
                                                                                t += dt;
                                                                              bench::keep(t);
                                                                            })},
      kRounds, 0.005);
  std::printf("  in closed form %9s, by additions %9s: %.4f times\n", time_text(times[0]).c_str(),
              time_text(times[1]).c_str(), times[0] / times[1]);
  bench::note_ratio("t += 0.1f, 1,000,000 times", "a loop by hand", times[0], times[1]);
}

}  // namespace

int main() {
  std::printf(
      "A spring by symplectic Euler, h = 1/50, %d steps: the interpreted file beside the same by hand\n",
      kSteps);
  compare("binary32", {ours("f32"), by_hand<float>()});
  compare("binary64", {ours("f64"), by_hand<double>()});
  compare("x87", {ours("x87"), by_hand<long double>()});
  compare("binary128", {ours("f128"), by_hand<__float128>()});
  compare("MPFR, 50 digits", {ours("mpfr:50"), raw_mpfr(50)});
  compare("MPFR, 1000 digits", {ours("mpfr:1000"), raw_mpfr(1000)});
  std::printf(
      "The same with its accumulated rounding error tracked beside it, the trajectory bit for bit the "
      "same\n");
  if (has_fma())
    compare("binary64, native and tracked",
            {here("", tracked_steps), here("the same without tracking", plain_steps)}, "plain");
  compare("binary64, interpreted and tracked", {tracked("f64"), ours("f64", "the same without tracking")},
          "plain");
  compare("binary32, interpreted and tracked", {tracked("f32"), ours("f32", "the same without tracking")},
          "plain");
  budgets();
  clocks();
  return 0;
}
