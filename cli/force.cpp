// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/force.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"
#include "cli/quantity.hpp"

namespace shortfall::cli {

int force_degree(const std::string& text) {
  if (text == "constant") return 0;
  if (text.starts_with("poly:")) {
    std::int64_t degree = -1;
    if (!quantity(text.substr(5), Unit::none, "--force poly:").fits_int64(degree) || degree < 0 ||
        degree > 1000)
      throw BadInput("--force '" + text.substr(0, 60) + "': the degree is a whole number from 0 to 1000");
    return static_cast<int>(degree);
  }
  throw BadInput("unknown force '" + text.substr(0, 60) + "'" + did_you_mean(text, {"constant", "poly:1"}) +
                 "; the forces are constant and poly:D");
}

}  // namespace shortfall::cli
