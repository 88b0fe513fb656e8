// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace shortfall::cli {

/// One option or argument of a command, as the help has it.
struct WordOption {
  std::vector<std::string> names;  ///< "--height", "-o"; empty for an argument that stands alone
  std::string argument;            ///< "H", "FILE"; empty for a flag
  std::string about;               ///< one line
  bool file = false;               ///< a path is expected
  bool integrator = false;         ///< the name of an integrator, or a file of one
};

/// A command of the help: what completion and manual pages are written from.
struct WordCommand {
  std::string name, group;
  std::string about;  ///< one sentence
  std::vector<std::string> examples;
  std::vector<WordOption> options;
};

/// All commands, in the order of the help.
std::vector<WordCommand> word_list(const CLI::App& app);

/// A completion file for a shell.
///
/// throws  BadInput  for another shell than bash, zsh and fish
std::string completion(const std::vector<WordCommand>& commands, const std::string& shell);

/// A manual page in roff (man(7)): of one command, or of shortfall where it is empty.
///
/// throws  BadInput  for an unknown command
std::string manual(const std::vector<WordCommand>& commands, const std::string& command);

}  // namespace shortfall::cli
