// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_trajectory.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/floating/exact_fingerprint.hpp"
#include "analysis/floating/exact_first_frames.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/motion/numeric_stepping.hpp"
#include "tests/motion/random_integrator.hpp"

using namespace shortfall;
using namespace shortfall::numeric;

namespace {

const std::vector<const char*> kForces{"constant:a=-981/100", "poly:3:f0=1,f1=-2,f2=1/3,f3=5",
                                       "spring:k=3",          "damped-spring:k=2,c=1/9",
                                       "drag:a=-9,c=1/4",     "poly:1:f0=1/7,f1=2+damped-spring:k=5,c=1/3"};

/// The interpreter, every frame: no matrix, no common denominator. T is Rational, or Surd for integrators of
/// which only the results are rational.
template <class T>
std::vector<std::pair<T, T>> frames_by_the_interpreter(const Program& program, const NumericQuestion& q,
                                                       int frames) {
  const T k = q.force.stiffness().constant(), c = q.force.damping().constant();
  Numbers<T> problem{[&](const T& x, const T& v, const T& t) {
    T a = Rational(0);
    for (int d = q.force.degree; d >= 0; --d) a = a * t + T(q.force.push.at(d));
    return a - k * x - c * v;
  }};
  const Tape tape =
      lower(substepped(undisturbed(program), q.substeps), parameter_values(program, q.parameters));
  Run<Numbers<T>> run(tape, problem, T(q.h));
  run.begin(T(q.x0), T(q.v0), T(Rational(0)));
  std::vector<std::pair<T, T>> result{run.read_out()};
  for (int n = 0; n < frames; ++n) {
    run.step();
    result.push_back(run.read_out());
  }
  return result;
}

/// How many frames of both were compared.
template <class T = Rational>
int compared(const Program& program, const NumericQuestion& q, int frames) {
  const auto expected = frames_by_the_interpreter<T>(program, q, frames);
  int count = 0;
  exact_trajectory(program, q, frames, [&](const ExactTrajectory& at) {
    const auto& [x, v] = expected.at(at.frame());
    REQUIRE(T(at.position().rational()) == x);
    REQUIRE(T(at.velocity().rational()) == v);
    ++count;
    return true;
  });
  return count;
}

}  // namespace

TEST_CASE("exact trajectories of the catalogue are those of the interpreter in rational numbers") {
  int trajectories = 0, by_surds = 0, uncompared = 0, refused = 0;
  for (const Program& program : catalogue())
    for (const char* force : kForces) {
      CAPTURE(program.name);
      CAPTURE(force);
      const NumericQuestion q = question(force, "1/10", "0");
      try {
        ExactTrajectory(program, q);
      } catch (const Unable& e) {  // irrational
        CHECK(std::string(e.what()).find("rational") != std::string::npos);
        ++refused;
        continue;
      } catch (const BadInput&) {  // a damping for an integrator that has its own
        ++refused;
        continue;
      }
      ++trajectories;
      try {
        const int count = compared(program, q, 30);
        CHECK(count == 31);
      } catch (const Unable&) {
        // Irrational stages, of which what is reported is free: conjugate ones, or forces that do not see
        // them.
        try {
          const int count = compared<Surd>(program, q, 5);
          CHECK(count == 6);
          ++by_surds;
        } catch (const Unable&) {
          ++uncompared;
        }
      }
    }
  CHECK(trajectories > 280);
  CHECK(by_surds > 10);
  MESSAGE(trajectories, " trajectories, ", by_surds, " by surds, ", uncompared, " not compared, ", refused,
          " refused");
  CHECK(uncompared < 30);
}

TEST_CASE("exact trajectories of random integrators are those of the interpreter") {
  shortfall::testing::Chance chance(20);
  int count = 0;
  for (const auto& [kind, written] : shortfall::testing::random_integrators(chance, 12)) {
    const std::string& text = written;
    const Program program = parse(text, "random.integrator");
    NumericQuestion q = question(kForces[chance.number(0, 5)], "1/10", "0");
    q.h = Rational(chance.number(1, 40), chance.number(1, 60));
    q.x0 = chance.rational();
    q.v0 = chance.rational();
    q.substeps = chance.number(1, 3);
    CAPTURE(text);
    CAPTURE(q.force.text);
    CAPTURE(q.h.str());
    try {
      count += compared(program, q, 12);
    } catch (const Undefined&) {  // a singular stage
    }
  }
  CHECK(count > 500);
}

TEST_CASE("steps that are floating-point numbers, and long ones, give matrices of long integers") {
  const Program program = find_integrator("velocity-verlet");
  NumericQuestion q = question("damped-spring:k=3,c=1/10", "1/50", "0");
  for (const Rational& h : {Rational::from_double(0.02), Rational::from_double(0.1f),
                            Rational::parse("0.0199999999999999999999999999999999999999999999999")}) {
    q.h = h;
    CHECK(compared(program, q, 40) == 41);
    ExactTrajectory stepped(program, q), jumped(program, q);
    stepped.advance(40);
    jumped.jump(40);
    CHECK(stepped.position().rational() == jumped.position().rational());
  }
}

