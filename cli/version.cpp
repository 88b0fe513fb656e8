// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/version.hpp"

#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "analysis/algebra/libraries.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall::cli {

std::string version_json() {
  nlohmann::ordered_json libraries = nlohmann::ordered_json::object();
  for (const auto& [name, version] : arithmetic_libraries()) libraries[name] = version;
  libraries["boost"] = std::to_string(BOOST_VERSION / 100000) + "." +
                       std::to_string(BOOST_VERSION / 100 % 1000) + "." + std::to_string(BOOST_VERSION % 100);
  const nlohmann::ordered_json result = {
      {"schema", "shortfall.version/1"},   {"version", SHORTFALL_VERSION},
      {"compiler", SHORTFALL_COMPILER},    {"libraries", libraries},
      {"integrators", catalogue().size()}, {"licence", "GPL-3.0-or-later; what shortfall prints is yours"}};
  return result.dump(2) + "\n";
}

}  // namespace shortfall::cli
