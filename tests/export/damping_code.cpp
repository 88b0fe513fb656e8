// SPDX-License-Identifier: GPL-3.0-or-later
// Exact damping as code: compiled, run, and held against the motion in numbers of 200 bits.
#include "notebooks-export/damping_code.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "tests/export/languages.hpp"

namespace shortfall {
namespace {

struct DampedStep {
  double x, v, a, c, dt;
};

/// c dt from 0 over the last bits of binary64 and both sides of the series' end up to what leaves nothing.
const std::vector<DampedStep>& damped_steps() {
  static const std::vector<DampedStep> all = [] {
    std::vector<DampedStep> list;
    for (const double u :
         {0.0, 1e-300, 1e-17, 1e-12, 3e-8, 1e-4, 0.01, 0.3, 0.4999999, 0.5, 0.51, 1.0, 7.0, 40.0, 1e6})
      for (const double dt : {0.02, 1.0, 1e-3})
        // One term at a time as well: a sum may hide a small one.
        for (const auto& [x, v, a, none, unit] :
             {DampedStep{0, 1, 0, 0, 0}, DampedStep{0, 0, 1, 0, 0}, DampedStep{0.25, 3.5, 9.81, 0, 0}})
          list.push_back({x, v, a, none + u / dt, unit + dt});
    return list;
  }();
  return all;
}

std::string digits(double d) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", d);
  return text;
}

std::string arguments(const DampedStep& c, bool with_place) {
  const std::string rest = digits(c.a) + ", " + digits(c.c) + ", " + digits(c.dt);
  return with_place ? digits(c.x) + ", " + digits(c.v) + ", " + rest : rest;
}

/// The true motion: sums of powers of -u where u is small, so that nothing cancels, and exponentials
/// elsewhere.
std::pair<double, double> truth(const DampedStep& s) {
  constexpr int kBits = 200;
  const auto ball = [](double d) { return Ball(Rational::from_double(d), kBits); };
  const Ball c = ball(s.c), dt = ball(s.dt), one(1, kBits), u = c * dt;
  Ball decay(1, kBits), q = dt, pull = dt * dt / Ball(2, kBits);
  if (s.c != 0 && s.c * s.dt > 1e-6) {
    decay = s.c * s.dt < 800 ? exp(-u) : Ball(0, kBits);  // below the least number of binary64
    q = (one - decay) / c;
    pull = (dt - q) / c;
  } else {
    Ball power = one;  // (-u)^k/(k+1)! and so on; 1e-6 to the power 10 is below everything
    decay = q = pull = Ball(0, kBits);
    for (int k = 0; k < 10; ++k) {
      decay += power;
      q += power / Ball(k + 1, kBits) * dt;
      pull += power / Ball((k + 1) * (k + 2), kBits) * dt * dt;
      power = power * -u / Ball(k + 1, kBits);
    }
  }
  const Ball x = ball(s.x) + q * ball(s.v) + pull * ball(s.a), v = decay * ball(s.v) + q * ball(s.a);
  return {x.midpoint().to_double(), v.midpoint().to_double()};
}

void compare_motions(const std::string& output) {
  std::istringstream in(output);
  for (const DampedStep& c : damped_steps()) {
    CAPTURE(arguments(c, true));
    double x = 0, v = 0;
    REQUIRE(bool(in >> x >> v));
    const auto [true_x, true_v] = truth(c);
    constexpr double kSomeRoundings = 4e-15;
    CHECK(std::abs(x - true_x) <= kSomeRoundings * std::abs(true_x));
    // exp(-u) is known as well as u is: 40 has a relative error of 2^-53, exp(-40) one of 40 times that.
    CHECK(std::abs(v - true_v) <=
          (kSomeRoundings + 2.3e-16 * std::min(c.c * c.dt, 700.0)) * std::abs(true_v) + 1e-300);
  }
}

TEST_CASE("exact damping in C++ compiles without a warning and keeps its digits at every c dt") {
  if (!installed("g++")) return;
  const CodeFolder folder;
  std::string text = "#include <cstdio>\n" + damping_code(Language::cpp) + "int main() {\n  double x, v;\n";
  for (const DampedStep& c : damped_steps())
    text += "  x = " + digits(c.x) + "; v = " + digits(c.v) + "; damped_move(x, v, " + arguments(c, false) +
            "); std::printf(\"%.17g %.17g\\n\", x, v);\n";
  folder.write("damped.cpp", text + "}\n");
  folder.output("g++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -ffp-contract=off -o damped damped.cpp");
  compare_motions(folder.output("./damped"));
}

TEST_CASE("exact damping in Rust") {
  if (!installed("rustc")) return;
  const CodeFolder folder;
  // A literal like 1 is a whole number in Rust; a cast makes a float of either.
  std::string text = damping_code(Language::rust) + "fn main() {\n";
  for (const DampedStep& c : damped_steps())
    text += "    { let (x, v) = damped_move(" + digits(c.x) + " as f64, " + digits(c.v) + " as f64, " +
            digits(c.a) + " as f64, " + digits(c.c) + " as f64, " + digits(c.dt) +
            " as f64); println!(\"{:e} {:e}\", x, v); }\n";
  folder.write("damped.rs", text + "}\n");
  folder.output("rustc --edition 2021 -D warnings -o damped damped.rs");
  compare_motions(folder.output("./damped"));
}

TEST_CASE("exact damping in Python") {
  if (!installed("python3")) return;
  const CodeFolder folder;
  std::string text = damping_code(Language::python);
  for (const DampedStep& c : damped_steps())
    text += "print(*map(repr, damped_move(" + arguments(c, true) + ")))\n";
  folder.write("damped.py", text);
  compare_motions(folder.output("python3 damped.py"));
}

TEST_CASE("exact damping in JavaScript") {
  if (!installed("node")) return;
  const CodeFolder folder;
  std::string text = "\"use strict\";\n" + damping_code(Language::javascript);
  for (const DampedStep& c : damped_steps())
    text += "console.log(...dampedMove(" + arguments(c, true) + "));\n";
  folder.write("damped.js", text);
  compare_motions(folder.output("node damped.js"));
}

TEST_CASE("exact damping in C#") {
  if (!installed("mcs") || !installed("mono")) return;
  const CodeFolder folder;
  std::string text =
      "static class Program {\n" + damping_code(Language::csharp) + "static void Main() { double x, v;\n";
  for (const DampedStep& c : damped_steps())
    text += "x = " + digits(c.x) + "; v = " + digits(c.v) + "; DampedMove(ref x, ref v, " +
            arguments(c, false) + "); System.Console.WriteLine(\"{0:R} {1:R}\", x, v);\n";
  folder.write("damped.cs", text + "} }\n");
  folder.output("mcs -out:damped.exe damped.cs");
  compare_motions(folder.output("mono damped.exe"));
}

}  // namespace
}  // namespace shortfall
