// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/engines/recording.hpp"

#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "analysis/algebra/error.hpp"

namespace shortfall::engines {
namespace {

using nlohmann::json;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UnreadableFile(path.string() + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A decimal in the engine's own format: nine digits are a binary32 exactly, and reading them as a binary64
/// would round twice.
double number(std::string_view text, bool single, const std::string& where) {
  const char* const end = text.data() + text.size();
  double value = 0;
  std::from_chars_result result{};
  if (single) {
    float narrow = 0;
    result = std::from_chars(text.data(), end, narrow);
    value = narrow;
  } else {
    result = std::from_chars(text.data(), end, value);
  }
  if (result.ec != std::errc{} || result.ptr != end)
    throw BadInput(where + ": '" + std::string(text) + "' is no number");
  return value;
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;) {
    result.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  result.push_back(line);
  return result;
}

std::vector<Recording::Row> rows(const std::filesystem::path& path, bool single) {
  std::istringstream in(text_of(path));
  std::vector<Recording::Row> result;
  std::string line;
  for (int count = 1; std::getline(in, line); ++count) {
    const std::string where = path.string() + ":" + std::to_string(count);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (count == 1 || line.empty()) continue;  // the names of the columns: frame,time,x,y,z,vx,vy,vz
    const auto cell = cells(line);
    if (cell.size() != 8) throw BadInput(where + ": has " + std::to_string(cell.size()) + " cells, not 8");
    Recording::Row row;
    for (std::size_t i = 0; i < 3; ++i) {
      row.x[i] = number(cell[2 + i], single, where);
      row.v[i] = number(cell[5 + i], single, where);
    }
    result.push_back(row);
  }
  if (result.size() < 2) throw BadInput(path.string() + ": has no second frame");
  return result;
}

template <class T>
T value(const json& from, const char* key, T otherwise) {
  const auto found = from.find(key);
  return found == from.end() || found->is_null() ? otherwise : found->get<T>();
}

/// The engines' options, under the names that the recorder gave them.
void read_options(const json& options, Recording& r) {
  for (const char* key : {"substeps", "collisionSteps", "iters"})
    r.substeps = value(options, key, r.substeps);
  r.smears = value(options, "extForcesEveryIter", false);
  if (r.smears) r.substeps = value(options, "posIters", 4);
  if (const int extra = value(options, "extraIters", 0)) r.substeps = (r.substeps ? r.substeps : 4) + extra;
  r.maximal_speed = value(options, "maxLinVel", 0.0);
  r.default_damping = value(options, "defaultDamping", false);
  r.explicit_damping = !value(options, "eulerdamp", true);
}

Recording read(const json& entry, const std::filesystem::path& folder) {
  Recording r;
  r.file = entry.at("file").get<std::string>();
  r.engine = entry.at("engine").get<std::string>();
  r.precision = entry.at("precision").get<std::string>();
  r.kind = entry.at("kind").get<std::string>();
  r.mass = value(entry, "mass", 1.0);
  r.damping = value(entry, "damping", 0.0);
  r.gravity = {0, -value(entry, "g", 0.0), 0};
  r.launch = value(entry, "v0", Triple{});
  r.force = value(entry, "force", Triple{});
  r.stiffness = value(entry, "k", 0.0);
  r.attraction = value(entry, "mu", 0.0);
  r.steps = value(entry, "dt_list", std::vector<double>{});
  if (r.steps.empty()) r.steps = {entry.at("dt").get<double>()};
  r.claimed = value(value(entry, "verified", json::object()), "bit_exact", false);
  read_options(value(entry, "opts", json::object()), r);
  r.rows = rows(folder / r.file, r.precision == "float32");
  if (r.steps.size() > 1 && r.steps.size() + 1 < r.rows.size())
    throw BadInput(r.file + ": has more frames than steps");
  return r;
}

}  // namespace

std::vector<Recording> recordings(const std::filesystem::path& folder) {
  const std::filesystem::path manifest = folder / "manifest.json";
  const std::string text = text_of(manifest);
  try {
    const json whole = json::parse(text);
    std::vector<Recording> result;
    for (const json& entry : whole.at("entries")) result.push_back(read(entry, folder));
    return result;
  } catch (const json::exception& e) {
    throw BadInput(manifest.string() + ": " + e.what());
  }
}

}  // namespace shortfall::engines
