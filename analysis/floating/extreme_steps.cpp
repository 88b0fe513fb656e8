// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/floating/extremes.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/stability/stability.hpp"

namespace shortfall {

namespace {

constexpr int kDigits = 30;

class Cases {
 public:
  Cases(const FloatFormat& format, const Program& program, const Values& parameters)
      : format_(format), storage_(format.storage()) {
    plain_.program = program;
    plain_.parameters = parameters;
  }

  std::vector<ExtremeCase> operator()() {
    for (const auto& one : std::vector<std::function<void()>>{
             [&] { far_from_the_origin(); }, [&] { falling_far_away(); }, [&] { at_the_limit(); },
             [&] { blow_up(); }, [&] { damping(); }, [&] { subnormal(); }, [&] { heights(); },
             [&] { ends_of_the_step(); }})
      try {
        one();
      } catch (const Error&) {  // the integrator cannot be asked this
      }
    return std::move(cases_);
  }

 private:
  FloatQuestion question(const std::string& force, const Rational& h, const Rational& x0,
                         const Rational& v0) const {
    FloatQuestion q = plain_;
    q.force = force_named(force);
    q.h = h;
    q.x0 = x0;
    q.v0 = v0;
    return q;
  }

  /// x after so many steps, by the run; the exact map of what was meant.
  struct Ends {
    FloatNumber run;
    Ball map;
  };
  Ends ends(const FloatQuestion& q, std::int64_t steps) const {
    const auto run = float_run(format_, q);
    for (std::int64_t n = 0; n < steps; ++n) run->step();
    NumericQuestion n;
    n.force = q.force;
    n.parameters = q.parameters;
    n.h = q.h;
    n.x0 = q.x0;
    n.v0 = q.v0;
    n.steps = Rational(steps);
    n.digits = kDigits;
    return {run->state().first, numeric_motion(q.program, n).position.ball};
  }

  /// The case's answer is what x has moved by.
  void add_move(ExtremeCase c, const FloatQuestion& q, std::int64_t steps, const std::string& unit) {
    const Ends e = ends(q, steps);
    const Ball exact = e.map - Ball(q.x0, 400);
    c.exact = exact.significant(8).value_or("0") + unit;
    c.computed = e.run.is_finite() ? (e.run.value - q.x0).significant(8) + unit : e.run.str(6);
    c.lost = !e.run.is_finite() || std::abs((Ball(e.run.value - q.x0, 400) - exact).to_double()) >
                                       0.1 * std::abs(exact.to_double());
    cases_.push_back(std::move(c));
  }

  /// 2^precision: where neighbours are 2 apart.
  Rational far() const { return power_of_two(std::min<long>(storage_.precision, storage_.greatest_bit)); }

  void far_from_the_origin() {
    add_move(
        {"standing still",
         "1 m/s for 1 s in steps of 1/64 s, from x = 2^" + std::to_string(leading_bit(far())), "", "",
         "a step moves by 1/64 m, less than half the distance of neighbours there: x stays where it is; keep "
         "positions near 0 (+origin), or add them up elsewhere",
         false},
        question("constant:a=0", Rational(1, 64), far(), 1), 64, " m moved");
  }

  void falling_far_away() {
    const Rational x = far() / Rational(256);
    add_move(
        {"gravity in quanta",
         "falling for 1/2 s at 9.81 m/s^2, h = 1/64 s, from rest at x = 2^" + std::to_string(leading_bit(x)),
         "", "", "a step changes x by h^2 g = 2.4 mm at first, and neighbours are 1/128 m apart", false},
        question("constant:a=-9.81", Rational(1, 64), x, 0), 32, " m fallen");
  }

  void at_the_limit() {
    const auto limit = stability_limit(plain_.program, plain_.parameters);
    if (!limit || !limit->is_rational()) return;
    const Rational z = limit->rational();
    if (z.is_zero()) return;
    const auto nearest = rounded(z, storage_);
    if (!nearest) return;
    const Rational power = power_of_two(leading_bit(*nearest));
    const Rational above = power * power_of_two(1 - storage_.precision);
    const Rational below = *nearest == power ? above / Rational(2) : above;  // numbers are denser below it
    for (const auto& [words, h] :
         {std::pair{*nearest == z ? "exactly" : "rounded", *nearest},
          std::pair{"one unit below", *nearest - below}, std::pair{"one unit above", *nearest + above}}) {
      const auto kept = rounded(h, storage_);
      if (!kept) continue;
      FloatQuestion q = question("spring:k=1", *kept, 1, Rational(1, 2));
      const Ends e = ends(q, 1000);
      ExtremeCase c{"at the limit",
                    "spring with h w = " + z.str() + " " + words + ", 1000 steps from x = 1, v = 1/2",
                    e.map.significant(8).value_or("0") + " m",
                    e.run.str(8) + (e.run.is_finite() ? " m" : ""),
                    "at the limit itself two eigenvalues meet at -1: what happens there depends on the "
                    "method (shortfall "
                    "stability), and one unit of h decides it",
                    !e.run.is_finite()};
      cases_.push_back(std::move(c));
    }
  }

