// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace shortfall {

/// The caller's mistake: a sentence that names the culprit.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The question has no answer here: mathematics says so (a division by zero, an inconsistent system).
class Undefined : public Error {
 public:
  using Error::Error;
};

/// We cannot, though mathematics can: a limit of ours, with the limit in the message.
class Unable : public Error {
 public:
  using Error::Error;
};

/// A number, a file or an option whose value cannot be read or makes no sense.
class BadInput : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read: missing, a folder, no permission.
class UnreadableFile : public Error {
 public:
  using Error::Error;
};

/// A text that is not in the .integrator language: what, and where.
///
/// The message reads "file:line:column: what"; `context` is the line with a caret under the culprit.
class SyntaxError : public Error {
 public:
  SyntaxError(std::string file, int line, int column, const std::string& what, std::string source_line = {});

  const std::string& file() const { return file_; }
  int line() const { return line_; }      ///< from 1
  int column() const { return column_; }  ///< from 1, in characters
  /// The source line and, below it, a caret under the column; empty when the line is unknown.
  std::string context() const;

 private:
  std::string file_;
  int line_;
  int column_;
  std::string source_line_;
};

}  // namespace shortfall
