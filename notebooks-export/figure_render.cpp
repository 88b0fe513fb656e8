// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "notebooks-export/figure_gnuplot.hpp"

extern char** environ;

namespace shortfall {

namespace {

/// A file without a name: what is written to it can be read back.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) throw ProgramError(std::string("cannot make a temporary file: ") + std::strerror(errno));
  }
  int descriptor() const { return ::fileno(file_.get()); }
  void write(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
      throw ProgramError(std::string("cannot write a temporary file: ") + std::strerror(errno));
    std::rewind(file_.get());
  }
  std::string text() {
    std::rewind(file_.get());
    std::string result;
    char buffer[65536];
    for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, file_.get())) > 0;)
      result.append(buffer, got);
    return result;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

const char* const kMissing =
    "gnuplot is not installed: figures need it (on Debian: apt-get install gnuplot-nox)";

}  // namespace

bool gnuplot_is_here() {
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::string directory = rest.substr(0, colon);
    if (::access((directory + "/gnuplot").c_str(), X_OK) == 0) return true;
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  return false;
}

std::string image(const Figure& figure, ImageFormat format) {
  Scratch script, output, messages;
  script.write(gnuplot_script(figure, format));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, script.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
  // Without the user's settings; no shell is involved.
  char program[] = "gnuplot", defaults[] = "-d", standard_input[] = "-";
  char* arguments[] = {program, defaults, standard_input, nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT || error == EACCES) throw ProgramError(kMissing);
  if (error != 0) throw ProgramError(std::string("cannot start gnuplot: ") + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw ProgramError(std::string("lost gnuplot: ") + std::strerror(errno));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) throw ProgramError(kMissing);
  std::string bytes = output.text();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty())
    throw ProgramError("gnuplot failed: " + messages.text().substr(0, 500));
  return bytes;
}

}  // namespace shortfall
