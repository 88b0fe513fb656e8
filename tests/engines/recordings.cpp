// SPDX-License-Identifier: GPL-3.0-or-later
// The recordings and the arithmetic they are replayed in.
#include <doctest/doctest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/components.hpp"
#include "tests/engines/recording.hpp"
#include "tests/scratch_folder.hpp"

namespace shortfall::engines {
namespace {

namespace fs = std::filesystem;

/// A folder of one recording.
struct Folder : ScratchFolder {
  /// Why the folder is refused, with one recording of these lines.
  std::string refusal(const std::string& lines, const std::string& precision = "float32") const {
    write("manifest.json",
          R"({"entries": [{"file": "one.csv", "engine": "ode", "kind": "velocity", "dt": 0.02,
                               "precision": ")" +
              precision + "\"}]}");
    write("one.csv", "frame,time,x,y,z,vx,vy,vz\n" + lines);
    try {
      recordings(root());
    } catch (const Error& e) {
      return std::string(e.what()).substr(root().string().size() + 1);
    }
    return {};
  }
};

TEST_CASE("every recording has 40 rows, and begins with the launch that it was given") {
  const auto all = recordings(SHORTFALL_SOURCE_DIR "/tests/data/recordings");
  CHECK(all.size() == 95);
  for (const Recording& r : all) {
    CAPTURE(r.file);
    CHECK(r.rows.size() == 40);
    // Engines with a speed limit apply it at once or in the first step.
    if ((r.kind != "velocity" && r.kind != "force") || r.maximal_speed != 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double given = r.precision == "float64" ? r.launch[i] : static_cast<float>(r.launch[i]);
      CHECK(r.rows[0].v[i] == given);
    }
  }
}

TEST_CASE("a recording without sense is refused, with its place") {
  const Folder folder;
  CHECK(folder.refusal("0,0,0,0,0,0,1,0\n1,0.02,0,0.02,0,0,1,0\n").empty());
  CHECK(folder.refusal("0,0,0,0,0,0,1,0\n") == "one.csv: has no second frame");
  CHECK(folder.refusal("0,0,0,0,0,0,1,0\n1,0.02,0,0.02,0,0,1\n") == "one.csv:3: has 7 cells, not 8");
  CHECK(folder.refusal("0,0,0,0,0,0,up,0\n1,0.02,0,0.02,0,0,1,0\n") == "one.csv:2: 'up' is no number");
  folder.write("manifest.json", "{\"entries\": [{}]}");
  CHECK_THROWS_AS(recordings(folder.root()), BadInput);
  folder.write("manifest.json", "{");
  CHECK_THROWS_AS(recordings(folder.root()), BadInput);
  fs::remove(folder.root() / "manifest.json");
  CHECK_THROWS_AS(recordings(folder.root()), UnreadableFile);
}

TEST_CASE("binary32 is read with one rounding") {
  // Half way between two floats, and a little more: a binary64 loses the little, and would then round to
  // even.
  const Folder folder;
  CHECK(folder.refusal("0,0,1.00000005960464477540,0,0,0,0,0\n1,0,0,0,0,0,0,0\n").empty());
  CHECK(recordings(folder.root())[0].rows[0].x[0] == 1.00000011920928955078125);
}

TEST_CASE("each way of adding gravity and a force rounds as it says") {
  using Vector = Components<float, float>;
  const float g = -9.81F, h = 1.0F / 60;
  std::map<Adding, std::vector<float>> seen;
  for (int i = 100; i < 300; ++i) {
    const float f = static_cast<float>(i - 200) / 10, v = static_cast<float>(i) / 100;
    const auto stepped = [&](Adding adding) {
      const float result = (Vector({v, 0, 0}) + h * Vector({g, 0, 0}, {f, 0, 0}, adding)).parts()[0];
      seen[adding].push_back(result);
      return result;
    };
    CHECK(stepped(Adding::at_once) == v + h * (g + f));
    CHECK(stepped(Adding::after_scaling) == v + (h * g + h * f));
    CHECK(stepped(Adding::gravity_first) == (v + h * g) + h * f);
    CHECK(stepped(Adding::force_first) == (v + h * f) + h * g);
  }
  std::set<std::vector<float>> different;
  for (const auto& [adding, results] : seen) different.insert(results);
  CHECK(different.size() == 4);
}

TEST_CASE("stored in binary32, computed in binary64: every operation rounds once when it is stored") {
  using Vector = Components<double, float>;
  const Vector x({0.1F, 0, 0});
  const double s = 1.0 / 3;
  CHECK((s * x).parts()[0] == static_cast<float>(s * double(0.1F)));
  CHECK((x + s * x).parts()[0] == static_cast<float>(double(0.1F) + static_cast<float>(s * double(0.1F))));
  CHECK(norm(Vector({3, 4, 0})) == 5);
}

}  // namespace
}  // namespace shortfall::engines
