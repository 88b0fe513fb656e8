// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/file_text.hpp"

#include <fstream>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongestRead = 1'000'001;  // one byte more than a source may have

}  // namespace

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text(kLongestRead, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  const bool read = in.gcount() > 0 || in.eof();
  if (!read || in.bad()) throw UnreadableFile("cannot read the file '" + path + "'");
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

}  // namespace shortfall
