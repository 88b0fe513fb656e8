// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall stability --dt`: steps whose damping depends on the frame.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

/// v = s v - y x, x = x + v in units of the step: stable until z^2 = 2 (1 + s), where an eigenvalue is -1.
double limit_of(double share) { return std::sqrt(2 * (1 + share)); }

double limit(const nlohmann::json& json) { return std::stod(json["limit"]["decimal"].get<std::string>()); }

TEST_CASE("an engine that damps is judged for the frame that is given") {
  const auto godot = json_of("stability godot --dt 1/60");
  CHECK(godot["dt"] == "1/60");
  CHECK(godot["rounded"].empty());
  CHECK(godot["determinant"] == "599/600");
  CHECK(limit(godot) == doctest::Approx(limit_of(1 - 0.1 / 60)).epsilon(1e-14));
  const auto bullet = json_of("stability bullet --param c=0.3 --dt 20ms");
  CHECK(bullet["rounded"][0] == "pow(7/10, 1/50)");
  CHECK(limit(bullet) == doctest::Approx(limit_of(std::pow(0.7, 0.02))).epsilon(1e-14));
  // The frame's length matters: a second instead of a sixtieth.
  CHECK(limit(json_of("stability bullet --param c=0.3 --dt 1")) ==
        doctest::Approx(limit_of(0.7)).epsilon(1e-14));
  // Four substeps of dt/4 each, and the limit counts frames.
  const auto substeps = json_of("stability bullet --param c=0.3 --dt 20ms --substeps 4");
  CHECK(substeps["rounded"][0] == "pow(7/10, 1/200)");
  CHECK(limit(substeps) == doctest::Approx(4 * limit_of(std::pow(0.7, 0.005))).epsilon(1e-14));
}

TEST_CASE("where the frame does not matter, giving it changes no limit") {
  for (const char* engine :
       {"symplectic-euler", "rk4", "velocity-verlet", "leapfrog", "physx", "forest-ruth"}) {
    CAPTURE(engine);
    const auto free = json_of("stability " + std::string(engine));
    const auto given = json_of("stability " + std::string(engine) + " --dt 1/7");
    CHECK(free["dt"].is_null());
    CHECK(free["limit"] == given["limit"]);
    CHECK(free["windows"] == given["windows"]);
    CHECK(free["drag"]["windows"] == given["drag"]["windows"]);
  }
}

TEST_CASE("without the frame the answer is a refusal that names --dt; a frame is longer than 0") {
  for (const char* engine : {"godot", "cannon-es"}) {
    const CommandRun o = run("stability " + std::string(engine));
    CHECK(o.code == 4);
    CHECK(contains(o.error, "--dt"));
  }
  CHECK(run("stability godot --dt 0").code == 2);
  CHECK(run("stability godot --dt -1/60").code == 2);
  CHECK(run("stability godot --dt soon").code == 2);
  const CommandRun o = run("stability cannon-es --dt 60Hz");
  CHECK(o.code == 0);
  CHECK(contains(o.out, "for dt = 1/60 s"));
  CHECK(contains(o.out, "pow(99/100, 1/60) was rounded to 100 digits"));
  CHECK_FALSE(contains(o.out, "No number was rounded"));
}

}  // namespace
}  // namespace shortfall
