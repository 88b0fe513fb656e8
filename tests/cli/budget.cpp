// SPDX-License-Identifier: GPL-3.0-or-later
// budget of times that are read off frames, what it says besides, and what it refuses.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/cli/command.hpp"

using namespace shortfall;

namespace {

nlohmann::json budget_of(const Folder& folder, const std::string& arguments) {
  const CommandRun o = folder.run("budget " + arguments + " --json");
  CAPTURE(o.error);
  REQUIRE(o.code == 0);
  return nlohmann::json::parse(o.out);
}

/// A part as a number, from an exact fraction or a decimal.
double number(const nlohmann::json& value) {
  if (!value.is_string()) return std::stod(value["decimal"].get<std::string>());
  const std::string text = value.get<std::string>();
  const std::size_t slash = text.find('/');
  return slash == std::string::npos ? std::stod(text) : std::stod(text) / std::stod(text.substr(slash + 1));
}

}  // namespace

TEST_CASE("budget --landing and --periods: the parts add up") {
  const Folder folder;
  for (const char* question :
       {"symplectic-euler --height 1.7 --dt 0.02f --landing --formats f16,f32,f64,mpfr:40",
        "velocity-verlet --force spring:k=40 --dt 1/60f --periods 2 --formats bf16+kahan,f32,f64",
        "gauss4 --force damped-spring:k=9,c=1/2 --dt 1/30 --periods 1 --formats f64"}) {
    CAPTURE(question);
    const auto j = budget_of(folder, question);
    for (const auto& b : j["budgets"]) {
      const auto& q = b["quantities"][0];
      CHECK(q["unit"] == "s");
      CHECK(q["closes"] == true);
      const double sum =
          number(q["sampling"]) + number(q["method"]) + number(q["representation"]) + number(q["rounding"]);
      CHECK(std::abs(sum - number(q["observed"])) <= 1e-12 * (std::abs(number(q["method"])) + std::abs(sum)));
      CHECK(!b["remedies"].empty());
      for (const auto& r : b["remedies"]) CHECK(r["becomes"].is_null() == false);
    }
  }
  CHECK(budget_of(folder, "--force spring:k=1 --periods 3")["budgets"][0]["periods"] == 3);
}

TEST_CASE("budget says where rounding begins, and what it is as tracked beside the run") {
  const Folder folder;
  const auto j = budget_of(
      folder,
      "symplectic-euler --force spring:k=1 --dt 1/10 --steps 1000 --formats f32,f64,f64+tozero,mpfr:30");
  for (const auto& b : j["budgets"]) {
    CHECK(b["first_rounding"]["step"] == 1);
    CHECK(b["first_rounding"]["line"].get<int>() > 0);
    CHECK(contains(b["first_rounding"]["statement"].get<std::string>(), " = "));
    const std::string format = b["format"].get<std::string>();
    const bool tracked = format == "f32" || format == "f64";
    CHECK(b["rounding_tracked"].is_null() == !tracked);
    if (!tracked) continue;
    const double exact = number(b["quantities"][0]["rounding"]);
    CHECK(std::abs(b["rounding_tracked"]["x"].get<double>() - exact) <= 1e-11 * std::abs(exact));
  }
  const auto dyadic =
      budget_of(folder, "velocity-verlet --force constant:a=-8 --dt 1/64 --v0 5/2 --steps 100");
  CHECK(dyadic["budgets"][0]["first_rounding"].is_null());
  CHECK(dyadic["budgets"][0]["rounding_tracked"]["x"] == 0);
  CHECK(contains(folder.run("budget --force spring:k=1 --dt 1/10 --steps 9 --formats f32").out,
                 "f32: the first rounding is in step 1, line "));
}

TEST_CASE("budget refuses what has no answer, with one sentence and the documented code") {
  const Folder folder;
  for (const auto& [line, code, sentence] :
       {std::tuple{"--landing", 2, "--landing is that of a jump"},
        {"--periods 2 --height 1", 2, "--periods asks for the time of an oscillation"},
        {"--periods 0 --force spring:k=1", 2, "a whole number from 1 to 100000"},
        {"--periods nan --force spring:k=1", 2, "this is not a number"},
        {"--periods 1", 4, "a period needs a spring"},
        {"--periods 1 --force spring:k=1 --dt 4", 4, "less than two frames in a period"},
        {"--periods 1 --force damped-spring:k=1,c=2", 4, "nothing oscillates"},
        {"--height 1mm --landing", 4, "does not leave the ground"},
        {"--steps 10 --force general", 4, "neither the map nor the motion is known exactly"},
        {"--steps 10 --force expr:-x^3", 4, "neither the map nor the motion is known exactly"},
        {"--steps 1e18 --force spring:k=1", 4, "takes 634 years or more"},
        {"--steps 1e400", 4, "thousands of years"},
        {"--steps 10 --dt inf", 2, "this is not a number"},
        {"--steps 10 --dt -1", 2, "greater than 0"},
        {"--steps 10 --formats mpfr:1000000000", 2, "from 2 to 100000"}}) {
    const std::string arguments = line;
    CAPTURE(arguments);
    const CommandRun o = folder.run("budget " + arguments + " -o out.txt");
    CHECK(o.code == code);
    CHECK(contains(o.error, sentence));
    CHECK(o.out.empty());
    CHECK_FALSE(folder.has("out.txt"));
  }
}
