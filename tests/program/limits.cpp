// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/check.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tape.hpp"

using namespace shortfall;

namespace {

/// What a user reads about a step; "" when it is accepted.
std::string step_complaint(const std::string& statements) {
  try {
    lower(parse("integrator test\nstep\n" + statements + "\n", "test.integrator"));
    return "";
  } catch (const SyntaxError& e) {
    return e.what();
  }
}

/// x = (x + x + ...) with so many values, a few to a line.
std::string sum_of(int values) {
  std::string text = "x = (x";
  for (int i = 1; i < values; ++i) text += i % 50 == 0 ? "\n + x" : " + x";
  return text + ")";
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("an expression may have a thousand values, and two hundred levels") {
  CHECK(step_complaint(sum_of(990)).empty());
  CHECK(step_complaint(sum_of(1010)).ends_with("the expression has more than 1000 values"));
  CHECK(step_complaint("x = " + repeated("(", 95) + "x" + repeated(")", 95)).empty());
  CHECK(step_complaint("x = " + repeated("-", 60) + "x").empty());
  CHECK(step_complaint("x = " + repeated("-", 150) + "x").ends_with("nested deeper than 200 levels"));
  CHECK(step_complaint("x = " + repeated("(", 300) + "x" + repeated(")", 300))
            .ends_with("nested deeper than 200 levels"));
}

TEST_CASE("what is nested as deeply as may be is printed to a text that can be read again") {
  for (const std::string level : {"-", "k - -(", "k*-(", "k/-(k - ", "-(", "max(k, -", "0.5*-("})
    for (const std::string leaf : {"k", "0.5^2"}) {
      const int closed = level.find('(') != std::string::npos ? 1 : 0;
      int most = 0;
      for (int levels = 1; levels < 250; ++levels) {
        std::string printed;
        try {
          printed = print(parse("integrator nested\nparam k = 1\nstep\n  c = " + repeated(level, levels) +
                                    leaf + repeated(")", closed * levels) + "\n  x = x + c*h*v\n",
                                "test"));
        } catch (const SyntaxError& e) {
          CHECK(std::string(e.what()).ends_with("nested deeper than 200 levels"));
          break;
        }
        most = levels;
        CHECK(print(parse(printed, "printed")) == printed);
      }
      CHECK(most >= 30);
      CHECK(most < 200);
    }
}

TEST_CASE("long files are read as quickly as they are long") {
  CHECK(step_complaint(repeated("x = x + h*v\n", 50'000)).empty());
  CHECK(step_complaint(repeated("# nothing\n", 99'000) + "x = x").empty());
  CHECK(step_complaint(repeated("# nothing\n", 101'000) + "x = x") ==
        "test.integrator:1:1: the file is larger than 1 MB; an integrator needs about twelve lines");
}

TEST_CASE("numbers may have ten thousand digits, also those that are made of numbers") {
  CHECK(step_complaint("x = x*1e9999").empty());
  CHECK(step_complaint("x = x*999^1000").empty());
  CHECK(step_complaint("x = x*(10^1000*10^1000)").empty());
  CHECK_FALSE(step_complaint("x = x*(999^1000)^4").empty());
  CHECK_FALSE(step_complaint("x = x*1e10001").empty());
  CHECK_FALSE(step_complaint("x = x*(1e9999*1e9999)").empty());
}

TEST_CASE("the powers of locals multiply up to ten thousand at most") {
  CHECK(step_complaint("k = h^1000\n l = k^10/h^10000*1\n x = x") ==
        "test.integrator:4:13: an exponent is a whole number from -1000 to 1000");
  CHECK(step_complaint("k = (h/h)^500\n l = k^9\n x = l*x").empty());
  CHECK_FALSE(step_complaint("k = (h/h)^500\n l = k^11\n x = l*x").empty());
}

TEST_CASE("a line that would fill the screen is not shown") {
  const auto context = [](const std::string& line) {
    try {
      parse("integrator test\nstep\n" + line + "\n", "test.integrator");
    } catch (const SyntaxError& e) {
      return e.context();
    }
    return std::string("accepted");
  };
  CHECK(context("x = y") == "x = y\n    ^");
  CHECK(context("x = y" + std::string(400, ' ')).empty());
}

TEST_CASE("a text may begin with a byte order mark, end without a line break and have any line ends") {
  CHECK(parse("\xEF\xBB\xBFintegrator test\r\nstep\r\n\tx = x + h*v", "f").name == "test");
  CHECK(parse("integrator test # this name\nstep # of it\nx=x+h*v# so\n", "f").name == "test");
}

TEST_CASE("a formula of the command line is checked against the names it may use") {
  const Program program = parse("integrator test\n param r = 1/2\nstep\n x = x + h*v\n", "f");
  const auto refusal = [&](const std::string& text, int degree) {
    try {
      parse_formula(text, "--x", formula_names(program, degree), {Sort::vector, kLength});
      return std::string();
    } catch (const SyntaxError& e) {
      return std::string(e.what());
    }
  };
  CHECK(refusal("x0 + v0*t + r^n*a*t^2/2", 0).empty());
  CHECK(refusal("x0 + f0*t^2/2 + f1*t^3/6", 1).empty());
  CHECK(refusal("x0 + a*t^2", 1) == "--x:1:6: unknown name 'a'");
  CHECK(refusal("x + v*t", 0) == "--x:1:1: unknown name 'x'; did you mean 'x0'?");
  CHECK(refusal("x0 + v0", 0) == "--x:1:4: cannot add vector [L] and vector [L T^-1]");
  CHECK(refusal("v0", 0) == "--x:1:1: the formula is a vector [L T^-1], expected a vector [L]");
  CHECK(refusal("x0 +", 0) ==
        "--x:1:5: expected a value after '+', found the end of the line; a line goes on only inside "
        "parentheses");
  CHECK(refusal("x0 x0", 0) == "--x:1:4: an operator is missing before 'x0'; a product is written with *");
  CHECK(refusal("x0 + a(x0, v0, t)", 0) == "--x:1:6: the force cannot be called here");
  CHECK(refusal("x0\n + v0*t", 0) == "--x:2:1: a formula stands on one line");
  CHECK(refusal("", 0) == "--x:1:1: expected a value, found the end of the line");
}
