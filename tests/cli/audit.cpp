// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall audit` as a user meets it: what it says, its JSON, its exit codes.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

const std::string kData = std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/";

}  // namespace

TEST_CASE("audit of a method whose claims hold ends with 0, and every claim is proved in the JSON") {
  Asked f("audit");
  const auto json = f.json("'" + kData + "methods/dormand-prince-54.json'");
  CHECK(f.code == 0);
  CHECK(json["schema"] == "shortfall.audit/1");
  CHECK(json["exact"] == true);
  CHECK(json["mends"].empty());
  CHECK(json["claims"].size() >= 6);
  for (const auto& claim : json["claims"]) {
    CHECK(claim["holds"] == true);
    CHECK(claim["proved"] == true);
  }
}

TEST_CASE("audit of a misprint ends with 1, and says what is true and what was probably meant") {
  Asked f("audit");
  const std::string file = "'" + kData + "misprints/fehlberg-45-numerator.json'";
  const auto json = f.json(file);
  CHECK(f.code == 1);
  const auto& mend = json["mends"][0];
  CHECK(mend["kind"] == "entry");
  CHECK(mend["changes"][0] ==
        nlohmann::json({{"where", "A[6][3]"}, {"printed", "-3554/2565"}, {"right", "-3544/2565"}}));
  CHECK(mend["slip"] == "a digit is wrong");
  CHECK(mend["restores"] == "every claim");
  CHECK(mend["certainty"] == "probable");
  CHECK(json["claims"][0]["claim"] == "c = A 1");
  CHECK(json["claims"][0]["holds"] == false);
  f.run(file);
  CHECK(f.code == 1);
  CHECK(contains(f.out, "1  A[6][3] = -3544/2565   (printed -3554/2565)"));
  CHECK(contains(f.out, "Probable mends"));
  f.run(file + " --ascii");
  for (const char c : f.out) REQUIRE(static_cast<unsigned char>(c) < 128);
  f.run(file + " -o said");
  CHECK(f.code == 1);
  CHECK(f.out.empty());
  CHECK(contains(f.text("said"), "A[6][3]"));
}

TEST_CASE("decimals are never called proved") {
  Asked f("audit");
  const auto json = f.json("'" + kData + "methods/tsitouras-54.json'");
  CHECK(f.code == 0);
  CHECK(json["exact"] == false);
  for (const auto& claim : json["claims"]) {
    CHECK(claim["holds"] == true);
    CHECK(claim["proved"] == false);
    CHECK(claim["digits"].get<int>() >= 10);
  }
}

TEST_CASE(
    "the order that an integrator is said to have is asked for with --order, and belongs to a class of "
    "forces") {
  Asked f("audit");
  const std::string file = "'" + kData + "misprints/ruth3-time.integrator'";
  auto json = f.json(file + " --order 3");
  CHECK(f.code == 1);
  CHECK(json["claims"].back()["claim"] == "order 3 if a(x, t)");
  CHECK(json["mends"][0]["changes"][0]["where"] == "line 7");
  CHECK(json["mends"][0]["changes"][0]["right"] == "v = v + 3/4*h*a(x, v, t + 2/3*h)");
  // Where no force reads the time, the wrong time is no mistake.
  f.run(file + " --order 3 --force 'a(x)'");
  CHECK(f.code == 0);
  f.run(file + " --order 99");
  CHECK(f.code == 2);
  CHECK(contains(f.error, "--order takes a whole number from 1 to 20"));
  f.run(file + " --order 3 --force 'a(y)'");
  CHECK(f.code == 2);
}

TEST_CASE("claims of an .integrator file are decided, and a slip in its step is mended") {
  Asked f("audit");
  f.write("mine.integrator",
          "integrator mine\nstep\n  x = x + h/2*v\n  v = v - h*a(x, v, t + h/2)\n  x = x + h/2*v\n"
          "expect\n  exact 0\n  order 2 if a(x, t)\n");
  const auto json = f.json("mine.integrator");
  CHECK(f.code == 1);
  CHECK(json["mends"][0]["changes"][0]["where"] == "line 4");
  CHECK(json["mends"][0]["changes"][0]["right"] == "v = v + h*a(x, v, t + h/2)");
  CHECK(json["mends"][0]["restores"] == "every claim");
  // The kicks add up to -1: no order at all.
  bool sums = false;
  for (const auto& claim : json["claims"])
    if (claim["claim"] == "the kicks add up to 1")
      sums = claim["holds"] == false && contains(claim["found"], "-1");
  CHECK(sums);
}

