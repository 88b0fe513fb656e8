// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/word_list.hpp"

#include <sstream>

namespace shortfall::cli {

namespace {

std::string one_line(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c != '\n')
      result += c;
    else if (!result.ends_with(' '))
      result += ' ';
  return result;
}

WordOption option(const CLI::Option& o) {
  WordOption result;
  for (const std::string& s : o.get_snames()) result.names.push_back("-" + s);
  for (const std::string& l : o.get_lnames()) result.names.push_back("--" + l);
  if (o.get_expected_max() != 0 || result.names.empty()) result.argument = o.get_type_name();
  if (result.names.empty()) result.argument = o.get_name();
  result.about = one_line(o.get_description());
  result.file = o.get_type_name() == "FILE" || o.get_type_name() == "FOLDER" || o.get_type_name() == "PATH";
  const std::string name = o.get_name();
  result.integrator = name == "INTEGRATOR" || name == "FROM" || name == "TO";
  return result;
}

}  // namespace

std::vector<WordCommand> word_list(const CLI::App& app) {
  std::vector<WordCommand> commands;
  for (const CLI::App* c : app.get_subcommands([](const CLI::App*) { return true; })) {
    WordCommand command;
    command.name = c->get_name();
    command.group = c->get_group();
    // The description is written as: Examples, a line each; an empty line; what it does.
    std::istringstream lines(c->get_description());
    bool examples = false;
    for (std::string line; std::getline(lines, line);) {
      if (line == "Examples:") {
        examples = true;
      } else if (examples && line.starts_with("  ")) {
        command.examples.push_back(line.substr(2));
      } else if (!line.empty()) {
        command.about += (command.about.empty() ? "" : " ") + line;
      }
    }
    for (const CLI::Option* o : c->get_options())
      if (o != c->get_help_ptr()) command.options.push_back(option(*o));
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace shortfall::cli
