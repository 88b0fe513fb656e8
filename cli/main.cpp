// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"
#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"

namespace shortfall::cli {

namespace {

/// Parses, runs the command, and prints help where that was asked for.
int answer(CLI::App& app, int argc, const char* const* argv, int& code);

int run(int argc, char** argv) {
  CLI::App app;
  int code = kDone;
  describe(app);
  add_jump(app, code);
  add_derive(app, code);
  add_correct(app, code);
  add_export(app, code);
  add_verify(app, code);
  add_stability(app, code);
  add_order(app, code);
  add_modified(app, code);
  add_portrait(app, code);
  add_audit(app, code);
  add_budget(app, code);
  add_clock(app, code);
  add_cycle(app, code);
  add_extremes(app, code);
  add_trade(app, code);
  add_advise(app, code);
  add_damping(app, code);
  add_spring(app, code);
  add_identify(app, code);
  add_port(app, code);
  add_guard(app, code);
  add_list(app, code);
  add_show(app, code);
  add_new(app, code);
  add_doctor(app, code);
  add_completion(app, code);
  add_manual(app, code);

  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words == std::vector<std::string>{"--version", "--json"}) {
    write_output(version_json());
    return kDone;
  }
  if (!words.empty() && words[0] == "help") {  // as --help, which all commands have
    std::vector<const char*> asked{argv[0]};
    if (words.size() > 1) asked.push_back(argv[2]);
    asked.push_back("--help");
    return answer(app, static_cast<int>(asked.size()), asked.data(), code);
  }
  return answer(app, argc, argv, code);
}

int answer(CLI::App& app, int argc, const char* const* argv, int& code) {
  const std::string complaint = unknown_word(app, argc, argv);
  if (!complaint.empty()) {
    say("shortfall: " + complaint);
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    write_output(help(app));
  } catch (const CLI::CallForVersion& e) {
    write_output(std::string(e.what()) + "\n");
  } catch (const CLI::ParseError& e) {
    say("shortfall: " + sentence(e));
    return kUsage;
  }
  return code;
}

/// Every error that can leave a command, turned into one clear message and the documented exit code.
int guarded(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const SyntaxError& e) {
    const bool on_command_line = e.file().starts_with("--");
    say((on_command_line ? "shortfall: " : "") + std::string(e.what()));
    if (!e.context().empty()) say(e.context());
    return on_command_line ? kUsage : kBadFile;
  } catch (const BadInput& e) {
    say(std::string("shortfall: ") + e.what());
    return kUsage;
  } catch (const UnreadableFile& e) {
    say(std::string("shortfall: ") + e.what());
    return kInputOutput;
  } catch (const Error& e) {  // Undefined, Unable: the question has no answer, or none that we can derive
    say(std::string("shortfall: ") + e.what());
    return kNotDerivable;
  } catch (const OutputError& e) {
    say(std::string("shortfall: ") + e.what());
    return kInputOutput;
  } catch (const std::bad_alloc&) {
    say("shortfall: out of memory; ask for a lower degree or fewer points");
    return kNotDerivable;
  } catch (const std::exception& e) {
    say(std::string("shortfall: a bug of ours, please report it: ") + e.what());
    return kBug;
  }
}

}  // namespace

}  // namespace shortfall::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  return shortfall::cli::guarded(argc, argv);
}
