// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages, written from the same words as the help.
#include <fmt/format.h>

#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/output_folder.hpp"
#include "cli/word_list.hpp"

namespace shortfall::cli {

namespace {

struct Code {
  int code;
  const char* what;
};
constexpr Code kCodes[] = {
    {kDone, "done, and what was asked holds"},
    {kRefuted, "what was claimed is refuted"},
    {kUsage, "the command line makes no sense"},
    {kBadFile, "a file makes no sense"},
    {kNotDerivable, "there is no such thing, or we cannot derive it; the reason is said"},
    {kInputOutput, "a file could not be read or written"},
    {kBug, "a bug of shortfall"}};

/// roff takes a backslash, a hyphen and a dot or quote at the beginning of a line for more than they are.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
      continue;
    }
    if (c == '-') result += '\\';
    if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += "\\&";
    result += c;
  }
  return result;
}

std::string title(const std::string& name) {
  std::string upper;
  for (const char c : name) upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return ".TH " + roff(upper) + " 1 \"\" \"shortfall " SHORTFALL_VERSION "\" \"User Commands\"\n";
}

std::string option_text(const WordOption& o) {
  std::string text = ".TP\n";
  std::string names;
  for (const std::string& n : o.names) names += (names.empty() ? "\\fB" : ", \\fB") + roff(n) + "\\fR";
  if (!o.argument.empty()) names += (names.empty() ? "\\fI" : " \\fI") + roff(o.argument) + "\\fR";
  return text + names + "\n" + roff(o.about) + "\n";
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const Code& c : kCodes) text += fmt::format(".TP\n.B {}\n{}\n", c.code, roff(c.what));
  return text;
}

std::string of_all(const std::vector<WordCommand>& commands) {
  std::string text = title("shortfall");
  text += ".SH NAME\nshortfall \\- the exact error of time integrators, and how to repair it\n";
  text += ".SH SYNOPSIS\n.B shortfall\n.I COMMAND\n.RI [ OPTIONS ]\n";
  text +=
      ".SH DESCRIPTION\nshortfall derives the exact discrete motion of a time integrator, its shortfall "
      "against the\n"
      "true motion and the corrections that remove it, each with a proof; it measures rounding, speed and\n"
      "stability, and writes the results as code, pages, notebooks and LaTeX.\n";
  std::string group;
  for (const WordCommand& c : commands) {
    if (c.group != group) text += ".SH " + roff(group = c.group) + "\n";
    text += ".TP\n.BR shortfall\\-" + roff(c.name) + " (1)\n" + roff(c.about) + "\n";
  }
  return text + exit_status();
}

std::string of_one(const WordCommand& c) {
  std::string text = title("shortfall-" + c.name);
  std::string about = c.about;
  while (about.ends_with('.')) about.pop_back();
  text += ".SH NAME\nshortfall\\-" + roff(c.name) + " \\- " + roff(about) + "\n";
  text += ".SH SYNOPSIS\n.B shortfall " + roff(c.name) + "\n.RI [ OPTIONS ]\n";
  std::string arguments, options;
  for (const WordOption& o : c.options) {
    if (o.names.empty()) text += ".RI [ " + roff(o.argument) + " ]\n";
    (o.names.empty() ? arguments : options) += option_text(o);
  }
  text += ".SH DESCRIPTION\n" + roff(c.about) + "\n";
  if (!arguments.empty()) text += ".SH ARGUMENTS\n" + arguments;
  if (!options.empty()) text += ".SH OPTIONS\n" + options;
  text += ".SH EXAMPLES\n.nf\n";
  for (const std::string& e : c.examples) text += roff(e) + "\n";
  return text + ".fi\n" + exit_status() + ".SH SEE ALSO\n.BR shortfall (1)\n";
}

}  // namespace

std::string manual(const std::vector<WordCommand>& commands, const std::string& command) {
  if (command.empty()) return of_all(commands);
  std::vector<std::string> names;
  for (const WordCommand& c : commands) {
    if (c.name == command) return of_one(c);
    names.push_back(c.name);
  }
  throw BadInput("unknown command '" + command.substr(0, 40) + "'" + did_you_mean(command, names));
}

void add_manual(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Set-up", "manual", "A manual page in roff, of shortfall or of one command.",
                  {"manual | man -l -", "manual jump | man -l -", "manual --all -o man1/"});
  struct Words {
    std::string command, output;
    bool all = false, overwrite = false;
  };
  auto o = std::make_shared<Words>();
  command->add_option("COMMAND", o->command, "the command; shortfall itself unless given");
  command->add_flag("--all", o->all, "every page, into the folder of --output");
  command->add_flag("--overwrite", o->overwrite, "replace pages in a folder that exists");
  command->add_option("-o,--output", o->output, "write to this file, or with --all into this folder")
      ->type_name("PATH");
  command->callback([o, &app] {
    const std::vector<WordCommand> commands = word_list(app);
    if (!o->all) {
      if (o->overwrite) throw BadInput("--overwrite goes with --all");
      return write_output(manual(commands, o->command), o->output);
    }
    if (o->output.empty() || !o->command.empty())
      throw BadInput("--all takes a folder and no command: shortfall manual --all -o man1/");
    std::map<std::string, std::string> pages{{"shortfall.1", manual(commands, "")}};
    for (const WordCommand& c : commands) pages["shortfall-" + c.name + ".1"] = manual(commands, c.name);
    write_folder(pages, o->output, o->overwrite);
  });
}

}  // namespace shortfall::cli
