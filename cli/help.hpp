// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace shortfall::cli {

/// Name, version, groups of commands.
void describe(CLI::App& app);

/// The help of the command that was asked for, examples first.
std::string help(const CLI::App& app);

/// A sentence about an unknown command or option, with a suggestion; empty when all are known.
///
/// Looked for before anything else: otherwise a typo in an option hides behind "--height is required".
std::string unknown_word(const CLI::App& app, int argc, const char* const* argv);

/// What is wrong with the command line, as one sentence.
std::string sentence(const CLI::ParseError& error);

}  // namespace shortfall::cli
