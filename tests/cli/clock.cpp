// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall clock` as a user meets it: its JSON, its CSV, its exit codes, what it says.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "analysis/algebra/rational.hpp"
#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

CommandRun clock_command(const std::string& options) { return run("clock " + options); }

nlohmann::json clock_json(const std::string& options) { return json_of("clock " + options); }

}  // namespace

TEST_CASE("clock --json carries the numbers that other programs rely on") {
  const nlohmann::json a = clock_json("--dt 0.1f --steps 1e6");
  CHECK(a["schema"] == "shortfall.clock/1");
  CHECK(a["value"] == "3230667/32");
  CHECK(a["exact"] == "100000");
  CHECK(a["error"] == "-30667/32");
  CHECK(a["freezes_at"]["value"] == "2097152");
  CHECK(a["freezes_at"]["additions"] == "18073720");
  CHECK(a["dt"]["meant"] == "1/10");
  CHECK(a["dt"]["stored"] == "13421773/134217728");
  CHECK(Rational::parse(a["representation"].get<std::string>()) +
            Rational::parse(a["rounding_error"].get<std::string>()) ==
        Rational(-30667, 32));
  CHECK(clock_json("--dt 1/60f --steps 1e18")["freezes_at"]["additions"] == "24986955");
  CHECK(clock_json("--dt 1/60f --until 24h")["steps"] == "5184000");
  CHECK(clock_json("--dt 0.1 --until 100h --format fixed:23 --rounding toward-zero")["error"] ==
        "5625/16384");
  CHECK(clock_json("--dt 0.1d --steps 3")["format"] == "f64");
  CHECK(clock_json("--dt 0.1 --steps 1e30 --format f64 --rounding up")["value"].is_null());
  CHECK(clock_json("--dt=-0.1 --x0 1 --steps 20 --format f16")["value"] == "-1025/1024");
  const nlohmann::json moves = clock_json("--dt 0.02 --velocity 3 --x0 10km --until 1h");
  CHECK(moves["unit"] == "m");
  CHECK(moves["value"] == "665401/32");
}

TEST_CASE("clock --kahan says how its value is known") {
  CHECK(clock_json("--dt 1/60f --until 24h --kahan")["kahan"]["known"] == "closed form, proved");
  const nlohmann::json far = clock_json("--dt 0.1f --steps 1e12 --kahan");
  CHECK(far["kahan"]["known"] == "bounded, proved");
  CHECK(far["value"].is_null());
  CHECK(clock_json("--dt 0.1f --steps 6e6 --format f32+kahan")["kahan"]["known"] == "stepped through");
  CHECK(contains(clock_command("--dt 0.1f --steps 1e12 --kahan").text(), "a bound, proved"));
}

TEST_CASE("clock --kahan carries out what is too wide for machine integers, and ranges follow the sums") {
  const nlohmann::json one = clock_json("--dt 1/128 --steps 1 --x0 2e38 --kahan");
  CHECK(one["kahan"]["known"] == "stepped through");
  const nlohmann::json many = clock_json("--dt 0.1f --steps 100000 --x0 1e30 --kahan --rounding up");
  CHECK(many["kahan"]["known"] == "stepped through");
  float s = 1e30F, c = 0;  // to nearest: nothing is ever lost from c but what rounding takes
  for (int i = 0; i < 1000; ++i) {
    volatile float y = 0.1F - c, t = s + y;
    volatile float moved = t - s;
    c = moved - y;
    s = t;
  }
  const nlohmann::json near = clock_json("--dt 0.1f --steps 1000 --x0 1e30 --kahan");
  CHECK(Rational::parse(near["value"].get<std::string>()).to_float() == s);
  const std::string falling = clock_command("--dt -0.1 --x0 50 --steps 600").text();
  for (const char* range : {"64 to 32 ", "32 to 8 ", "2 to 0.5 ", "-0.25 to -0.5 "})
    CHECK(contains(falling, range));
  CHECK(contains(clock_command("--dt 0.1 --x0 -50 --steps 600 --format f16 --rounding up").text(),
                 "-16 to -2 "));
}

TEST_CASE("clock --csv has a line for each spacing, consecutive, up to where the clock stops") {
  const CommandRun o = clock_command("--dt 1/60f --steps 1 --csv");
  CHECK(o.code == 0);
  CHECK(o.error.empty());
  CHECK(o.out.starts_with("sums_from,sums_to,first_addition,"));
  CHECK(contains(o.out, ",16598347,24986955,1/32,"));
  CHECK(std::ranges::count(o.out, '\n') == 26);
}

TEST_CASE("clock in ASCII has no other characters, and 10^18 additions are said to have stopped") {
  const CommandRun o = clock_command("--dt 0.1f --steps 1e18 --ascii");
  CHECK(o.code == 0);
  const std::string text = o.text();
  CHECK(std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; }));
  CHECK(contains(text, "2^21 = 2097152 s, after 18073720 additions"));
}

TEST_CASE("clock refuses what has no answer, with the documented exit codes") {
  for (const char* options :
       {"--dt nan --steps 1", "--dt inf --steps 1", "--dt 0 --steps 1", "--dt 1e60 --steps 1",
        "--dt 1e-60 --steps 1", "--dt 0.1 --steps -5", "--dt 0.1 --steps 2.5", "--dt 0.1 --steps nan",
        "--dt 0.1", "--dt 0.1 --steps 1 --until 1h", "--steps 5", "--dt 0.1 --steps 1 --velocity 0",
        "--dt 0.1 --until -3", "--dt 0.1 --steps 1 --rounding odd",
        "--dt 0.1 --steps 1 --format f32+fma --kahan", "--dt 0.1 --steps 1 --format fixed:99",
        "--dt 0.1 --steps 1 --format fixed:9 --kahan"}) {
    INFO(options);
    const CommandRun o = clock_command(options);
    CHECK(o.code == 2);
    CHECK(o.text().starts_with("shortfall: "));
    CHECK(std::ranges::count(o.text(), '\n') == 1);
  }
  CHECK(contains(clock_command("--dt 0.1 --steps 5 --format f23").text(), "did you mean 'f32'?"));
  CHECK(contains(clock_command("--dt 0.1 --step 5").text(), "did you mean '--steps'?"));
  CHECK(clock_command("--dt 0.1 --steps 5 --format dd").code == 4);
  CHECK(clock_command("--dt 0.1 --steps 1e18 --format mpfr:3 --rounding up").code == 4);
  CHECK(clock_command("--dt 0.1 --steps 5 -o /nonexistent/clock.txt").code == 5);
}

}  // namespace shortfall
