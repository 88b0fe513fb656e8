// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "analysis/identify/identification.hpp"

namespace shortfall::cli {

/// The options of commands that read a log, as the user typed them.
struct LogWords {
  std::string dt, g, up, body;
  std::vector<std::string> columns;

  LogOptions log_options() const;                          ///< throws BadInput
  IdentifyOptions identify_options(const Log& log) const;  ///< throws BadInput
};

void add_log_words(CLI::App& command, LogWords& words);

}  // namespace shortfall::cli