TEST_CASE("after 1000 to 100000 frames an exact trajectory is where numeric_motion is") {
  for (const char* integrator : {"symplectic-euler", "velocity-verlet", "rk4", "adams-bashforth-2"})
    for (const char* force : {"spring:k=1", "poly:2:f0=2,f1=1/5,f2=-1+damped-spring:k=2,c=1/9"})
      for (const auto& [steps, text] : {std::pair{1000, "1000"}, {20000, "20000"}, {100000, "100000"}}) {
        const Program program = find_integrator(integrator);
        const NumericQuestion q = question(force, "1/8", text);
        const NumericMotion m = numeric_motion(program, q);
        ExactTrajectory jumped(program, q);
        jumped.jump(steps);
        CHECK(jumped.position().significant(50) == m.position.decimal);
        CHECK(jumped.velocity().significant(50) == m.velocity.decimal);
        if (steps > 1000) continue;
        ExactTrajectory stepped(program, q);
        stepped.advance(steps);
        CHECK(stepped.position().rational() == jumped.position().rational());
        CHECK(stepped.velocity().rational() == jumped.velocity().rational());
      }
}

TEST_CASE("a jump from any frame is as many steps, and can be followed by more") {
  const Program program = find_integrator("leapfrog");
  const NumericQuestion q = question("constant:a=2+spring:k=3", "1/7", "0");
  ExactTrajectory a(program, q), b(program, q);
  for (const std::int64_t steps : {0, 1, 2, 3, 10, 57, 100, 1}) {
    a.advance(steps);
    b.jump(steps);
    CHECK(a.frame() == b.frame());
    CHECK(a.time() == Rational(a.frame(), 7));
    CHECK(a.position().rational() == b.position().rational());
    b.advance(3);
    a.jump(3);
    CHECK(a.velocity().rational() == b.velocity().rational());
  }
}

TEST_CASE("the state leaves the words of 128 bits at the last moment, and nothing is lost") {
  // x doubles and more: the bound before each step decides.
  for (const char* force : {"spring:k=1", "spring:k=-7", "constant:a=1/3+spring:k=2"}) {
    const Program program = find_integrator("symplectic-euler");
    const NumericQuestion q = question(force, "1/5", "0");
    const auto expected = frames_by_the_interpreter<Rational>(program, q, 60);
    ExactTrajectory at(program, q);
    std::size_t last_bits = 0;
    int left_at = -1;
    for (int n = 0; n <= 60; ++n) {
      if (n > 0) at.advance();
      CHECK(at.position().rational() == expected[n].first);
      CHECK(at.velocity().rational() == expected[n].second);
      if (at.in_words())
        last_bits = std::max(at.position().bits(), at.velocity().bits());
      else if (left_at < 0)
        left_at = n;
    }
    CHECK(left_at > 15);
    // A step of this matrix adds six bits at the most.
    CHECK(last_bits > 110);
    CHECK(last_bits <= 126);
  }
}

TEST_CASE("under gravity denominators do not grow: words hold 10^9 frames") {
  NumericQuestion q = question("constant:a=-9.81", "1/50", "1000000000");
  const Program program = find_integrator("symplectic-euler");
  ExactTrajectory at(program, q);
  CHECK(at.denominator_of_a_step() == Rational(1));
  at.advance(1'000'000);
  at.jump(999'000'000);
  CHECK(at.in_words());
  // x0 + v0 t + a t (t + h)/2
  const Rational t = at.time(), a = Rational::parse("-9.81");
  CHECK(at.position().rational() == q.x0 + q.v0 * t + a * t * (t + q.h) / 2);
  CHECK(at.velocity().rational() == q.v0 + a * t);
}

TEST_CASE("denominators of a step are the least possible for a diagonal scaling") {
  const auto base = [](const char* integrator, const char* force, const char* h) {
    return ExactTrajectory(find_integrator(integrator), question(force, h, "0")).denominator_of_a_step();
  };
  // The trace 2 - h^2 k has the denominator 2500, the determinant 1.
  CHECK(base("symplectic-euler", "spring:k=1", "1/50") == Rational(2500));
  CHECK(base("symplectic-euler", "spring:k=1", "1/64") == Rational(4096));
  CHECK(base("symplectic-euler", "spring:k=2500", "1/50") == Rational(1));
  CHECK(base("explicit-euler", "spring:k=1", "1/50") == Rational(50));
  for (const char* integrator : {"velocity-verlet", "rk4", "adams-bashforth-2"})
    CHECK(base(integrator, "poly:3:f0=1,f1=-2,f2=1/3,f3=5", "1/50") == Rational(1));
}

