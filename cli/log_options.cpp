// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/log_options.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "cli/quantity.hpp"

namespace shortfall::cli {

LogOptions LogWords::log_options() const {
  LogOptions options;
  options.body = body;
  for (const std::string& words : columns)
    for (std::size_t begin = 0; begin <= words.size();) {
      const std::size_t end = std::min(words.find(',', begin), words.size());
      const std::string word = words.substr(begin, end - begin);
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos || equals == 0)
        throw BadInput("--columns '" + word.substr(0, 60) +
                       "': write THING=NAME, as in --columns y=height,vy=speed");
      if (!options.columns.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
        throw BadInput("--columns gives " + word.substr(0, equals) + " twice");
      begin = end + 1;
    }
  return options;
}

IdentifyOptions LogWords::identify_options(const Log& log) const {
  IdentifyOptions options;
  if (!dt.empty()) options.dt = positive_quantity(dt, Unit::time, "--dt");
  if (!g.empty()) {
    const Rational metres = quantity(g, Unit::none, "--g");
    if (metres.sign() < 0) throw BadInput("--g " + g.substr(0, 40) + ": 0 or more, downwards");
    options.g = metres * log.units_in_metre;
  }
  if (!up.empty()) {
    if (up != "x" && up != "y" && up != "z") throw BadInput("--up '" + up.substr(0, 40) + "': x, y or z");
    options.up = up[0] - 'x';
    if (std::ranges::find(log.axes, *options.up) == log.axes.end())
      throw BadInput("--up " + up + ": the log has no positions on this axis");
  }
  return options;
}

void add_log_words(CLI::App& command, LogWords& words) {
  command.add_option("--dt", words.dt, "the time step: 0.02, 1/50, 20ms, 50Hz; otherwise found in the log")
      ->type_name("DT");
  command.add_option("--g", words.g, "gravity in m/s^2, positive downwards; otherwise found in the log")
      ->type_name("G");
  command.add_option("--up", words.up, "the vertical axis (y where there is one)")->type_name("AXIS");
  command.add_option("--body", words.body, "which body, by its name or number, where there are several")
      ->type_name("BODY");
  command
      .add_option("--columns", words.columns,
                  "what columns hold: time=T,y=height,vy=speed (frame, time, body, x, y, z, vx, vy, vz)")
      ->type_name("THING=NAME,...")
      ->allow_extra_args(false);
}

}  // namespace shortfall::cli
