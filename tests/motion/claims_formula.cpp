// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/program/check.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

const Program kProgram =
    parse("integrator test\n param r = 1/2\n param c : 1/T = 3\n param half = r/2\nstep\n x = x + h*v\n",
          "test.integrator");

Motion motion(const std::string& text, int degree = 0, const Values& given = {}) {
  const Names names = formula_names(kProgram, degree);
  const Expr e = parse_formula(text, "--x", names, {Sort::vector, kLength});
  return evaluated(e, formula_scalars(kProgram, given), degree);
}

bool same_motion(const std::string& one, const std::string& other, int degree = 0, const Values& given = {}) {
  return is_zero(motion(one, degree, given) - motion(other, degree, given));
}

/// What a formula is at some n, its letters h, r, c given, for x0 = 1 and all else 0.
Rational value(const std::string& text, int n, const Rational& h = 1, const Rational& r = 1,
               const Rational& c = 1) {
  return motion(text)[0].at(n).evaluate({{kStepLetter, h}, {kFirstParameter, r}, {kFirstParameter + 1, c}});
}

}  // namespace

TEST_CASE("a formula is a combination of x0, v0 and the force's letters") {
  const Motion m = motion("2*x0 - h*v0/3 + f0*t^2/2 - f2*h^3*t", 2);
  REQUIRE(m.size() == 5);
  const Fraction h = Fraction::letter(kStepLetter);
  const Fraction n = Fraction::letter(kCount);
  CHECK(m[0] == Sequence(2));
  CHECK(m[1] == Sequence(-h / Fraction(3)));
  CHECK(m[2] == Sequence(n * n * h * h / Fraction(2)));
  CHECK(m[3].is_zero());
  CHECK(m[4] == Sequence(-h.pow(4) * n));
}

TEST_CASE("equal formulas are the same motion, however they are written") {
  CHECK(same_motion("x0 + v0*t + a*t^2/2", "1/2*(t*(a*t + 2*v0)) - -x0"));
  CHECK(same_motion("a*t^2*(1 + 1/n)/2", "a*(t^2 + h*t)/2"));
  CHECK(same_motion("0 + x0 - 0", "x0"));
  CHECK(same_motion("a*(n*h)^2", "a*t*t"));
  CHECK(same_motion("f0*t^2", "a*t^2"));
  CHECK(same_motion("2^n*3^n*x0", "6^n*x0"));
  CHECK(same_motion("x0/2^n", "(1/2)^n*x0"));
  CHECK(same_motion("x0/2^-n", "2^n*x0"));
  CHECK(same_motion("r^(2*n + 1)*x0", "(r^2)^n*r*x0"));
  CHECK(same_motion("r^(n - 1)*x0", "r^n/r*x0"));
  CHECK(same_motion("(r^n)^3*x0", "r^(3*n)*x0"));
  CHECK(same_motion("(1 - r^n)^2*x0", "x0 - 2*r^n*x0 + r^(2*n)*x0"));
  CHECK(same_motion("(1 - c*h)^n/(1 - c*h)*x0", "(1 - c*h)^(n - 1)*x0"));
  CHECK(same_motion("1^n*x0", "x0"));
  CHECK(same_motion("r^(n/2 + n/2)*x0", "r^n*x0"));
}

TEST_CASE("different formulas are different motions") {
  CHECK_FALSE(same_motion("x0", "x0 + h*v0 - h*v0/1.000001"));
  CHECK_FALSE(same_motion("2^n*x0", "n*x0"));
  CHECK_FALSE(same_motion("(-1)^n*x0", "x0"));
  CHECK_FALSE(same_motion("r^n*x0", "half^n*x0"));
  CHECK_FALSE(same_motion("x0/n", "x0"));
}

TEST_CASE("a formula has the value that plain substitution gives") {
  CHECK(value("r^n*x0", 3, 1, Rational(2, 3)) == Rational(8, 27));
  CHECK(value("(1 + c*h)^(2*n)*x0", 2, Rational(1, 2), 1, 4) == 81);
  CHECK(value("x0/n^2", 5) == Rational(1, 25));
  CHECK(value("n^3*(-2)^n*x0", 3) == -216);
  CHECK(value("(2*r)^-n*x0", 2, 1, 3) == Rational(1, 36));
}

TEST_CASE("a parameter that follows from others is what its default makes of them, until it is given") {
  CHECK(same_motion("half*x0", "r/2*x0"));
  CHECK_FALSE(same_motion("half*x0", "r/2*x0", 0, {{"half", 5}}));
  CHECK(same_motion("half*x0", "5*x0", 0, {{"half", 5}}));
  CHECK(same_motion("half*x0", "2*x0", 0, {{"r", 4}}));
  CHECK(same_motion("r^n*x0", "4^n*x0", 0, {{"r", 4}}));
}

TEST_CASE("a formula without a value is refused") {
  CHECK_THROWS_WITH_AS(motion("x0/(n - n)"), "the formula divides by 'n - n', which is zero", Undefined);
  CHECK_THROWS_AS(motion("x0*(n*h/h - t/h)^-1"), Undefined);
  CHECK_THROWS_WITH_AS(motion("x0*(n - n)^n"), "the formula has a power of 'n - n', which is zero",
                       Undefined);
}

TEST_CASE("a formula that is no closed form of this kind is refused with its reason") {
  CHECK_THROWS_WITH_AS(motion("x0/(1 + 2^n)"), "the formula divides by '1 + 2^n', a sum of different powers",
                       Unable);
  CHECK_THROWS_WITH_AS(motion("n^n*x0"), "the base of 'n^n' depends on n", Unable);
  CHECK_THROWS_WITH_AS(
      motion("2^(n^2)*x0"),
      "the exponent 'n^2' is not of the form k*n + m with whole numbers k and m of at most 1000", Unable);
  CHECK_THROWS_AS(motion("2^(n/2)*x0"), Unable);
  CHECK_THROWS_AS(motion("2^r*x0"), Unable);
  CHECK_THROWS_AS(motion("2^(2000*n)*x0"), Unable);
}
