// SPDX-License-Identifier: GPL-3.0-or-later
// Exact trajectories beside the same integers written out for GMP by hand, and beside rational numbers.
#include <gmpxx.h>

#include <flint/flint.h>
#include <flint/fmpq.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "analysis/floating/exact_fingerprint.hpp"
#include "analysis/floating/exact_trajectory.hpp"
#include "analysis/program/catalogue.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/peer.hpp"
#include "bench/harness/ratios.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::time_text;

namespace {

using BoostRational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using BoostOwnRational = boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type,
                                                       boost::multiprecision::et_off>;

constexpr int kSteps = 1000;

const Program& symplectic_euler() {
  static const Program program = find_integrator("symplectic-euler");
  return program;
}

NumericQuestion spring(int steps_a_second) {
  NumericQuestion q;
  q.force = force_named("spring:k=1");
  q.h = Rational(1, steps_a_second);
  q.x0 = 1;
  return q;
}

/// v -= x h, x += v h in integers: x = X / s^(2n), v = V / s^(2n - 1), s steps a second.
struct Integers {
  mpz_class x, v;
};
Integers by_hand(unsigned long s, int steps) {
  Integers z{1, 0};
  for (int n = 0; n < steps; ++n) {
    mpz_mul_ui(z.v.get_mpz_t(), z.v.get_mpz_t(), s * s);
    mpz_sub(z.v.get_mpz_t(), z.v.get_mpz_t(), z.x.get_mpz_t());
    mpz_mul_ui(z.x.get_mpz_t(), z.x.get_mpz_t(), s * s);
    mpz_add(z.x.get_mpz_t(), z.x.get_mpz_t(), z.v.get_mpz_t());
  }
  return z;
}

Rational by_hand_reduced(int s, int steps) {
  const Integers z = by_hand(static_cast<unsigned long>(s), steps);
  return Rational::parse(z.x.get_str()) / Rational(s).pow(2 * steps);
}

template <class Number>
Number in_rationals(int steps) {
  const Number h = Number(1) / 50;
  Number x = 1, v = 0;
  for (int n = 0; n < steps; ++n) {
    v -= h * x;
    x += h * v;
  }
  return x;
}

std::string in_flint(int steps) {
  fmpq_t h, x, v;
  fmpq_init(h);
  fmpq_init(x);
  fmpq_init(v);
  fmpq_set_si(h, 1, 50);
  fmpq_set_si(x, 1, 1);
  for (int n = 0; n < steps; ++n) {
    fmpq_submul(v, h, x);
    fmpq_addmul(x, h, v);
  }
  char* text = fmpq_get_str(nullptr, 10, x);
  std::string result = text;
  flint_free(text);
  fmpq_clear(h);
  fmpq_clear(x);
  fmpq_clear(v);
  return result;
}

/// Every frame's integers are made, or only the last one's.
Rational trajectory(int steps_a_second, bool every_frame) {
  ExactTrajectory at(symplectic_euler(), spring(steps_a_second));
  for (int n = 0; n < kSteps; ++n) {
    at.advance();
    if (every_frame) bench::keep(at.velocity().sign());
  }
  bench::keep(at.position().sign());
  return {};
}

/// Prints the times and their ratios to the first.
std::vector<double> table(const std::string& title, const std::vector<Contender>& contenders, int rounds,
                          double least) {
  std::printf("\n%s\n", title.c_str());
  std::vector<double> times = bench::least_times(contenders, rounds, least);
  for (std::size_t i = 0; i < contenders.size(); ++i)
    std::printf("  %-66s %9s   %9.3f\n", contenders[i].name.c_str(), time_text(times[i]).c_str(),
                times[i] / times[0]);
  std::fflush(stdout);
  return times;
}

/// The first is ours.
void note_all(const std::string& work, const std::vector<Contender>& contenders,
              const std::vector<double>& times) {
  for (std::size_t i = 1; i < contenders.size(); ++i)
    bench::note_ratio(work, contenders[i].name, times[0], times[i]);
}

void must_equal(const std::string& who, const Rational& a, const Rational& b) {
  if (a == b) return;
  std::printf("%s disagrees\n", who.c_str());
  std::exit(1);
}

void check() {
  for (const int s : {50, 64}) {
    ExactTrajectory at(symplectic_euler(), spring(s)), jumped(symplectic_euler(), spring(s));
    at.advance(kSteps);
    jumped.jump(kSteps);
    must_equal("GMP by hand", by_hand_reduced(s, kSteps), at.position().rational());
    must_equal("doubling", jumped.position().rational(), at.position().rational());
  }
  ExactTrajectory at(symplectic_euler(), spring(50));
  at.advance(100);
  const Rational x = at.position().rational();
  must_equal("Boost's mpq_rational", Rational::parse(in_rationals<BoostRational>(100).str()), x);
  must_equal("Boost's cpp_rational", Rational::parse(in_rationals<BoostOwnRational>(100).str()), x);
  must_equal("FLINT", Rational::parse(in_flint(100)), x);
}

/// The time of a step in a long run that has begun already.
void per_step(const char* what, double seconds, double steps) {
  std::printf("  %-66s %9s a step\n", what, time_text(seconds / steps).c_str());
}

}  // namespace

