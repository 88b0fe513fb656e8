// SPDX-License-Identifier: GPL-3.0-or-later
// How time and memory grow: the same work at several sizes, and the power (or the factor) that fits best.
#include <gsl/gsl_fit.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "analysis/algebra/tree_series.hpp"
#include "analysis/floating/accumulator.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/floating/exact_trajectory.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/motion/faulhaber.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/series/modifying.hpp"
#include "bench/harness/heap.hpp"
#include "bench/harness/interleaved.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::time_text;

namespace {

constexpr int kRounds = 10;

struct Law {
  std::string what;
  std::string size;  ///< what is doubled: "n", "digits"
  std::vector<int> sizes;
  std::function<void(int)> work;
  bool exponential = false;  ///< a factor for every unit of the size instead of a power of it
};

/// Least squares of log y over log size, or over size.
struct Fit {
  double slope, deviation;  ///< and its standard deviation
};
Fit fitted(const Law& law, const std::vector<double>& y) {
  std::vector<double> at, logs;
  for (std::size_t i = 0; i < y.size(); ++i) {
    at.push_back(law.exponential ? law.sizes[i] : std::log(law.sizes[i]));
    logs.push_back(std::log(y[i]));
  }
  double c0, c1, cov00, cov01, cov11, sum;
  gsl_fit_linear(at.data(), 1, logs.data(), 1, y.size(), &c0, &c1, &cov00, &cov01, &cov11, &sum);
  return {c1, std::sqrt(cov11)};
}

std::string text(const Law& law, const Fit& fit) {
  char line[80];
  if (law.exponential)
    std::snprintf(line, sizeof line, "%.2f^%s +- %.2f", std::exp(fit.slope), law.size.c_str(),
                  std::exp(fit.slope) * fit.deviation);
  else
    std::snprintf(line, sizeof line, "%s^%.2f +- %.2f", law.size.c_str(), fit.slope, fit.deviation);
  return line;
}

std::string bytes_text(double bytes) {
  char line[40];
  if (bytes < 1e4)
    std::snprintf(line, sizeof line, "%.0f B", bytes);
  else
    std::snprintf(line, sizeof line, "%.3g %s", bytes < 1e6 ? bytes / 1e3 : bytes / 1e6,
                  bytes < 1e6 ? "kB" : "MB");
  return line;
}

void measure(const Law& law) {
  std::vector<Contender> sizes;
  std::vector<double> memory;
  for (const int size : law.sizes) {
    memory.push_back(bench::peak_heap([&] { law.work(size); }));
    sizes.push_back(here("", [&law, size] { law.work(size); }));
  }
  const std::vector<double> times = bench::least_times(sizes, kRounds, 0.005);
  std::printf("  %-44s %s = %d to %d\n", law.what.c_str(), law.size.c_str(), law.sizes.front(),
              law.sizes.back());
  std::printf("    time   %-24s %9s to %9s\n", text(law, fitted(law, times)).c_str(),
              time_text(times.front()).c_str(), time_text(times.back()).c_str());
  std::printf("    memory %-24s %9s to %9s\n", text(law, fitted(law, memory)).c_str(),
              bytes_text(memory.front()).c_str(), bytes_text(memory.back()).c_str());
  std::fflush(stdout);
}

const Program& symplectic_euler() {
  static const Program program = find_integrator("symplectic-euler");
  return program;
}

NumericQuestion spring() {
  NumericQuestion q;
  q.force = force_named("spring:k=1");
  q.h = Rational(1, 50);
  q.x0 = 1;
  return q;
}

FloatQuestion float_spring() {
  FloatQuestion q;
  q.program = symplectic_euler();
  q.force = force_named("spring:k=1");
  q.h = Rational(1, 50);
  q.x0 = 1;
  return q;
}

void every_frame(int n) {
  ExactTrajectory at(symplectic_euler(), spring());
  for (int i = 0; i < n; ++i) {
    at.advance();
    bench::keep(at.velocity().sign());
  }
}

void one_frame(int n) {
  ExactTrajectory at(symplectic_euler(), spring());
  at.jump(n);
  bench::keep(at.position().sign());
}

void modified_equation(int order) {
  const ButcherTableau<Rational> midpoint{{{0, 0}, {Rational(1, 2), 0}}, {0, 1}, {0, Rational(1, 2)}, {}};
  const TreeTable table(Signature::first_order(), order);
  bench::keep(logarithm(table, ElementaryWeights<Rational>(midpoint, table).result(midpoint.b)));
}

void thousand_steps(int digits) {
  const std::shared_ptr<FloatRun> run =
      float_run(float_format("mpfr:" + std::to_string(digits)), float_spring());
  for (int n = 0; n < 1000; ++n) run->step();
  bench::keep(run->rough());
}

void clock(int exponent) {
  const Accumulator t{BinaryFormat::binary32(), Rounding::nearest_even, 0, Rational::from_double(0.1F)};
  bench::keep(accumulated(t, Rational(2).pow(exponent)));
}

void far_spring(int exponent) {
  NumericQuestion q = spring();
  q.steps = Rational(10).pow(exponent);
  bench::keep(numeric_motion(symplectic_euler(), q));
}

std::vector<Law> laws() {
  return {
      {"sums of powers of degree 1 to d", "d", {32, 64, 128, 256}, [](int d) { bench::keep(power_sums(d)); }},
      {"n-step map of symplectic Euler under poly:d",
       "d",
       {5, 10, 20, 40},
       [](int d) { bench::keep(closed_form(step_map(lower(symplectic_euler()), d))); }},
      {"derivation and proof, rk4 under poly:d",
       "d",
       {4, 8, 16, 32},
       [](int d) { bench::keep(derivation(find_integrator("rk4"), d)); }},
      {"exact spring, x and v of every frame", "n", {2000, 4000, 8000, 16000}, every_frame},
      {"exact spring, x_n alone by doubling", "n", {4000, 16000, 64000, 256000}, one_frame},
      {"x_n, v_n of a spring to 50 digits, n = 10^e", "e", {4, 8, 16, 32, 64}, far_spring},
      {"modified equation with its trees, order p", "p", {6, 7, 8, 9, 10, 11, 12}, modified_equation, true},
      {"1000 steps in MPFR of d digits", "d", {250, 1000, 4000, 16000}, thousand_steps},
      {"budget of n steps in binary32",
       "n",
       {20'000, 80'000, 320'000, 1'280'000},
       [](int n) { bench::keep(budget(float_format("f32"), float_spring(), n)); }},
      {"clock of binary32 after 2^e additions", "e", {8, 16, 32, 64}, clock},
  };
}

}  // namespace

int main() {
  std::printf(
      "The power of the size that fits best (least squares of logarithms, with its standard deviation);\n"
      "processor time, least of %d turns; memory: the most on the heap at a time\n",
      kRounds);
  for (const Law& law : laws()) measure(law);
}
