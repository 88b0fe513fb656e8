// SPDX-License-Identifier: GPL-3.0-or-later
// Completion files for shells, written from the same words as the help.
#include <fmt/format.h>

#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/word_list.hpp"

namespace shortfall::cli {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between = " ") {
  return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const Program& p : catalogue()) names.push_back(p.name);
  return names;
}

bool takes_integrator(const WordCommand& c) {
  for (const WordOption& o : c.options)
    if (o.integrator) return true;
  return false;
}

std::vector<std::string> option_names(const WordCommand& c) {
  std::vector<std::string> names{"--help"};
  for (const WordOption& o : c.options) names.insert(names.end(), o.names.begin(), o.names.end());
  return names;
}

std::string bash(const std::vector<WordCommand>& commands) {
  std::vector<std::string> names;
  for (const WordCommand& c : commands) names.push_back(c.name);
  std::string text =
      "# bash completion for shortfall, written by: shortfall completion bash\n_shortfall() {\n";
  text += "  local current=${COMP_WORDS[COMP_CWORD]} command='' words='' i\n";
  text += "  for ((i = 1; i < COMP_CWORD; i++)); do\n";
  text += "    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }\n  done\n";
  text += "  local integrators='" + joined(integrator_names()) + "'\n";
  text += "  case $command in\n    '') words='" + joined(names) + " --help --version' ;;\n";
  for (const WordCommand& c : commands)
    text += "    " + c.name + ") words=\"" + joined(option_names(c)) +
            (takes_integrator(c) ? " $integrators" : "") + "\" ;;\n";
  text += "  esac\n";
  text += "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n";
  text += "  [[ -z $command || $current == -* ]] || COMPREPLY+=($(compgen -f -- \"$current\"))\n";
  return text + "}\ncomplete -o filenames -F _shortfall shortfall\n";
}

/// Inside '...' of zsh's _arguments and _describe.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh(const std::vector<WordCommand>& commands) {
  std::string text = "#compdef shortfall\n# written by: shortfall completion zsh\n\n_shortfall() {\n";
  text +=
      "  local -a commands integrators\n  integrators=(" + joined(integrator_names()) + ")\n  commands=(\n";
  for (const WordCommand& c : commands) text += "    '" + c.name + ":" + zsh_text(c.about) + "'\n";
  text += "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n";
  text += "  local command=$words[2]\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const WordCommand& c : commands) {
    text += "    " + c.name + ")\n      _arguments '--help[show the help]'";
    for (const WordOption& o : c.options) {
      for (const std::string& name : o.names) {
        text += " \\\n        '*" + name + "[" + zsh_text(o.about) + "]";
        if (!o.argument.empty()) text += ":" + zsh_text(o.argument) + ":" + (o.file ? "_files" : "");
        text += "'";
      }
    }
    text += takes_integrator(c)
                ? " \\\n        '*:integrator:_alternative \"integrators:integrator:($integrators)\" "
                  "\"files:file:_files\"'"
                : " \\\n        '*:file:_files'";
    text += "\n      ;;\n";
  }
  return text + "  esac\n}\n\n_shortfall \"$@\"\n";
}

/// Inside '...' of fish.
std::string fish_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string fish(const std::vector<WordCommand>& commands) {
  std::string text = "# fish completion for shortfall, written by: shortfall completion fish\n";
  for (const WordCommand& c : commands)
    text += "complete -c shortfall -n __fish_use_subcommand -f -a " + c.name + " -d '" + fish_text(c.about) +
            "'\n";
  for (const WordCommand& c : commands) {
    const std::string when = "complete -c shortfall -n '__fish_seen_subcommand_from " + c.name + "'";
    if (takes_integrator(c)) text += when + " -a '" + joined(integrator_names()) + "'\n";
    for (const WordOption& o : c.options)
      for (const std::string& name : o.names)
        text += when + (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1)) +
                (o.argument.empty() ? ""
                 : o.file           ? " -r -F"
                                    : " -x") +
                " -d '" + fish_text(o.about) + "'\n";
  }
  return text;
}

}  // namespace

std::string completion(const std::vector<WordCommand>& commands, const std::string& shell) {
  if (shell == "bash") return bash(commands);
  if (shell == "zsh") return zsh(commands);
  if (shell == "fish") return fish(commands);
  throw BadInput("completion '" + shell.substr(0, 40) + "': we write bash, zsh and fish");
}

void add_completion(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Set-up", "completion", "Completion of commands, options and integrators for a shell.",
                  {"completion bash", "completion zsh -o _shortfall", "completion fish"});
  struct Words {
    std::string shell, output;
  };
  auto o = std::make_shared<Words>();
  command->add_option("SHELL", o->shell, "bash, zsh or fish")->required();
  command->add_option("-o,--output", o->output, "write to this file")->type_name("FILE");
  command->callback([o, &app] { write_output(completion(word_list(app), o->shell), o->output); });
}

}  // namespace shortfall::cli
