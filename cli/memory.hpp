// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace shortfall::cli {

/// The option --max-memory: what the trees of a series may take.
void add_memory(CLI::App& command, std::string& memory);

/// "500MB", "2GB", "300000000": bytes.
///
/// throws  BadInput  for what is no positive amount of memory
double memory_of(const std::string& text);

}  // namespace shortfall::cli
