// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "analysis/program/dimension.hpp"
#include "analysis/program/function.hpp"
#include "analysis/program/lexer.hpp"

namespace shortfall {

/// Reads expressions off the tokens of one statement, by precedence climbing.
class TokenReader {
 public:
  /// param   functions, force  what may be called where the expression stands, for messages
  TokenReader(const Source& source, std::vector<Token> tokens, Functions functions = Functions::of_programs,
              bool force = true)
      : source_(source), tokens_(std::move(tokens)), functions_(functions), force_(force) {}

  const Token& peek() const { return tokens_[next_]; }
  bool at_end() const { return peek().kind == Token::Kind::end; }
  bool at(std::string_view sign) const { return peek().kind == Token::Kind::sign && peek().text == sign; }
  Token take();
  bool take_if(std::string_view sign);
  /// throws  SyntaxError  "expected SIGN, found ..." when it is not there
  Token expect(std::string_view sign, std::string_view where);
  Token expect_name(std::string_view what);
  /// throws  SyntaxError  when anything is left
  void expect_end(std::string_view after);

  Expr expression();
  /// A number as it is printed, with its sign.
  struct SignedNumber {
    Rational value;
    std::string text;
    Place place;
  };
  SignedNumber signed_number(std::string_view what);
  /// "L/T^2", "1/T", "1".
  Dimension dimension();

  SyntaxError error(const std::string& what) const { return source_.error(peek().place, what); }
  SyntaxError error(Place place, const std::string& what) const { return source_.error(place, what); }
  std::string found() const;

 private:
  Expr product();
  Expr signed_factor();
  Expr power_of();
  Expr primary();
  Expr call(const Token& function);
  int whole_number(std::string_view what);
  bool after_value() const;
  void count_value();  ///< throws  SyntaxError  when there are too many
  /// throws  SyntaxError  "WHAT are nested deeper than ..." where they are
  void check_depth(std::string_view what) const;
  void refuse_missing_operator() const;
  [[noreturn]] void refuse_unclosed(const Token& open) const;
  [[noreturn]] void refuse_call(const Token& function, const Token& open, std::size_t values) const;

  const Source& source_;
  std::vector<Token> tokens_;
  Functions functions_;
  bool force_;
  std::size_t next_ = 0;
  int depth_ = 0;
  int nodes_ = 0;
};

}  // namespace shortfall
