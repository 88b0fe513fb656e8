// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_folder.hpp"

#include <stdlib.h>
#include <sys/stat.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/output.hpp"

namespace shortfall::cli {

namespace fs = std::filesystem;

namespace {

void fill(const std::map<std::string, std::string>& files, const fs::path& folder) {
  for (const auto& [name, text] : files) {
    const fs::path path = folder / name;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw OutputError("cannot make '" + path.parent_path().string() + "': " + error.message());
    write_output(text, path.string());
  }
}

}  // namespace

void write_folder(const std::map<std::string, std::string>& files, const std::string& folder,
                  bool overwrite) {
  fs::path to(folder);
  if (!to.has_filename()) to = to.parent_path();  // "out/"
  std::error_code error;
  const fs::file_status status = fs::status(to, error);
  if (fs::exists(status)) {
    if (!fs::is_directory(status))
      throw OutputError("cannot write the folder '" + folder + "': a file of this name is there");
    const bool empty = fs::is_empty(to, error);
    if (error) throw OutputError("cannot read the folder '" + folder + "': " + error.message());
    if (!empty && !overwrite)
      throw OutputError("the folder '" + folder +
                        "' is there and not empty; --overwrite replaces the files of this export in it");
    fill(files, to);
    return;
  }
  error.clear();
  // Under a name of its own first, so that a folder is never half-filled.
  if (to.has_parent_path()) fs::create_directories(to.parent_path(), error);
  if (error) throw OutputError("cannot make '" + to.parent_path().string() + "': " + error.message());
  std::string temporary = to.string() + ".XXXXXX";
  if (!::mkdtemp(temporary.data()))
    throw OutputError("cannot make the folder '" + folder + "': " + std::strerror(errno));
  try {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(temporary.c_str(), 0777 & ~mask);
    fill(files, temporary);
    fs::rename(temporary, to, error);
    if (error) throw OutputError("cannot make the folder '" + folder + "': " + error.message());
  } catch (...) {
    fs::remove_all(temporary, error);
    throw;
  }
}

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '_' ? c : '-';
  while (name.starts_with('.') || name.starts_with('-')) name.erase(0, 1);
  return name.empty() ? "export" : name.substr(0, 100);
}

}  // namespace shortfall::cli
