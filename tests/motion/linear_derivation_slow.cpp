// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/linear_derivation.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

TEST_CASE("closed forms of the catalogue equal 200 exact steps, springs, dampers and forces of time") {
  // A large prime would do for a check; here the numbers are short enough to be exact.
  int compared = 0;
  for (const Program& p : testing::short_catalogue())
    for (const char* force :
         {"spring:k=1", "damped-spring:k=1,c=1/2", "poly:1+damped-spring:k=1,c=2", "drag:c=1"}) {
      CAPTURE(p.name);
      CAPTURE(force);
      const Force f = force_named(force);
      const Values parameters = parameter_values(p);
      // Roots have no exact steps, and printed decimals none that are short.
      if (!p.approximations.empty()) continue;
      const LinearDerivation d = linear_derivation(p, f, parameters);
      if (!d.map.extras.empty()) continue;
      CHECK(d.proved());
      const Rational h(1, 2);
      std::map<Letter, Rational> letters{{kStepLetter, h}, {kTimeLetter, 0}};
      const std::vector<Rational> column{Rational(3), Rational(-2), Rational(1, 3), Rational(5)};
      const Rational k = f.spring ? *f.k : Rational(0), c = f.damper ? *f.c : Rational(0);
      Numbers<Rational> problem{[&](const Rational& x, const Rational& v, const Rational& t) {
        Rational a;
        for (int i = f.degree; i >= 0; --i) a = a * t + column[2 + i];
        return a - k * x - c * v;
      }};
      const Tape tape = lower(p, parameters);
      Run<Numbers<Rational>> run(tape, problem, h);
      run.begin(column[0], column[1], 0);
      const auto& oscillation = d.form.oscillation;
      std::vector<Rational> polynomial;
      for (const Fraction& e : oscillation.polynomial) polynomial.push_back(e.evaluate(letters));
      std::vector<std::vector<Rational>> window(2, std::vector<Rational>(oscillation.order()));
      const auto columns = static_cast<std::size_t>(f.degree + 3);
      for (std::size_t i = 0; i < columns; ++i)
        for (int j = 0; j < oscillation.order(); ++j) {
          window[0][j] += oscillation.position[i][j].evaluate(letters) * column[i];
          window[1][j] += oscillation.velocity[i][j].evaluate(letters) * column[i];
        }
      for (int n = 0; n <= 200; ++n) {
        if (n > 0) run.step();
        if (n >= d.form.valid_from && (n < 5 || n == 73 || n == 200)) {
          letters[kCount] = n;
          const auto [x, v] = run.read_out();
          for (const auto& [stepped, motion, rest] :
               {std::tuple{&x, &d.form.position, &window[0]}, {&v, &d.form.velocity, &window[1]}}) {
            Rational closed = rest->empty() ? Rational(0) : rest->front();
            for (std::size_t i = 0; i < columns; ++i)
              for (const Sequence::Term& term : (*motion)[i].terms())
                closed += term.coefficient.evaluate(letters) * term.base.evaluate(letters).pow(n) * column[i];
            CHECK(closed == *stepped);
            ++compared;
          }
        }
        for (auto& w : window) {
          if (w.empty()) continue;
          Rational next;
          for (int j = 0; j < oscillation.order(); ++j) next -= polynomial[j] * w[j];
          w.erase(w.begin());
          w.push_back(next);
        }
      }
    }
  CHECK(compared > 800);
}
