// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace shortfall::cli {

namespace {

/// Writes all bytes; 0 or the errno that stopped it.
int write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    done += static_cast<std::size_t>(written);
  }
  return 0;
}

std::string cannot(const std::string& path, int error) {
  return "cannot write '" + path + "': " + std::strerror(error);
}

/// What is behind symbolic links: they stay, and the file that they name is replaced.
std::string behind_links(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, error); ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  return path.string();
}

}  // namespace

void write_output(const std::string& text, const std::string& named) {
  if (named.empty() || named == "-" || named == "/dev/stdout") {
    const int error = write_all(STDOUT_FILENO, text);
    if (error != 0 && error != EPIPE)
      throw OutputError(std::string("cannot write to the output: ") + std::strerror(error));
    return;
  }
  const std::string path = behind_links(named);
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw OutputError(cannot(path, EISDIR));
  if (exists && !S_ISREG(status.st_mode)) {  // a device or a pipe cannot be replaced, only written to
    const int descriptor = ::open(path.c_str(), O_WRONLY);
    if (descriptor < 0) throw OutputError(cannot(path, errno));
    const int error = write_all(descriptor, text);
    ::close(descriptor);
    if (error != 0) throw OutputError(cannot(path, error));
    return;
  }
  std::string temporary = path + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) throw OutputError(cannot(path, errno));
  int error = write_all(descriptor, text);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (error == 0 && ::fchmod(descriptor, exists ? status.st_mode & 0777 : 0666 & ~mask) != 0) error = errno;
  if (error == 0 && ::fsync(descriptor) != 0) error = errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    throw OutputError(cannot(path, error));
  }
}

void say(const std::string& message) { write_all(STDERR_FILENO, message + "\n"); }

}  // namespace shortfall::cli