TEST_CASE("kicks that do not add up to 1 are mended without any claim") {
  Asked f("audit");
  f.write("mine.integrator", "integrator mine\nsplitting\n  kick 1/2\n  drift 1\n  kick 7/5\n");
  const auto json = f.json("mine.integrator");
  CHECK(f.code == 1);
  CHECK(json["claims"][1]["claim"] == "the kicks add up to 1");
  CHECK(json["claims"][1]["holds"] == false);
  CHECK(json["claims"][1]["found"] == "the kicks add up to 19/10");
  // Either kick may be the wrong one.
  REQUIRE(json["mends"].size() == 2);
  CHECK(json["mends"][0]["changes"][0]["right"] == "kick 1/2");
  CHECK(json["mends"][0]["conditions_that_confirm"] == 0);
  CHECK(json["mends"][1]["changes"][0]["right"] == "kick -2/5");
}

TEST_CASE("an integrator that is written as a tableau is audited entry by entry") {
  Asked f("audit");
  f.write("mine.integrator",
          "integrator mine\ntableau\n  0 |\n  1/2 | 1/2\n  1/2 | 0 1/2\n  1 | 0 0 1\n  b | 1/6 1/3 1/3 1/5\n"
          "expect\n  order 4\n");
  const auto json = f.json("mine.integrator");
  CHECK(f.code == 1);
  CHECK(json["mends"][0]["changes"][0]["where"] == "b[4]");
  CHECK(json["mends"][0]["changes"][0]["right"] == "1/6");
}

TEST_CASE("what cannot be audited is refused in one sentence, with the documented exit code") {
  Asked f("audit");
  f.write("order50.json", R"({"A": [[1]], "b": [1], "order": 50})");
  f.run("order50.json");
  CHECK(f.code == 3);
  CHECK(contains(f.error, "order50.json:1:"));
  CHECK(contains(f.error, "order is at most 20"));
  for (const char* entry : {"1/3.", "", "0.3.3", "1/0", "x", "1e99999999"}) {
    CAPTURE(entry);
    f.write("bad.json", R"({"A": [[], [")" + std::string(entry) + R"("]], "b": [0, 1]})");
    f.run("bad.json");
    CHECK(f.code == 3);
    CHECK(contains(f.error, "bad.json:1:"));
  }
  f.write("sizes.json", R"({"A": [[0, 0], [1, 0]], "b": [0, 1, 2]})");
  f.run("sizes.json");
  CHECK(f.code == 3);
  f.write("empty.json", "");
  f.run("empty.json");
  CHECK(f.code == 3);
  f.run("none.json");
  CHECK(f.code == 5);
  f.run("no-such-method");
  CHECK(f.code == 2);
  f.run("");
  CHECK(f.code == 2);
  f.run("order50.json --max-memory -3");
  CHECK(f.code != 0);
}

TEST_CASE("an order that needs more memory than allowed is not decided, and ends with 4") {
  Asked f("audit");
  const auto json = f.json("'" + kData + "methods/prince-dormand-87-13m.json' --max-memory 20kB");
  CHECK(f.code == 4);
  bool undecided = false;
  for (const auto& claim : json["claims"])
    undecided = undecided || (claim["claim"] == "order 8" && claim["holds"].is_null());
  CHECK(undecided);
}

TEST_CASE("a claim of order 20 that is false is refuted at once, within little memory") {
  Asked f("audit");
  f.write("much.json",
          R"({"A": [[], ["1/2"], [0, "1/2"], [0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 1],
    [0, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 0, 0, 1]],
    "b": ["1/6", "1/3", "1/3", "1/6", 0, 0, 0, 0, 0, 0], "order": 20})");
  f.run("much.json", limited(400, 20));
  CHECK(f.code == 1);
  CHECK(contains(f.out, "refuted: order 4"));
  CHECK(contains(f.out, "order 4 instead of order 20"));
  // Many stages, and a wrong entry besides.
  std::string rows, weights;
  for (int i = 0; i < 24; ++i) {
    std::string row;
    for (int j = 0; j < i; ++j)
      row += (row.empty() ? "" : ", ") + std::string(i == 23 && j == 3 ? "\"1/7\"" : "\"1/24\"");
    rows += (i > 0 ? ", [" : "[") + row + "]";
    weights += std::string(i > 0 ? ", " : "") + "\"1/24\"";
  }
  f.write("many.json", "{\"A\": [" + rows + "], \"b\": [" + weights + "], \"order\": 20}");
  f.run("many.json", limited(400, 20));
  CHECK(f.code == 1);
  CHECK(contains(f.out, "order 1 instead of order 20"));
}

TEST_CASE("singular implicit tableaus are audited like others: their series exist") {
  Asked f("audit");
  f.write("singular.json", R"({"A": [[1, -1], [1, -1]], "b": ["1/2", "1/2"], "order": 1, "A-stable": true})");
  f.run("singular.json");
  CHECK((f.code == 0 || f.code == 1));
  CHECK(f.error.empty());
}

}  // namespace shortfall
