// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// Statements and blocks of a class whose members are numbers of binary64, in the manner of a language.
class CodeBlock {
 public:
  explicit CodeBlock(Language language) : language_(language) {}

  const std::string& text() const { return text_; }
  bool braces() const { return language_ != Language::python && language_ != Language::gdscript; }
  /// How a method says a member: "self.x", "this.x", "x".
  std::string member(const std::string& name) const;

  void line(const std::string& text = "");
  void comment(const std::string& text);  ///< broken into lines
  void assign(const std::string& left, const std::string& value);
  void let(const std::string& name, const std::string& value);  ///< a constant of the block
  void open_if(const std::string& condition);
  void open_else_if(const std::string& condition);
  void open_else();
  /// A loop over whole numbers from 1.
  void open_loop(const std::string& index, int count);
  std::string as_number(const std::string& index) const;  ///< of a loop, in binary64
  void nothing();                                         ///< where a block may not be empty
  void leave_loop_if(const std::string& condition);
  void close();

  void open_class(const std::string& name, const std::vector<std::string>& members,
                  const std::vector<std::string>& arguments);
  /// Without a value.
  void open_routine(const std::string& name, const std::vector<std::string>& arguments);
  void call(const std::string& name, const std::vector<std::string>& arguments);
  void function(const std::string& name, const std::vector<std::string>& arguments, const std::string& value);
  /// Ends the constructor that open_class began, which calls a routine.
  void close_constructor(const std::string& routine);
  void close_class();

  std::string routine_name(const std::string& name) const;
  std::string magnitude(const std::string& value) const;
  std::string not_a_number() const;
  std::string both(const std::string& a, const std::string& b) const;  ///< a and b

 private:
  void open(const std::string& head);
  std::string parameters(const std::vector<std::string>& arguments) const;
  Language language_;
  std::string text_;
  int depth_ = 0;
};

}  // namespace shortfall
