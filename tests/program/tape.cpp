// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tape.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"

using namespace shortfall;

namespace {

Program program(const std::string& head, const std::string& step) {
  return parse("integrator test\n" + head + "\nstep\n" + step + "\n", "test.integrator");
}

/// x after one step of h = 2 from x = 10, v = 3, t = 5 under a = 7.
template <class T>
T position(const Program& p, const Values& given = {}) {
  Numbers<T> problem;
  problem.force = [](const T&, const T&, const T&) { return T(7); };
  const Tape tape = lower(p, given);
  Run<Numbers<T>> run(tape, problem, T(2));
  run.begin(T(10), T(3), T(5));
  run.step();
  return run.state(0);
}

Rational position(const std::string& step, const Values& given = {}, const std::string& head = "") {
  return position<Rational>(program(head, step), given);
}

}  // namespace

TEST_CASE("a step does what is written, with the dimensions it needs") {
  CHECK(position("x = x + h*v") == 16);
  CHECK(position("x = x - h*v/2 + h^2/4*a(x, v, t)") == 14);
  CHECK(position("x = x + t*v") == 25);
  CHECK(position("x = -x") == -10);
  CHECK(position("x = -(-x)") == 10);
  CHECK(position("x = x*3/4") == Rational(15, 2));
  CHECK(position("x = x*h^-1*t") == 25);
  CHECK(position("x = x*h^0") == 10);
  CHECK(position("x = x + -h^2*a(x, v, t)") == -18);
  CHECK(position("x = 0") == 0);
  CHECK(position("x = 0 + x") == 10);
  CHECK(position("x = x - 0*h") == 10);
  CHECK(position("x = x + h*v - 4*(1/2 - 0.5)*x") == 16);
}

TEST_CASE("a name holds its new value from its statement on, and the value is read before it changes") {
  CHECK(position("v = v + h*a(x, v, t)\n x = x + h*v") == 44);
  CHECK(position("x = x + x + x") == 30);
  CHECK(position("x = x - (x + x)") == -10);
  CHECK(position("k = h\n k = k*k/h + k\n x = x + k*v") == 22);
  CHECK(position("y = x\n x = 2*y\n y = x\n x = x + y") == 40);
}

TEST_CASE("every operation rounds once, in the order that is written") {
  CHECK(position<float>(program("", "x = x*0.1")) == 10.0F * 0.1F);
  CHECK(position<float>(program("", "x = x/3*3")) == 10.0F / 3.0F * 3.0F);
  CHECK(position<float>(program("", "x = 1/10*x")) == 1.0F / 10.0F * 10.0F);
  const float h = 2, v = 3;
  CHECK(position<float>(program("", "x = x + (h*0.3*v + 0.7*h*v)")) == 10.0F + (h * 0.3F * v + 0.7F * h * v));
  CHECK(position<float>(program("", "c = 0.1\n x = c^3*x")) == 0.1F * 0.1F * 0.1F * 10.0F);
  CHECK(position<float>(program("", "c = 0.1\n x = c^-2*x")) == 1.0F / (0.1F * 0.1F) * 10.0F);
}

TEST_CASE("implicit stages are solved, alone and together") {
  // k = 7 + k/2 has k = 14; the pair u = 7 + w/2, w = u/4.
  CHECK(position("solve k : L/T^2 = a(x, v, t) + k/2\n x = x + h^2*k") == 66);
  CHECK(position("solve u : L/T^2 = a(x, v, t) + w/2 & w : L/T^2 = u/4\n x = x + h^2*u") == 42);
  CHECK(position("solve k : L/T^2 = a(x, v, t)\n x = x + h^2*k") == 38);
  CHECK_THROWS_AS(position("solve k : L/T^2 = a(x, v, t) + k\n x = x + h^2*k"), Undefined);
  CHECK(position<float>(program("", "solve k : L/T^2 = a(x, v, t) + k/2\n x = x + h^2*k")) == 66.0F);
}

