// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/motion/numeric_stepping.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;
using namespace shortfall::numeric;

namespace {

const char* const kForces[] = {"constant:a=-9.81",   "poly:2:f0=1,f1=-2,f2=1/3",
                               "spring:k=3",         "damped-spring:k=5,c=1/3",
                               "drag:c=3/7,a=-9.81", "poly:1:f0=2,f1=1/5+damped-spring:k=2,c=1/9",
                               "spring:k=-2",        "damped-spring:k=4,c=4"};

}  // namespace

TEST_CASE("numbers after n steps are those of stepping in rationals, for the whole catalogue") {
  int exact = 0, certain = 0;
  for (const Program& p : testing::short_catalogue())
    for (const char* force : kForces)
      for (const char* steps : {"0", "1", "4", "30", "200"}) {
        // Long rationals are slow to step: one force so far.
        if (std::string(steps) == "200" && std::string(force) != "spring:k=3") continue;
        CAPTURE(p.name);
        CAPTURE(force);
        CAPTURE(steps);
        NumericQuestion q = question(force, "1/20", steps);
        q.digits = 30;
        NumericMotion m;
        try {
          m = numeric_motion(p, q);
        } catch (const Unable&) {
          continue;  // no linear step, and it says why
        }
        if (!p.approximations.empty() && q.steps > Rational(30))
          continue;  // long decimals make long rationals
        std::pair<Rational, Rational> truth;
        try {
          truth = stepped_exactly(p, q, std::stoi(steps));
        } catch (const Unable&) {
          continue;  // roots have no exact steps; linear_kit_irrational.cpp steps some of them at 100 digits
        }
        const auto& [x, v] = truth;
        for (const auto& [number, stepped] : {std::pair{&m.position, &x}, {&m.velocity, &v}}) {
          CHECK(number->ball.contains(*stepped));
          CHECK(shown(*number) == Rational::parse(stepped->significant(30)));
          ++(number->exact ? exact : certain);
          if (number->exact) CHECK(*number->exact == *stepped);
        }
      }
  CHECK(exact > 500);
  CHECK(certain > 30);
}
