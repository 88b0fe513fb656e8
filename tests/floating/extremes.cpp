// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/extremes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

const ExtremeCase& named(const std::vector<ExtremeCase>& cases, const std::string& part) {
  const auto found = std::ranges::find_if(
      cases, [&](const ExtremeCase& c) { return (c.name + ": " + c.asked).find(part) != std::string::npos; });
  REQUIRE_MESSAGE(found != cases.end(), part);
  return *found;
}

}  // namespace

TEST_CASE("sums: the answers of binary32 and binary64 that are known") {
  const std::vector<ExtremeCase> f32 = extreme_sums(float_format("f32")),
                                 f64 = extreme_sums(float_format("f64"));
  CHECK(named(f32, "0.1 s for 1,000,000").computed == "100958.3438 s");
  CHECK(named(f32, "1/60 s for a week").computed == "524288.0000 s");
  CHECK(named(f32, "1/60 s for a week").lost);
  CHECK(!named(f64, "1/60 s for a week").lost);
  CHECK(named(f32, "Patriot").computed == "359999.6567 s");
  // The processor's own.
  float a = 77617, b = 33096, b2 = b * b, b4 = b2 * b2, b6 = b4 * b2, b8 = b4 * b4, a2 = a * a;
  const float rump = 333.75f * b6 + a2 * (11 * a2 * b2 - b6 - 121 * b4 - 2) + 5.5f * b8 + a / (2 * b);
  CHECK(named(f32, "Rump").computed == Rational::from_double(rump).significant(10));
  CHECK(named(f32, "Rump").exact == "-0.8273960599");
  double x = 4.25, before = 4;
  for (int k = 2; k <= 60; ++k) {
    const double next = 108 - (815 - 1500 / before) / x;
    before = x;
    x = next;
  }
  CHECK(named(f64, "Muller").computed == Rational::from_double(x).significant(10));
  CHECK(named(f64, "Muller").lost);
  CHECK(!named(extreme_sums(float_format("mpfr:100")), "Muller").lost);
  CHECK(!named(extreme_sums(float_format("mpfr:60")), "Rump").lost);
}

TEST_CASE("steps: far away nothing moves, at the limit two powers of n meet, beyond it numbers end") {
  const std::vector<ExtremeCase> verlet =
      extreme_steps(float_format("f32"), find_integrator("velocity-verlet"), {});
  CHECK(named(verlet, "standing still").computed == "0 m moved");
  CHECK(named(verlet, "standing still").lost);
  CHECK(!named(extreme_steps(float_format("f32+origin"), find_integrator("velocity-verlet"), {}),
               "standing still")
             .lost);
  // (-1)^n (x0 - n h v0) at h w = 2, exact in binary32.
  CHECK(named(verlet, "h w = 2 exactly").exact == "-999.00000 m");
  CHECK(named(verlet, "h w = 2 exactly").computed == "-999.00000 m");
  CHECK(named(verlet, "blowing up").computed.find("NaN from step") != std::string::npos);
  // Three substeps have the limit 6, no power of two: its neighbours are 2^-21 away on both sides.
  const Program three = parse(
      "integrator three\nstep\n  substeps 3 {\n    v = v + h*a(x, v, t)\n    x = x + h*v\n  }\n", "three");
  const std::vector<ExtremeCase> substepped = extreme_steps(float_format("f32"), three, {});
  const std::string at = named(substepped, "h w = 6 exactly").computed;
  CHECK(named(substepped, "one unit below").computed != at);
  CHECK(named(substepped, "one unit above").computed != at);
  CHECK(named(verlet, "1e0 m").lost == false);
  CHECK(named(verlet, "1e300 m").lost);
  const std::vector<ExtremeCase> wide =
      extreme_steps(float_format("f64"), find_integrator("velocity-verlet"), {});
  CHECK(!named(wide, "1e-300 m").computed.empty());
}

TEST_CASE("every integrator of the catalogue can be asked, in every format") {
  for (const Program& program : catalogue())
    for (const char* format : {"f16", "f32"}) {
      CAPTURE(program.name);
      for (const ExtremeCase& c : extreme_steps(float_format(format), program, {})) {
        CHECK(!c.exact.empty());
        CHECK(!c.computed.empty());
        CHECK(!c.why.empty());
      }
    }
}
