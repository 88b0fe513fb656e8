// SPDX-License-Identifier: GPL-3.0-or-later
// What verify says of formulas that have no value at some n.
#include <doctest/doctest.h>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE("verify claims nothing where a formula divides by zero") {
  const CommandRun all = run("verify symplectic-euler --x \"x0 + v0*t + 1/2*a*t^2*(n + 1)/n\"");
  CHECK(all.code == 0);
  CHECK(contains(all.out, "every n >= 0 except n = 0, where it divides by zero, and all values"));
  // Refuted by the start: what is proved of the rest leaves n = 5 out, and not n = 0, which comes before.
  const std::string formula = "x0 + v0*t + 1/2*f0*t^2 + 1/6*f1*t^3 - 5/12*f1*h^2*t + 1/4*f1*h^3";
  const auto with = [&](const std::string& factor) {
    const CommandRun o =
        run("verify adams-bashforth-2 --force poly:1 --x \"(" + formula + ")" + factor + "\"");
    CHECK(o.code == 1);
    return o.out;
  };
  CHECK(contains(with(""), "from n = 1 on it holds (proved)"));
  CHECK(contains(with("*(n - 5)/(n - 5)"), "from n = 1 on except n = 5, where it divides by zero, it holds"));
}

}  // namespace
}  // namespace shortfall
