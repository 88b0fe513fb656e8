// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/double_double.hpp"
#include "analysis/floating/float_run.hpp"
#include "analysis/floating/float_variants.hpp"
#include "analysis/floating/small_float.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

/// One operation a format does: x0 is the position, v0 the velocity; h = 1.
FloatNumber computed(const std::string& format, const std::string& operation, const Rational& x,
                     const Rational& v) {
  FloatQuestion q;
  q.program = parse("integrator one\n  source nobody\n\nstep\n  " + operation + "\n", "one.integrator");
  q.force = force_named("constant:a=0");
  q.h = 1;
  q.x0 = x;
  q.v0 = v;
  const auto run = float_run(float_format(format), q);
  run->step();
  return run->state().first;
}

struct RandomOfFormat {
  std::mt19937_64 generator;
  /// A number of the format, of a size that makes exponents meet.
  Rational operator()(const BinaryFormat& f, int spread) {
    const int shift = std::uniform_int_distribution<int>(-spread, spread)(generator);
    const Rational raw = Rational(static_cast<std::int64_t>(generator())) * Rational(2).pow(shift - 62);
    const auto r = rounded(raw, f);
    return r ? *r : Rational(1);
  }
};

void check_operation(const std::string& name, const Rational& exact, const std::string& operation,
                     const Rational& x, const Rational& v) {
  const FloatFormat format = float_format(name);
  const auto truth = rounded(exact, format.storage(), format.rounding());
  const FloatNumber found = computed(name, operation, x, v);
  CAPTURE(name);
  CAPTURE(operation);
  CAPTURE(x);
  CAPTURE(v);
  CHECK(found.is_finite() == truth.has_value());
  if (truth) CHECK(found.value == *truth);
}

}  // namespace

TEST_CASE("sums, products and quotients are the correctly rounded ones in every format and direction") {
  RandomOfFormat random{std::mt19937_64(2)};
  for (const char* name : {"f16", "bf16", "f32", "f64", "x87", "f128", "mpfr:50", "mpfr:9", "f16+tozero",
                           "bf16+tozero", "f32+tozero", "f64+tozero", "x87+tozero", "mpfr:20+tozero"}) {
    const BinaryFormat storage = float_format(name).storage();
    for (int repeat = 0; repeat < 60; ++repeat) {
      const Rational x = random(storage, 12), v = random(storage, 12);
      check_operation(name, x + v, "x = x + h*v", x, v);
      check_operation(name, x - v, "x = x - h*v", x, v);
      if (!x.is_zero()) check_operation(name, x / Rational(3), "x = x/3", x, v);
      const auto third = rounded(Rational(1, 3), storage, float_format(name).rounding());
      check_operation(name, x * *third, "x = 1/3*x", x, v);
    }
  }
}

TEST_CASE("fused sums are rounded once, in every format that has them") {
  RandomOfFormat random{std::mt19937_64(3)};
  for (const char* name :
       {"f16+fma", "bf16+fma", "f32+fma", "f64+fma", "x87+fma", "f128+fma", "mpfr:30+fma"}) {
    const BinaryFormat storage = float_format(name).storage();
    const Rational third = *rounded(Rational(1, 3), storage);
    for (int repeat = 0; repeat < 100; ++repeat) {
      const Rational x = random(storage, 6), v = random(storage, 6);
      check_operation(name, x + third * v, "x = x + (h/3)*v", x, v);
      check_operation(name, x - third * v, "x = x - (h/3)*v", x, v);
    }
  }
}

TEST_CASE("the small formats, exhaustively near their ends: subnormals, ties, overflow") {
  for (int a = -70; a <= 70; ++a)
    for (int b : {-3, -1, 1, 5, 2047}) {
      const double x = std::ldexp(a, -24), y = std::ldexp(b, -24);
      CHECK((Binary16(x) + Binary16(y)).value() ==
            rounded(Rational::from_double(x) + Rational::from_double(y), BinaryFormat::binary16())
                ->to_double());
      CHECK((Binary16(x) * Binary16(b / 2048.0)).value() ==
            rounded(Rational::from_double(x) * Rational::from_double(Binary16(b / 2048.0).value()),
                    BinaryFormat::binary16())
                ->to_double());
    }
  CHECK(Binary16(65519.0).value() == 65504);
  CHECK(std::isinf(Binary16(65520.0).value()));
  CHECK(BFloat16(3.391e38).value() == 3.3895313892515355e38);
  CHECK(std::isinf((BFloat16(3.3895313892515355e38) + BFloat16(1.0e36)).value()));
}