TEST_CASE("a reading gives decimals, balls and differences from a float without its whole length") {
  const Program program = find_integrator("velocity-verlet");
  const NumericQuestion q = question("damped-spring:k=3,c=1/10", "1/50", "0");
  ExactTrajectory at(program, q);
  at.advance(700);
  for (const ExactReading& reading : {at.position(), at.velocity()}) {
    const Rational exact = reading.rational();
    CHECK(reading.significant(40) == exact.significant(40));
    CHECK(reading.decimal(30) == exact.decimal(30));
    CHECK(reading.decimal(0) == exact.decimal(0));
    CHECK(reading.sign() == exact.sign());
    CHECK(reading.fingerprint() == Modular(exact));
    for (const int bits : {20, 64, 1000}) {
      const Ball b = reading.ball(bits);
      CHECK(b.contains(exact));
      CHECK(b.significant(bits * 3 / 10 - 2));
    }
    const Rational near = Rational::from_double(exact.to_double());
    CHECK(reading.minus(near, 60).contains(exact - near));
    CHECK(reading.minus(near, 60).significant(18) == (exact - near).significant(18));
    CHECK(!reading.equals(near));
    CHECK(reading.equals(exact));
    CHECK(reading.minus(exact, 60).is_zero());
    // Nearer than the leading digits tell.
    const Rational nearer = exact + Rational(1, 3).pow(2000);
    CHECK(!reading.equals(nearer));
    CHECK(reading.minus(nearer, 60).significant(15) == (-Rational(1, 3).pow(2000)).significant(15));
  }
}

TEST_CASE("ties are rounded away from zero") {
  // A free body: x = 1/8 + n/8.
  NumericQuestion q = question("constant:a=0", "1/8", "0");
  q.x0 = Rational(-1, 8);
  q.v0 = -1;
  ExactTrajectory at(find_integrator("explicit-euler"), q);
  CHECK(at.position().significant(2) == "-0.13");
  CHECK(at.position().decimal(2) == "-0.13");
  at.advance(2);
  CHECK(at.position().decimal(2) == "-0.38");
  CHECK(at.position().decimal(3) == "-0.375");
}

TEST_CASE("a value that shrinks has a denominator of any length, and a decimal still") {
  // x is halved in every step.
  const Program program = parse("integrator half\nstep\n  x = 1/2*x\n  v = 1/2*v\n", "half.integrator");
  NumericQuestion q = question("constant:a=0", "1", "0");
  q.x0 = 1;
  q.v0 = 0;
  ExactTrajectory at(program, q);
  at.jump(10'000'000'000);
  CHECK(at.position().significant(5) ==
        (Ball(1, 200) / pow(pow(Ball(2, 200), 100'000), 100'000)).significant(5));
  CHECK(at.velocity().significant(5) == "0");
  CHECK_THROWS_AS(at.position().rational(), Unable);
}

TEST_CASE("a trajectory can be left, and a progress that throws ends it") {
  const Program program = find_integrator("rk4");
  const NumericQuestion q = question("spring:k=1", "1/50", "0");
  const auto all = [](const ExactTrajectory&) { return true; };
  CHECK(exact_trajectory(program, q, 100, [](const ExactTrajectory& at) { return at.frame() < 17; }) == 17);
  struct Stopped {};
  int told = 0;
  CHECK_THROWS_AS(exact_trajectory(program, q, 100'000, all,
                                   [&](const std::string&, int done, int of) {
                                     CHECK(done <= of);
                                     if (++told == 4) throw Stopped();
                                   }),
                  Stopped);
  CHECK_THROWS_AS(exact_trajectory(program, q, -1, all), BadInput);
}

TEST_CASE("what has no exact trajectory is refused with a sentence") {
  const Program p = find_integrator("velocity-verlet");
  CHECK_THROWS_WITH_AS(ExactTrajectory(p, question("spring", "1/10", "0")), doctest::Contains("number for k"),
                       BadInput);
  CHECK_THROWS_WITH_AS(ExactTrajectory(p, question("constant", "1/10", "0")),
                       doctest::Contains("number for a"), BadInput);
  CHECK_THROWS_WITH_AS(ExactTrajectory(find_integrator("yoshida-4"), question("spring:k=1", "1/10", "0")),
                       doctest::Contains("irrational"), Unable);
  CHECK_THROWS_WITH_AS(
      ExactTrajectory(find_integrator("implicit-midpoint"), question("spring:k=-400", "1/10", "0")),
      doctest::Contains("singular"), Undefined);
  std::string high = "poly:31:f0=1";
  for (int d = 1; d <= 31; ++d) high += ",f" + std::to_string(d) + "=1";
  CHECK_THROWS_WITH_AS(ExactTrajectory(p, question(high.c_str(), "1/10", "0")), doctest::Contains("poly:30"),
                       Unable);
  ExactTrajectory at(p, question("spring:k=1", "1/50", "0"));
  CHECK_THROWS_AS(at.advance(-1), BadInput);
  CHECK_THROWS_AS(at.jump(-1), BadInput);
  CHECK_THROWS_WITH_AS(at.jump(1'000'000'000'000'000'000), doctest::Contains("binary digits"), Unable);
}
