// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// Writes expressions as code: one operation of ours is one of theirs, in our order; powers are products from
/// the left. What differs from language to language is left to those who derive from it.
class CodeWriter {
 public:
  virtual ~CodeWriter() = default;

  /// throws  Unable  for what the language cannot say, or a power that is no whole number from -32 to 32
  std::string text(const Expr& e) const { return of(e).text; }

 protected:
  /// How tightly a piece of code binds: sum < product < sign < atom, the same in all languages.
  enum Binding { kSum, kProduct, kSign, kAtom };
  struct Piece {
    std::string text;
    Binding binding;
  };

  Piece of(const Expr& e) const;
  /// A number that is not negative.
  virtual Piece of_number(const Rational& value) const = 0;
  virtual std::string of_name(const std::string& name) const = 0;
  /// What a function is called; empty for one that steps do not use.
  virtual std::string function(const std::string& name) const = 0;
  /// What the language calls itself, for messages.
  virtual std::string title() const = 0;

 private:
  Piece of_signed(const Rational& value) const;
  std::string bound(const Expr& e, Binding least) const;
  Piece of_call(const std::string& function, const Expr& e) const;
  Piece of_negative(const Expr& e) const;
  Piece of_power(const Expr& e) const;
};

}  // namespace shortfall
