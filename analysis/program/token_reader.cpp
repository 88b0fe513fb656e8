// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

constexpr int kDeepest = 200;
constexpr int kMostNodes = 5000;

struct Deeper {
  int& depth;
  explicit Deeper(int& d) : depth(d) { ++depth; }
  ~Deeper() { --depth; }
};

}  // namespace

Token TokenReader::take() {
  const Token token = peek();
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
  if (!at(sign)) throw error("expected '" + std::string(sign) + "' " + std::string(where) + ", found " + found());
  return take();
}

Token TokenReader::expect_name(std::string_view what) {
  if (peek().kind != Token::Kind::name) throw error("expected " + std::string(what) + ", found " + found());
  return take();
}

void TokenReader::missing_operator() const {
  const bool starts_value = peek().kind != Token::Kind::sign || at("(");
  if (at_end() || !starts_value || next_ == 0) return;
  throw error("an operator is missing before " + found() + "; a product is written with *");
}

void TokenReader::expect_end(std::string_view after) {
  if (at_end()) return;
  missing_operator();
  if (at("=")) throw error("one = is enough: one statement a line, NAME = EXPRESSION");
  throw error("nothing may follow " + std::string(after) + ", found " + found());
}

Expr TokenReader::expression() {
  const Deeper deeper(depth_);
  if (depth_ > kDeepest) throw error("parentheses are nested deeper than " + std::to_string(kDeepest) + " levels");
  Expr left = product();
  while (at("+") || at("-")) {
    const Token sign = take();
    left = binary(sign.text == "+" ? Expression::Op::add : Expression::Op::subtract, left, product(), sign.place);
  }
  return left;
}

Expr TokenReader::product() {
  Expr left = signed_factor();
  while (at("*") || at("/")) {
    const Token sign = take();
    left = binary(sign.text == "*" ? Expression::Op::multiply : Expression::Op::divide, left, signed_factor(), sign.place);
  }
  return left;
}

Expr TokenReader::signed_factor() {
  const Deeper deeper(depth_);
  if (depth_ > kDeepest) throw error("signs are nested deeper than " + std::to_string(kDeepest) + " levels");
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
  // The exponent is a signed whole number or a parenthesis; towers like h^2^3 are ambiguous to readers, so they are refused.
  Expr exponent;
  if (at("-")) {
    const Token minus = take();
    exponent = negate(primary(), minus.place);
  } else {
    exponent = primary();
  }
  if (at("^")) throw error("write parentheses: (a^b)^c or a^(b^c)");
  return binary(Expression::Op::power, base, exponent, sign.place);
}

Expr TokenReader::primary() {
  if (++nodes_ > kMostNodes)
    throw error("the expression has more than " + std::to_string(kMostNodes) + " values");
  const Token token = peek();
  switch (token.kind) {
    case Token::Kind::number: {
      take();
      try {
        return number(Rational::parse(token.text), token.place);
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
        if (!at(")")) {
          missing_operator();
          throw error("expected ) or an operator, found " + found());
        }
        take();
        return inside;
      }
      break;
    case Token::Kind::end: break;
  }
  throw error("expected a value, found " + found());
}

Expr TokenReader::call(const Token& function) {
  const Token open = take();
  std::vector<Expr> arguments;
  if (!at(")")) {
    do arguments.push_back(expression());
    while (take_if(","));
  }
  if (!at(")")) {
    missing_operator();
    throw error("expected , or ) in the call of '" + function.text + "', found " + found());
  }
  take();
  if (function.text != "a")
    throw source_.error(function.place, "'" + function.text + "' cannot be called; the only function is a(x, v, t)" +
                                            (arguments.size() == 1 ? "; a product is written with *" : ""));
  if (arguments.size() != 3)
    throw source_.error(function.place, "a takes 3 values, position, velocity, time: a(x, v, t); found " +
                                            std::to_string(arguments.size()));
  return force(arguments[0], arguments[1], arguments[2], function.place);
}

int TokenReader::whole_number(std::string_view what) {
  const bool minus = take_if("-");
  std::int64_t value = 0;
  if (peek().kind != Token::Kind::number || peek().text.size() > 3 || !Rational::parse(peek().text).fits_int64(value))
    throw error("expected " + std::string(what) + ", found " + found());
  take();
  return static_cast<int>(minus ? -value : value);
}

Dimension TokenReader::dimension() {
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
      return result;
    }
  }
}

}  // namespace shortfall
