// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace shortfall::cli {

/// The disk is full, the directory read-only: exit code 5.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes a whole text to stdout, or to a file when a path is given: under a temporary name first, so that
/// nothing is ever half-written. A symbolic link stays one: the file that it names is written.
///
/// A closed pipe on stdout is quiet.
/// throws  OutputError
void write_output(const std::string& text, const std::string& path = {});

/// Progress and messages, to stderr.
void say(const std::string& message);

}  // namespace shortfall::cli
