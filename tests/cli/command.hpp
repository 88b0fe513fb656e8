// SPDX-License-Identifier: GPL-3.0-or-later
// The built command, run as a user runs it.
#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/scratch_folder.hpp"

namespace shortfall {

namespace fs = std::filesystem;

/// What a command left behind.
struct CommandRun {
  int code = 0;
  std::string out;
  std::string error;

  std::string text() const { return out + error; }
};

/// A folder that goes away, with files in which commands are run.
class Folder : public ScratchFolder {
 public:
  /// param   arguments  of the command, as a shell reads them
  /// param   before     what stands before it, such as NO_COLOR=1
  CommandRun run(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd '" + root().string() + "' && " + before + " '" + SHORTFALL_BINARY + "' " +
                                arguments + " >.out 2>.error";
    const int code = WEXITSTATUS(std::system(command.c_str()));
    return {code, text(".out"), text(".error")};
  }
};

/// One command, asked again and again in a folder; what it answered last.
class Asked : public Folder {
 public:
  explicit Asked(std::string command) : command_(std::move(command)) {}

  int code = 0;
  std::string out, error;
  void run(const std::string& arguments, const std::string& before = "") {
    const CommandRun o = Folder::run(command_ + " " + arguments, before);
    code = o.code;
    out = o.out;
    error = o.error;
  }
  /// Whatever its exit code.
  nlohmann::json json(const std::string& arguments) {
    run(arguments + " --json");
    return nlohmann::json::parse(out);
  }

 private:
  std::string command_;
};

/// Put before a command: it may take so much memory and time. The address sanitizer reserves far more memory
/// than any command uses, so there only the time is limited.
inline std::string limited(int megabytes, int seconds) {
#ifdef __SANITIZE_ADDRESS__
  (void)megabytes;
  return "timeout " + std::to_string(10 * seconds);
#else
  return "ulimit -v " + std::to_string(1000 * megabytes) + "; timeout " + std::to_string(seconds);
#endif
}

/// In an empty folder.
inline CommandRun run(const std::string& arguments) { return Folder().run(arguments); }

/// The answer of a command that succeeds, with --json.
inline nlohmann::json json_of(const std::string& arguments) {
  const CommandRun o = run(arguments + " --json");
  CHECK(o.error == "");
  REQUIRE(o.code == 0);
  return nlohmann::json::parse(o.out);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The same for a command that runs in a folder, which ends with a code.
inline nlohmann::json json_of(const Folder& folder, const std::string& arguments, int code = 0) {
  const CommandRun o = folder.run(arguments + " --json");
  CAPTURE(arguments);
  CAPTURE(o.error);
  REQUIRE(o.code == code);
  return nlohmann::json::parse(o.out);
}

}  // namespace shortfall
