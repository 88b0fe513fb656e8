// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace shortfall {

/// A file of the source tree, as it lay there when the library was built (cmake/EmbedFiles.cmake).
struct EmbeddedFile {
  std::string_view path;  ///< relative to the folder that is embedded, with forward slashes
  std::string_view text;  ///< of pictures, the bytes as hexadecimal digits
};

/// The text of the file with that path; empty when there is none.
inline std::string_view embedded_text(std::span<const EmbeddedFile> files, std::string_view path) {
  for (const EmbeddedFile& file : files)
    if (file.path == path) return file.text;
  return {};
}

}  // namespace shortfall