  void blow_up() {
    FloatQuestion q = question("spring:k=1", 4, 1, 0);
    const auto run = float_run(format_, q);
    std::int64_t infinite = 0, nothing = 0;
    const std::int64_t kMost = format_.kind == FloatFormat::Kind::mpfr ? 2000 : 60'000;
    double largest = 0;
    for (std::int64_t n = 1; n <= kMost && nothing == 0; ++n) {
      run->step();
      const auto [x, v] = run->state();
      if (x.is_finite()) largest = std::max(largest, std::abs(x.value.to_double()));
      if (infinite == 0 && (!x.is_finite() || !v.is_finite())) infinite = n;
      if (n == 300 && infinite == 0 && largest < 1e3) return;  // it is stable there
      if (x.kind == FloatNumber::Kind::not_a_number || v.kind == FloatNumber::Kind::not_a_number) nothing = n;
    }
    cases_.push_back(
        {"blowing up", "spring with h w = 4, from x = 1", "grows by a factor in every step, for ever",
         infinite == 0 ? "finite for " + std::to_string(kMost) + " steps"
                       : "the first infinite number in step " + std::to_string(infinite) +
                             (nothing > 0 ? ", NaN from step " + std::to_string(nothing) : ", no NaN"),
         "infinity minus infinity is no number, and nothing that touches it ever is again; h w must stay "
         "below the "
         "limit (shortfall stability)",
         infinite != 0});
  }

  void damping() {
    for (const auto& [c, words] : {std::pair{1, "1"}, std::pair{2, "2"}, std::pair{3, "3"}}) {
      FloatQuestion q = question("drag:a=0,c=" + std::to_string(c), 1, 0, 1);
      const auto run = float_run(format_, q);
      for (int n = 0; n < 100; ++n) run->step();
      const FloatNumber v = run->state().second;
      const Ball truth = exp(-Ball(Rational(100 * c), 400));
      cases_.push_back(
          {"strong damping", std::string("v' = -c v with c h = ") + words + ", 100 steps from v = 1",
           truth.significant(6).value_or("0") + " m/s", v.str(6) + (v.is_finite() ? " m/s" : ""),
           "symplectic Euler multiplies v by 1 - c h: 0 at c h = 1, back and forth for ever at 2, growing "
           "beyond; other explicit steps fail near there, too",
           !v.is_finite() || v.value.abs() > Rational(1, 2)});
    }
  }

  void subnormal() {
    // Half a kick and a half back is all that is left of it: a tiny oscillation.
    const Rational tiny = storage_.least_unit < -100'000 ? Rational() : storage_.smallest() * Rational(8);
    if (tiny.is_zero()) return;
    FloatQuestion q = question("spring:k=1", Rational(1, 8), tiny, 0);
    const auto run = float_run(format_, q);
    Rational largest;
    for (int n = 0; n < 200; ++n) {
      run->step();
      const FloatNumber x = run->state().first;
      if (n >= 150 && x.is_finite()) largest = std::max(largest, x.value.abs());
    }
    cases_.push_back(
        {"subnormal numbers", "a spring that swings by 8 times the smallest number, 200 steps of h w = 1/8",
         "swings on by about 8 units",
         "the last swing reaches " + (largest / storage_.smallest()).str() + " units",
         "down there numbers have three bits left, and products with h are rounded to 0 or 1 unit",
         largest.is_zero()});
  }

  void heights() {
    // With h in proportion to the time of flight the exact map scales with the height: one is computed.
    const FloatQuestion one = question("constant:a=-10", Rational(1, 100), 0, 5);
    const Ball ratio = ends(one, 50).map / Ball(Rational(5, 4), 400);
    for (const int exponent : {-300, -150, 0, 150, 300}) {
      const Rational height = Rational(10).pow(exponent), g(10);
      // A flight of 100 steps: h from v0 = g T / 2, H = g T^2 / 8.
      const Rational time =
          Rational::parse(Surd::sqrt(Rational(8) * height / g).approximation(400).significant(40));
      FloatQuestion q = question("constant:a=-10", time / Rational(100), 0, g * time / Rational(2));
      const auto run = float_run(format_, q);
      Rational best;
      bool finite = true;
      for (int n = 0; n < 60; ++n) {
        run->step();
        const FloatNumber x = run->state().first;
        finite = finite && x.is_finite();
        if (x.is_finite()) best = std::max(best, x.value);
      }
      ExtremeCase c{
          "sizes",
          "a jump of 1e" + std::to_string(exponent) + " m in 100 steps: the highest frame over the height",
          ratio.significant(8).value_or("0"),
          finite ? (best / height).significant(8) : "not finite",
          "nothing but the size changes: as long as all numbers on the way, h^2 g too, are normal ones, the "
          "answer "
          "is the same",
          !finite || std::abs((best / height).to_double() - ratio.to_double()) > 0.1};
      cases_.push_back(std::move(c));
    }
  }

  void ends_of_the_step() {
    if (storage_.least_unit < -100'000) return;
    add_move({"the smallest step", "1 m/s for 64 steps of the smallest number, from x = 0", "", "",
              "exact: multiples of the smallest number", false},
             question("constant:a=0", storage_.smallest(), 0, 1), 64, " m moved");
    add_move(
        {"the largest step", "1 m/s for one step of the largest number, from x = 0", "", "",
         "products with h^2 are infinite there, even for a force of 0: infinity times 0 is no number", false},
        question("constant:a=0", storage_.largest(), 0, 1), 1, " m moved");
  }

  FloatFormat format_;
  BinaryFormat storage_;
  FloatQuestion plain_;
  std::vector<ExtremeCase> cases_;
};

}  // namespace

std::vector<ExtremeCase> extreme_steps(const FloatFormat& format, const Program& program,
                                       const Values& parameters) {
  return Cases(format, program, parameters)();
}

}  // namespace shortfall