TEST_CASE("double-double is within its proven bounds of the truth") {
  std::mt19937_64 generator(4);
  const auto number = [&] {
    const double high =
        std::ldexp(static_cast<double>(generator() >> 11), -static_cast<int>(generator() % 60));
    return DoubleDouble(high, std::ldexp(high, -54) * (static_cast<double>(generator() % 1000) / 1000 - 0.5));
  };
  const auto exact = [](const DoubleDouble& d) {
    return Rational::from_double(d.high()) + Rational::from_double(d.low());
  };
  const auto close = [](const Rational& found, const Rational& truth, int units) {
    return (found - truth).abs() <= Rational(units) * truth.abs() / Rational(2).pow(106);
  };
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const DoubleDouble a = number(), b = number();
    if (a.high() == 0 || b.high() == 0) continue;
    CHECK(close(exact(a + b), exact(a) + exact(b), 3));
    CHECK(close(exact(a * b), exact(a) * exact(b), 5));
    CHECK(close(exact(a / b), exact(a) / exact(b), 15));
    const Rational root = exact(sqrt(a));
    CHECK(close(root * root, exact(a), 16));
  }
}

TEST_CASE("a compensated sum holds what a plain one loses") {
  // 0.1f added 100,000 times.
  FloatQuestion q;
  q.program = find_integrator("explicit-euler");
  q.force = force_named("constant:a=0");
  q.h = 1;
  q.x0 = 0;
  q.v0 = Rational(1, 10);
  const Rational truth = Rational::from_double(0.1f) * Rational(100'000);
  const auto after = [&](const char* format) {
    const auto run = float_run(float_format(format), q);
    for (int n = 0; n < 100'000; ++n) run->step();
    return run->state().first.value;
  };
  CHECK((after("f32") - truth).abs() > Rational(1));
  CHECK(after("f32+kahan") == *rounded(truth, BinaryFormat::binary32()));
  CHECK((after("f32+origin") - truth).abs() < Rational(1, 100));
}

TEST_CASE(
    "wide formats follow the exact trajectory of stored numbers to their digits, for the whole catalogue") {
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;
    CAPTURE(program.name);
    FloatQuestion q;
    q.program = program;
    q.parameters = parameter_values(program);
    q.force = force_named("spring:k=4");
    q.h = Rational(1, 10);
    q.x0 = Rational(1, 3);
    q.v0 = Rational(-1, 7);
    for (const auto& [name, digits] :
         {std::pair{"f64", 13}, {"x87", 16}, {"f128", 30}, {"dd", 28}, {"mpfr:60", 57}}) {
      const FloatFormat format = float_format(name);
      const auto run = float_run(format, q);
      for (int n = 0; n < 25; ++n) run->step();
      const FloatQuestion s = stored(q, format);
      NumericQuestion exact;
      exact.force = s.force;
      exact.parameters = s.parameters;
      exact.h = s.h;
      exact.x0 = s.x0;
      exact.v0 = s.v0;
      exact.steps = 25;
      exact.digits = 80;
      const Ball error = numeric_motion(s.program, exact).position.ball - Ball(run->state().first.value, 400);
      CAPTURE(format.name());
      CHECK((abs(error) - Ball(Rational(1) / Rational(10).pow(digits), 400)).sign() == -1);
    }
  }
}

TEST_CASE("formats that do not exist are refused, with a suggestion") {
  CHECK(float_format("double").name() == "f64");
  CHECK(float_formats("f32, f64+kahan").size() == 2);
  const auto message = [](const char* name) {
    try {
      float_format(name);
    } catch (const BadInput& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(message("f31").find("did you mean 'f32'") != std::string::npos);
  CHECK(message("f64+kahn").find("did you mean '+kahan'") != std::string::npos);
  CHECK(message("mpfr:-5").find("from 2 to") != std::string::npos);
  CHECK(message("mpfr:5000000000").find("from 2 to") != std::string::npos);
  CHECK(message("f64+origin").find("defined for offsets in f32") != std::string::npos);
  CHECK(message("").find("there is no format") != std::string::npos);
}
