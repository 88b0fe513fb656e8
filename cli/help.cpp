// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/help.hpp"

#include <algorithm>

#include "analysis/program/suggest.hpp"
#include "cli/word_list.hpp"

#ifndef SHORTFALL_VERSION
#define SHORTFALL_VERSION "0"
#endif

namespace shortfall::cli {

void describe(CLI::App& app) {
  app.name("shortfall");
  app.description(
      "Examples:\n"
      "  shortfall jump --height 40cm --dt 0.02\n"
      "  shortfall derive symplectic-euler --force constant\n"
      "  shortfall correct rk4 --force poly:3\n\n"
      "The exact error of time integrators: what it is, why, and how to repair it.");
  app.set_version_flag("--version", "shortfall " SHORTFALL_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
}

namespace {

/// All commands, a line each; what each can do is for its own help.
std::string overview(const CLI::App& app) {
  constexpr std::size_t kNames = 12;
  std::string text = app.get_description() + "\n\nUsage: shortfall COMMAND [OPTIONS]\n";
  std::string group;
  for (const WordCommand& c : word_list(app)) {
    if (c.group != group) text += "\n" + (group = c.group) + ":\n";
    text += "  " + c.name + std::string(kNames - std::min(kNames - 1, c.name.size()), ' ') + c.about + "\n";
  }
  return text +
         "\n  shortfall COMMAND --help   what a command can do, with examples\n"
         "  shortfall --version        the version; with --json also of what it is built with\n";
}

}  // namespace

std::string help(const CLI::App& app) {
  const CLI::App* asked = &app;
  while (!asked->get_subcommands().empty()) asked = asked->get_subcommands().front();
  return asked == &app ? overview(app) : asked->help("shortfall");
}

std::string unknown_word(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = nullptr;
  const std::vector<const CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  std::vector<std::string> commands;
  for (const CLI::App* c : all) commands.push_back(c->get_name());
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (!command && !word.starts_with("-")) {
      const auto found = std::ranges::find(commands, word);
      if (found != commands.end()) command = all[static_cast<std::size_t>(found - commands.begin())];
      if (!command)
        return "unknown command '" + word + "'" + did_you_mean(word, commands) +
               " (shortfall --help lists all)";
      continue;
    }
    if (word == "--") break;
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    const CLI::App& where = command ? *command : app;
    if (where.get_option_no_throw(name)) continue;
    std::vector<std::string> options;
    for (const CLI::Option* o : where.get_options())
      for (const std::string& l : o->get_lnames()) options.push_back("--" + l);
    return "unknown option '" + name + "'" + did_you_mean(name, options) +
           (command ? " (shortfall " + command->get_name() + " --help lists all)" : "");
  }
  return "";
}

std::string sentence(const CLI::ParseError& error) {
  std::string text = error.what();
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  if (text == "A subcommand is required") text = "which command? shortfall --help lists all";
  return text;
}

}  // namespace shortfall::cli
