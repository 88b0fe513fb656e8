// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>

#include <complex>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

/// The largest |x| and |v| that 12000 steps in binary64 reach from a few starts: bounded or not, by brute
/// force.
double growth(const Program& program, double z) {
  const Tape tape = lower(program, parameter_values(program));
  double largest = 0;
  for (const auto& [x0, v0] : {std::pair{1.0, 0.0}, {0.3, 1.0}}) {
    Numbers<double> problem{[&](const double& x, const double&, const double&) { return -z * z * x; }};
    Run<Numbers<double>> run(tape, problem, 1.0);
    run.begin(x0, v0, 0.0);
    for (int n = 0; n < 12000 && largest < 1e12; ++n) {
      run.step();
      largest = std::max({largest, std::abs(run.state(0)), std::abs(run.state(1))});
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("limits of the literature") {
  const auto limit = [](const char* name) { return stability_limit(find_integrator(name)); };
  for (const char* name : {"symplectic-euler", "symplectic-euler-drift-kick", "velocity-verlet",
                           "position-verlet", "leapfrog", "stoermer-verlet"}) {
    CAPTURE(name);
    REQUIRE(limit(name));
    CHECK(limit(name)->decimal(20) == "2.00000000000000000000");
  }
  REQUIRE(limit("rk4"));
  CHECK(limit("rk4")->decimal(40) == "2.8284271247461900976033774484193961571393");
  REQUIRE(limit("explicit-euler"));
  CHECK(limit("explicit-euler")->decimal(3) == "0.000");
  CHECK_FALSE(limit("implicit-midpoint"));
}

TEST_CASE("just inside the limit 12000 steps stay bounded, outside they do not: the whole catalogue" *
          doctest::test_suite("thorough")) {
  int checked = 0;
  for (const Program& p : testing::undamped_catalogue()) {
    const auto limit = stability_limit(p);
    if (!limit || limit->decimal(3) == "0.000") continue;  // none: always stable; 0: never
    CAPTURE(p.name);
    const double z = std::stod(limit->decimal(17));
    CHECK(growth(p, z * 0.999) < 1e6);
    // Some are stable again further out: half the way to there.
    const Windows windows = oscillator_windows(p);
    const bool again = windows.windows.size() > 1;
    const double beyond = again ? (z + windows.windows[1].from->at.to_double()) / 2 : 1.5 * z;
    CHECK(growth(p, beyond) > (again ? 100 : 1e9));  // a narrow hole is left slowly
    ++checked;
  }
  CHECK(checked > 10);
}
