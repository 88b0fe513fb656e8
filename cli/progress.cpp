// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace shortfall::cli {

namespace {

constexpr std::chrono::seconds kSilence{2};
constexpr std::chrono::milliseconds kPause{200};
constexpr const char* kErase = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine()
    : terminal_(::isatty(STDERR_FILENO) == 1), begin_(Clock::now()), next_(begin_ + kSilence) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fprintf(stderr, "%s", kErase);
}

Progress ProgressLine::progress() {
  if (!terminal_) return {};
  return [this](const std::string& doing, int done, int of) { show(doing, done, of); };
}

void ProgressLine::show(const std::string& doing, int done, int of) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kPause;
  shown_ = true;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - begin_).count();
  const std::string count = of > 1 ? ", " + std::to_string(done) + " of " + std::to_string(of) : "";
  std::fprintf(stderr, "%sshortfall: %s%s (%lld s; Ctrl-C ends it)", kErase, doing.c_str(), count.c_str(),
               static_cast<long long>(seconds));
  std::fflush(stderr);
}

}  // namespace shortfall::cli