TEST_CASE("parameters have defaults, may follow from one another and may be given") {
  const std::string head = "param p = 1/2\n param q = 1 - p\n param r = q^2/p";
  CHECK(position("x = p*x", {}, head) == 5);
  CHECK(position("x = r*x", {}, head) == 5);
  CHECK(position("x = r*x", {{"p", Rational(1, 5)}}, head) == 32);
  CHECK(position("x = r*x", {{"q", 3}}, head) == 180);
  CHECK(position("x = r*x", {{"r", 0}}, head) == 0);
  const Values values = parameter_values(program(head, "x = r*x"), {{"p", Rational(1, 5)}});
  CHECK(values == Values{{"p", Rational(1, 5)}, {"q", Rational(4, 5)}, {"r", Rational(16, 5)}});
}

TEST_CASE("parameters keep their dimension, and a plain default takes it") {
  CHECK(position("x = x + d", {}, "param c : 1/T = 0.5\n state d : L\nstart\n d = v/c").str() == "16");
  CHECK(position("x = x + s*v", {}, "param c : 1/T = 0.5\n param s : T = 3/c") == 28);
}

TEST_CASE(
    "an unknown parameter is refused with what may have been meant, a default without a value with its "
    "reason") {
  const Program p = program("param beta = 1/4\n param inverse = 1/beta", "x = x + h*v");
  CHECK_THROWS_WITH_AS(lower(p, {{"bata", 1}}), "test has no parameter 'bata'; did you mean 'beta'?",
                       BadInput);
  CHECK_THROWS_WITH_AS(lower(program("", "x = x + h*v"), {{"beta", 1}}),
                       "test has no parameter 'beta'; it has none", BadInput);
  CHECK_THROWS_AS(lower(p, {{"beta", 0}}), Undefined);
}

TEST_CASE(
    "a parameter that decides how many substeps there are is a number for every problem, with all it depends "
    "on") {
  const Tape tape = lower(
      program("param p = 2\n param free = 3\n param count = p^2", "substeps count {\n x = x + free*h*v\n }"));
  REQUIRE(tape.parameters.size() == 3);
  CHECK(tape.parameters[0].fixed == Rational(2));
  CHECK_FALSE(tape.parameters[1].fixed.has_value());
  CHECK(tape.parameters[2].fixed == Rational(4));
}

TEST_CASE("the carried vectors have names and dimensions") {
  const Tape tape = lower(find_integrator("beeman"));
  CHECK(tape.states == std::vector<std::string>{"x", "v", "a0", "a_prev"});
  CHECK(tape.state_dimensions == std::vector<Dimension>{kLength, kVelocity, kAcceleration, kAcceleration});
}

TEST_CASE("the read-out changes nothing for the next step") {
  Numbers<Rational> problem;
  problem.force = [](const Rational& x, const Rational&, const Rational& t) { return x + t; };
  const Tape tape = lower(find_integrator("leapfrog"));
  Run<Numbers<Rational>> once(tape, problem, Rational(1, 10));
  Run<Numbers<Rational>> often(tape, problem, Rational(1, 10));
  for (auto* run : {&once, &often}) run->begin(1, 2, 0);
  for (int n = 0; n < 4; ++n) {
    once.step();
    often.step();
    often.read_out();
    CHECK(often.read_out() == often.read_out());
  }
  CHECK(once.read_out() == often.read_out());
}

TEST_CASE("a tableau is applied to position and velocity alike") {
  // Heun under a = 7: x = x + h v + h^2/2 a.
  CHECK(position<Rational>(find_integrator("heun")) == 30);
  const Program implicit =
      parse("integrator i\ntableau\n 1/4 | 1/4 0\n 3/4 | 1/2 1/4\n b | 1/2 1/2\n", "i.integrator");
  CHECK(position<Rational>(implicit) == 30);
}
