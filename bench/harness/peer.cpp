// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness/peer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <stdexcept>

#include "bench/harness/interleaved.hpp"

namespace shortfall::bench {

namespace {

constexpr int kPatience = 120'000;  // milliseconds

}  // namespace

Peer::Peer(std::string name, std::vector<std::string> command, const std::string& greeting,
           std::string line_end)
    : line_end_(std::move(line_end)), name_(std::move(name)) {
  signal(SIGPIPE, SIG_IGN);
  std::array<int, 2> in{}, out{};
  if (pipe2(in.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for " + name_);
  if (pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for " + name_);
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  process_ = fork();
  if (process_ == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }
  close(in[0]);
  close(out[1]);
  to_ = in[1];
  from_ = out[0];
  if (process_ < 0) {
    leave("cannot be started");
    return;
  }
  if (!greeting.empty() && !send(greeting + "\n")) {
    leave("is not installed");
    return;
  }
  const auto hello = answer();
  if (!hello) return;
  greeted_ = true;
  for (const std::string& line : *hello)
    if (!line.empty()) name_ = line;
}

Peer::~Peer() { leave(""); }

void Peer::leave(std::string reason) {
  reason_ = std::move(reason);
  for (int* end : {&to_, &from_})
    if (*end >= 0) {
      close(*end);
      *end = -1;
    }
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }
}

bool Peer::send(std::string_view text) const {
  return write(to_, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

std::optional<std::vector<std::string>> Peer::answer() {
  std::vector<std::string> lines;
  for (;;) {
    for (std::size_t end; (end = unread_.find('\n')) != std::string::npos;) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      while (!line.empty() && line.back() == ' ') line.pop_back();
      if (line == "=done") return lines;
      lines.push_back(std::move(line));
    }
    pollfd ready{from_, POLLIN, 0};
    if (poll(&ready, 1, kPatience) <= 0) {
      leave("did not answer within two minutes");
      return std::nullopt;
    }
    std::array<char, 65536> buffer{};
    const ssize_t count = read(from_, buffer.data(), buffer.size());
    if (count <= 0) {
      leave(greeted_ ? "has ended" : "is not installed");
      return std::nullopt;
    }
    unread_.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

std::optional<std::vector<std::string>> Peer::ask(std::string_view question) {
  if (!runs() || !send(std::string(question) + line_end_ + "\n")) return std::nullopt;
  return answer();
}

double Peer::seconds(int way, long times) {
  clockid_t clock{};
  if (!runs() || clock_getcpuclockid(process_, &clock) != 0)
    throw std::runtime_error(name_ + " is not there");
  const double begin = processor_seconds(clock);
  if (!ask("go(" + std::to_string(way) + ", " + std::to_string(times) + ")"))
    throw std::runtime_error(name_ + " gave no answer: it " + reason_);
  return processor_seconds(clock) - begin;
}

std::vector<std::unique_ptr<Peer>> peers(const std::string& script) {
  const std::string path = std::string(SHORTFALL_PEERS) + "/" + script;
  // Debian's packages are those of /usr/bin/python3, whatever python3 may be elsewhere on the path.
  const std::string python = access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
  std::vector<std::unique_ptr<Peer>> all;
  const auto start = [&](const std::string& name, std::vector<std::string> command,
                         const std::string& greeting, std::string line_end) {
    all.push_back(std::make_unique<Peer>(name, std::move(command), greeting, std::move(line_end)));
  };
  start("SymPy", {python, path + ".py"}, "", "");
  start("Maxima", {"maxima", "--very-quiet"}, "batchload(\"" + path + ".mac\")$", "$");
  start("PARI/GP", {"gp", "-q", "-f", path + ".gp"}, "", "");
  return all;
}

}  // namespace shortfall::bench
