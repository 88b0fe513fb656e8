// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/token_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "analysis/program/function.hpp"

namespace shortfall {

namespace {

constexpr int kDeepestExpression = 200;
constexpr int kMostNodes = 1000;
constexpr int kHighestDimension = 20;

/// A sign after an operator is printed in a parenthesis, and counts like that: what is read can be read again
/// when it was printed.
constexpr int kSignInside = 3;
constexpr int kFractionInside = 2;  // 0.5^2 may be printed as (1/2)^2

struct Deeper {
  int& depth;
  int levels;
  explicit Deeper(int& d, int more = 1) : depth(d), levels(more) { depth += levels; }
  ~Deeper() { depth -= levels; }
};

}  // namespace

Token TokenReader::take() {
  Token token = peek();
  if (!at_end()) ++next_;
  return token;
}

bool TokenReader::take_if(std::string_view sign) {
  if (!at(sign)) return false;
  ++next_;
  return true;
}

std::string TokenReader::found() const { return at_end() ? "the end of the line" : "'" + peek().text + "'"; }

Token TokenReader::expect(std::string_view sign, std::string_view where) {
  if (!at(sign))
    throw error("expected '" + std::string(sign) + "' " + std::string(where) + ", found " + found());
  return take();
}

Token TokenReader::expect_name(std::string_view what) {
  if (peek().kind != Token::Kind::name) throw error("expected " + std::string(what) + ", found " + found());
  return take();
}

bool TokenReader::after_value() const {
  return next_ > 0 && (tokens_[next_ - 1].kind != Token::Kind::sign || tokens_[next_ - 1].text == ")");
}

void TokenReader::refuse_missing_operator() const {
  const bool starts_value = !at_end() && (peek().kind != Token::Kind::sign || at("("));
  if (starts_value && after_value())
    throw error("an operator is missing before " + found() + "; a product is written with *");
}

void TokenReader::expect_end(std::string_view after) {
  if (at_end()) return;
  refuse_missing_operator();
  if (at("=")) throw error("a statement has one =; each assignment stands on a line of its own");
  if (at("}")) throw error("} stands on a line of its own");
  if (at(",") && next_ > 0 && tokens_[next_ - 1].kind == Token::Kind::number &&
      tokens_[next_ + 1].kind == Token::Kind::number)
    throw error("a decimal is written with a point: " + tokens_[next_ - 1].text + "." +
                tokens_[next_ + 1].text);
  throw error("nothing may follow " + std::string(after) + ", found " + found());
}

void TokenReader::check_depth(std::string_view what) const {
  if (depth_ > kDeepestExpression)
    throw error(std::string(what) + " are nested deeper than " + std::to_string(kDeepestExpression) +
                " levels");
}

void TokenReader::count_value() {
  if (++nodes_ > kMostNodes)
    throw error("the expression has more than " + std::to_string(kMostNodes) + " values");
}

Expr TokenReader::expression() {
  const Deeper deeper(depth_);
  check_depth("parentheses");
  Expr left = product();
  while (at("+") || at("-")) {
    const Token sign = take();
    left = binary(sign.text == "+" ? Expression::Op::add : Expression::Op::subtract, left, product(),
                  sign.place);
  }
  return left;
}

Expr TokenReader::product() {
  Expr left = signed_factor();
  while (at("*") || at("/")) {
    const Token sign = take();
    left = binary(sign.text == "*" ? Expression::Op::multiply : Expression::Op::divide, left, signed_factor(),
                  sign.place);
  }
  return left;
}

Expr TokenReader::signed_factor() {
  const bool inside = at("-") && next_ > 0 && tokens_[next_ - 1].kind == Token::Kind::sign &&
                      std::string_view("+-*/").find(tokens_[next_ - 1].text) != std::string_view::npos;
  const Deeper deeper(depth_, inside ? kSignInside : 1);
  check_depth("signs");
  if (at("-")) {
    const Token sign = take();
    return negate(signed_factor(), sign.place);
  }
  if (at("+")) {
    take();
    return signed_factor();
  }
  return power_of();
}

Expr TokenReader::power_of() {
  Expr base = primary();
  if (!at("^")) return base;
  const Token sign = take();
  // The exponent is a signed whole number or a parenthesis; towers like h^2^3 are ambiguous to readers, so
  // they are refused.
  Expr exponent;
  if (at("-")) {
    const Token minus = take();
    const Deeper deeper(depth_, kSignInside);
    exponent = negate(primary(), minus.place);
  } else {
    exponent = primary();
  }
  if (at("^")) throw error("write parentheses: (a^b)^c or a^(b^c)");
  return binary(Expression::Op::power, base, exponent, sign.place);
}

Expr TokenReader::primary() {
  const Token token = peek();
  if (token.kind == Token::Kind::number || token.kind == Token::Kind::name) count_value();
  switch (token.kind) {
    case Token::Kind::number: {
      take();
      try {
        Rational value = Rational::parse(token.text);
        if (!value.is_integer()) count_value();  // printed as a quotient it is two
        const Deeper deeper(depth_, value.is_integer() ? 0 : kFractionInside);
        check_depth("fractions");
        return number(std::move(value), token.place);
      } catch (const BadInput& e) {
        throw source_.error(token.place, e.what());
      }
    }
    case Token::Kind::name:
      take();
      return at("(") ? call(token) : name(token.text, token.place);
    case Token::Kind::sign:
      if (token.text == "(") {
        take();
        Expr inside = expression();
        if (!at(")")) refuse_unclosed(token);
        take();
        return inside;
      }
      break;
    case Token::Kind::end:
      break;
  }
  const std::string after = next_ > 0 ? " after '" + tokens_[next_ - 1].text + "'" : "";
  const bool cut_off = at_end() && next_ > 0 &&
                       std::string_view("+-*/").find(tokens_[next_ - 1].text) != std::string_view::npos;
  throw error("expected a value" + after + ", found " + found() +
              (cut_off ? "; a line goes on only inside parentheses" : ""));
}

void TokenReader::refuse_unclosed(const Token& open) const {
  refuse_missing_operator();
  if (at(",")) throw error("a comma stands only between the values of a(x, v, t)");
  throw error(open.place, "this ( is not closed before " + found());
}

void TokenReader::refuse_call(const Token& function, const Token& open, std::size_t values) const {
  static const std::set<std::string, std::less<>> kElsewhere{"abs", "asin", "atan2", "cbrt",
                                                             "ln",  "sgn",  "tan",   "tanh"};
  const std::string refused = "there is no function '" + function.text + "'; ";
  if (kElsewhere.contains(function.text) || (values != 1 && !force_))
    throw error(function.place, refused + "there are " + function_list(functions_) +
                                    (force_ ? ", and the force a(x, v, t)" : ""));
  if (values == 1)
    throw error(open.place,
                "an operator is missing before '('; a product is written with *: " + function.text + "*(");
  throw error(function.place, refused + "the force is called a(x, v, t)");
}

Expr TokenReader::call(const Token& function) {
  const Token open = take();
  std::vector<Expr> arguments;
  if (!at(")")) {
    do arguments.push_back(expression());
    while (take_if(","));
  }
  if (!at(")")) refuse_unclosed(open);
  take();
  if (const auto f = function_named(function.text)) {
    const auto count = static_cast<std::size_t>(arity(*f));
    if (arguments.size() != count)
      throw error(function.place, function.text + " takes " + std::to_string(count) +
                                      (count == 1 ? " value" : " values") + "; found " +
                                      std::to_string(arguments.size()));
    return shortfall::call(function.text, std::move(arguments), function.place);
  }
  if (function.text != "a") refuse_call(function, open, arguments.size());
  if (arguments.size() != 3)
    throw error(function.place, "a takes 3 values, position, velocity, time: a(x, v, t); found " +
                                    std::to_string(arguments.size()));
  return force(arguments[0], arguments[1], arguments[2], function.place);
}

TokenReader::SignedNumber TokenReader::signed_number(std::string_view what) {
  const Place place = peek().place;
  const bool minus = take_if("-");
  if (peek().kind != Token::Kind::number) throw error("expected " + std::string(what) + ", found " + found());
  const Token digits = take();
  try {
    const Rational size = Rational::parse(digits.text);
    return {minus ? -size : size, (minus ? "-" : "") + digits.text, place};
  } catch (const BadInput& e) {
    throw source_.error(place, e.what());
  }
}

int TokenReader::whole_number(std::string_view what) {
  const bool minus = take_if("-");
  std::int64_t value = 0;
  if (peek().kind != Token::Kind::number || peek().text.size() > 3 ||
      !Rational::parse(peek().text).fits_int64(value))
    throw error("expected " + std::string(what) + ", found " + found());
  take();
  return static_cast<int>(minus ? -value : value);
}

Dimension TokenReader::dimension() {
  const Place first = peek().place;
  Dimension result;
  int sign = 1;
  for (;;) {
    const Token token = peek();
    if (token.kind == Token::Kind::number && token.text == "1") {
      take();
    } else if (token.kind == Token::Kind::name && (token.text == "L" || token.text == "T")) {
      take();
      const int power = take_if("^") ? whole_number("a whole number as the power of a dimension") : 1;
      (token.text == "L" ? result.length : result.time) += sign * power;
    } else {
      throw error("expected a dimension made of L, T and 1, such as L/T^2, found " + found());
    }
    if (take_if("*")) {
      sign = 1;
    } else if (take_if("/")) {
      sign = -1;
    } else {
      if (std::max(std::abs(result.length), std::abs(result.time)) > kHighestDimension)
        throw source_.error(first, "a dimension has powers from -20 to 20");
      return result;
    }
  }
}

}  // namespace shortfall