int main() {
  check();
  std::printf("Exact trajectories: spring k = 1, symplectic Euler, n = %d. Ratios to the first line.\n",
              kSteps);
  for (const int s : {50, 64}) {
    const std::vector<double> times =
        table("h = 1/" + std::to_string(s) + (s == 64 ? " (dyadic)" : ""),
              {here("GMP integers by hand, every frame",
                    [=] { bench::keep(by_hand(static_cast<unsigned long>(s), kSteps)); }),
               here("ExactTrajectory, x and v of every frame as integers", [=] { trajectory(s, true); }),
               here("ExactTrajectory, the last frame only, by stepping", [=] { trajectory(s, false); }),
               here("ExactTrajectory, x_n alone by squaring",
                    [=] {
                      ExactTrajectory at(symplectic_euler(), spring(s));
                      at.jump(kSteps);
                      bench::keep(at.position().sign());
                    }),
               here("ExactTrajectory, every x to 17 digits",
                    [=] {
                      ExactTrajectory at(symplectic_euler(), spring(s));
                      for (int n = 0; n < kSteps; ++n) {
                        at.advance();
                        bench::keep(at.position().significant(17));
                      }
                    }),
               here("ExactTrajectory, every x minus a binary64, as a ball of 64 bits",
                    [=] {
                      ExactTrajectory at(symplectic_euler(), spring(s));
                      double x = 1, v = 0;
                      const double h = 1.0 / s;
                      for (int n = 0; n < kSteps; ++n) {
                        v -= h * x;
                        x += h * v;
                        at.advance();
                        bench::keep(at.position().minus(Rational::from_double(x), 64));
                      }
                    }),
               here("making an ExactTrajectory (reading the step, scaling)",
                    [=] { bench::keep(ExactTrajectory(symplectic_euler(), spring(s))); })},
              24, 0.02);
    const std::string work = "exact spring, n = 1000, h = 1/" + std::to_string(s);
    bench::note_ratio(work + ", every frame", "GMP integers by hand", times[1], times[0]);
    bench::note_ratio(work + ", last frame", "GMP integers by hand", times[2], times[0]);
    bench::note_ratio(work + ", x_n alone", "GMP integers by hand", times[3], times[0]);
  }
  std::vector<Contender> rationals{
      here("ExactTrajectory, x and v of every frame as integers", [] { trajectory(50, true); }),
      here("FLINT fmpq", [] { bench::keep(in_flint(kSteps)); }),
      here("Boost mpq_rational", [] { bench::keep(in_rationals<BoostRational>(kSteps)); })};
  bench::Peer python("Python", {"/usr/bin/python3", std::string(SHORTFALL_PEERS) + "/trajectory.py"}, "", "");
  if (python.runs())
    rationals.push_back({python.name(), [&](long times) { return python.seconds(kSteps, times); }});
  const std::string work = "exact spring, n = 1000, h = 1/50, every frame";
  note_all(work, rationals, table("Rational numbers, h = 1/50, n = 1000", rationals, 3, 0.02));
  const std::vector<Contender> slow{
      here("ExactTrajectory, x and v of every frame as integers", [] { trajectory(50, true); }),
      here("Boost cpp_rational", [] { bench::keep(in_rationals<BoostOwnRational>(kSteps)); })};
  note_all(work, slow, table("Rational numbers, once", slow, 1, 0.02));

  std::printf("\nOne step\n");
  NumericQuestion gravity = spring(50);
  gravity.force = force_named("constant:a=-9.81");
  constexpr int kMany = 1'000'000;
  ExactTrajectory fall(symplectic_euler(), gravity);
  ExactFingerprint oscillation(symplectic_euler(), spring(50)), falling(symplectic_euler(), gravity);
  const auto times = bench::least_times(
      {here("", [&] { fall.advance(kMany); }), here("", [&] { oscillation.advance(kMany); }),
       here("", [&] { falling.advance(kMany); })},
      24, 0);
  per_step("gravity, exact, in words", times[0], kMany);
  per_step("spring, modulo 2^61 - 1", times[1], kMany);
  per_step("gravity, modulo 2^61 - 1", times[2], kMany);
}
