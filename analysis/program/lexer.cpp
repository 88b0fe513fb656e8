// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/lexer.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/algebra/characters.hpp"

namespace shortfall {

namespace {

bool begins_name(char c) { return is_alphabetic(c) || c == '_'; }

/// Characters that people paste from books, and what the language writes instead.
constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kFancy{{{"×", "*"},
                                                                                {"·", "*"},
                                                                                {"⋅", "*"},
                                                                                {"÷", "/"},
                                                                                {"−", "-"},
                                                                                {"–", "-"},
                                                                                {"½", "1/2"},
                                                                                {"¼", "1/4"},
                                                                                {"²", "^2"},
                                                                                {"³", "^3"},
                                                                                {"ω", "w"},
                                                                                {"θ", "theta"},
                                                                                {"β", "beta"},
                                                                                {"γ", "gamma"},
                                                                                {"[", "("},
                                                                                {"]", ")"},
                                                                                {"Δ", "h for the step"}}};

struct Lexer {
  const Source& source;
  int& line;
  std::size_t i;
  std::size_t stop = std::string::npos;  ///< where reading ends on the line
  std::vector<Token> result = {};
  std::vector<Place> open = {};

  const std::string& text() const { return source.line(line); }
  Place here() const { return source.place(line, i); }
  void push(Token::Kind kind, std::size_t length) {
    result.push_back({kind, text().substr(i, length), here()});
    i += length;
  }

  void number() {
    const std::string& s = text();
    std::size_t end = i;
    while (end < s.size() && is_digit(s[end])) ++end;
    if (end < s.size() && s[end] == '.') {
      ++end;
      while (end < s.size() && is_digit(s[end])) ++end;
      if (s[end - 1] == '.')
        throw source.error(here(), "the number '" + s.substr(i, end - i) + "' ends in a point");
    }
    if (end < s.size() && (s[end] == 'e' || s[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < s.size() && (s[exponent] == '+' || s[exponent] == '-')) ++exponent;
      if (exponent < s.size() && is_digit(s[exponent])) {
        end = exponent;
        while (end < s.size() && is_digit(s[end])) ++end;
      }
    }
    const std::string digits = s.substr(i, end - i);
    push(Token::Kind::number, end - i);
    if (i < s.size() && (begins_name(s[i]) || s[i] == '(')) {
      std::size_t word = i;
      while (word < s.size() && (begins_name(s[word]) || is_digit(s[word]))) ++word;
      const std::string next = s[i] == '(' ? "(" : s.substr(i, word - i);
      throw source.error(here(), "a product is written with *: " + digits + "*" + next);
    }
    if (i < s.size() && s[i] == '.') throw source.error(here(), "a number has at most one point");
  }

  [[noreturn]] void stranger() {
    const std::string_view rest = std::string_view(text()).substr(i);
    for (const auto& [fancy, plain] : kFancy)
      if (rest.starts_with(fancy))
        throw source.error(
            here(), "'" + std::string(fancy) + "' is not in the language; write " + std::string(plain));
    if (rest[0] == ';') throw source.error(here(), "a statement ends with its line; leave out the ;");
    std::size_t length = 1;
    while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xC0) == 0x80) ++length;
    throw source.error(here(), "'" + std::string(rest.substr(0, length)) + "' is not in the language");
  }

  void read_line() {
    while (i < std::min(stop, text().size())) {
      const char c = text()[i];
      if (c == '#') break;
      if (c == ' ' || c == '\t') {
        ++i;
      } else if (is_digit(c) || (c == '.' && i + 1 < text().size() && is_digit(text()[i + 1]))) {
        number();
      } else if (begins_name(c)) {
        std::size_t end = i;
        while (end < text().size() && (begins_name(text()[end]) || is_digit(text()[end]))) ++end;
        push(Token::Kind::name, end - i);
      } else if (std::string_view("+-*/^(),=:&{}<>").find(c) != std::string_view::npos) {
        if (c == '(') open.push_back(here());
        if (c == ')') {
          if (open.empty()) throw source.error(here(), "this ) closes nothing");
          open.pop_back();
        }
        if (c == '*' && i + 1 < text().size() && text()[i + 1] == '*')
          throw source.error(here(), "a power is written with ^, not with **");
        if (c == '/' && i + 1 < text().size() && text()[i + 1] == '/')
          throw source.error(here(), "a comment begins with #");
        push(Token::Kind::sign, 1);
      } else {
        stranger();
      }
    }
  }
};

/// Whether a line is the head of a block, and so the statement above it has ended.
bool opens_block(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos) return false;
  const std::size_t end = line.find_first_of(" \t#", begin);
  const std::string word = line.substr(begin, end == std::string::npos ? end : end - begin);
  return word == "start" || word == "step" || word == "finish" || word == "tableau" || word == "splitting" ||
         word == "expect";
}

/// Refuses a parenthesis that is never closed, before anything in the lines below it can be taken for the
/// mistake: none of = : & { } | stands inside parentheses, nor does the head of a block.
void refuse_unclosed(const Source& source, int first, std::size_t byte) {
  std::vector<Place> open;
  for (int line = first; line <= source.line_count(); ++line, byte = 0) {
    const std::string& text = source.line(line);
    bool ended = line > first && opens_block(text);
    char last = ' ';
    for (std::size_t i = byte; i < text.size() && text[i] != '#' && !ended; ++i) {
      const char c = text[i];
      if (c == '(') open.push_back(source.place(line, i));
      if (c == ')' && open.empty()) return;
      if (c == ')') open.pop_back();
      ended = line > first && !open.empty() && std::string_view("=:&{}|").find(c) != std::string_view::npos;
      if (c != ' ' && c != '\t') last = c;
    }
    if (ended) break;
    if (open.empty() && last != '&') return;
  }
  if (!open.empty()) throw source.error(open.back(), "this ( is never closed");
}

}  // namespace

std::vector<Token> tokens(const Source& source, int& line, std::size_t byte) {
  refuse_unclosed(source, line, byte);
  Lexer lexer{source, line, byte};
  for (;;) {
    lexer.read_line();
    const bool and_more = !lexer.result.empty() && lexer.result.back().text == "&";
    if (lexer.open.empty() && !and_more) break;
    if (line == source.line_count())
      throw source.error(lexer.result.back().place, "nothing follows the final '&'");
    ++line;
    lexer.i = 0;
  }
  lexer.result.push_back({Token::Kind::end, "", source.place(line, lexer.i)});
  return std::move(lexer.result);
}

std::vector<Token> tokens_between(const Source& source, int line, std::size_t begin, std::size_t end) {
  Lexer lexer{source, line, begin, end};
  lexer.read_line();
  if (!lexer.open.empty())
    throw source.error(lexer.open.back(), "this ( is not closed in its entry; an entry has no blanks");
  lexer.result.push_back({Token::Kind::end, "", source.place(line, end)});
  return std::move(lexer.result);
}

}  // namespace shortfall
