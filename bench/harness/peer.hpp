// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shortfall::bench {

/// Another program that was started once, has loaded a script of bench/peers, and answers questions line by
/// line, each answer closed by a line "=done". So what is timed excludes its start.
class Peer {
 public:
  /// param   command    the program and its arguments
  /// param   greeting   lines to send first, if the script is not one of the arguments
  /// param   line_end   what ends a question in the program's language
  Peer(std::string name, std::vector<std::string> command, const std::string& greeting, std::string line_end);
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer();

  /// Whether it started; else `reason` says why not.
  bool runs() const { return to_ >= 0; }
  const std::string& reason() const { return reason_; }
  /// What it calls itself, with its version.
  const std::string& name() const { return name_; }

  /// The lines of the answer; nothing when it has died or has been silent for two minutes, and then it is
  /// gone.
  std::optional<std::vector<std::string>> ask(std::string_view question);
  /// The processor time that the peer needs to answer "go(way, times)".
  ///
  /// units   seconds
  /// throws  std::runtime_error  when there is no answer
  double seconds(int way, long times);

 private:
  std::optional<std::vector<std::string>> answer();
  bool send(std::string_view text) const;
  void leave(std::string reason);

  std::string line_end_;
  std::string name_;
  std::string reason_;
  std::string unread_;
  bool greeted_ = false;
  int process_ = -1;
  int to_ = -1;
  int from_ = -1;
};

/// SymPy, Maxima and PARI/GP with the script bench/peers/`script`.py, .mac and .gp.
std::vector<std::unique_ptr<Peer>> peers(const std::string& script);

}  // namespace shortfall::bench
