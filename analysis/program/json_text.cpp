// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/json_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "analysis/algebra/characters.hpp"

namespace shortfall {

namespace {

constexpr int kDeepestList = 8;

/// What is wrong with a number that JSON does not know; "" when nothing is.
std::string number_complaint(const std::string& t) {
  std::size_t i = t.starts_with('-') ? 1 : 0;
  if (t.starts_with('+')) return "a number is written without +: " + shortened(t.substr(1));
  if (i < t.size() && t[i] == '.') {
    const std::string written = (i ? "-0" : "0") + t.substr(i);
    return "a number has a digit before the point: " + shortened(written);
  }
  const std::size_t whole = i;
  while (i < t.size() && is_digit(t[i])) ++i;
  const auto not_a_number = [&] {
    const std::string valid = i > whole ? t.substr(0, t[i - 1] == '.' ? i - 1 : i) : "";
    return "'" + shortened(t) + "' is not a number" +
           (valid.empty() ? "" : "; did you mean " + shortened(valid) + "?");
  };
  if (i == whole) return not_a_number();
  if (t[whole] == '0' && i > whole + 1)
    return "a number does not begin with 0 and another digit: '" + shortened(t) + "'";
  if (i < t.size() && t[i] == '/') return "a fraction stands in quotes: \"" + shortened(t) + "\"";
  if (i < t.size() && t[i] == '.') {
    const std::size_t point = i++;
    while (i < t.size() && is_digit(t[i])) ++i;
    if (i == point + 1 && i == t.size())
      return "the number '" + shortened(t) + "' ends in a point; write " + shortened(t.substr(0, point));
  }
  if (i < t.size() && (t[i] == 'e' || t[i] == 'E')) {
    std::size_t exponent = i + 1;
    if (exponent < t.size() && (t[exponent] == '+' || t[exponent] == '-')) ++exponent;
    if (exponent < t.size() && is_digit(t[exponent]))
      for (i = exponent; i < t.size() && is_digit(t[i]);) ++i;
  }
  return i == t.size() ? "" : not_a_number();
}

class Reader {
 public:
  explicit Reader(const Source& source) : source_(source) {}

  JsonValue whole() {
    JsonValue value = read(0);
    if (peek() != '\0') throw error("nothing may follow the last } of the file");
    return value;
  }

 private:
  /// The next character that is no blank, '\0' at the end of the text; the cursor stands on it.
  char peek() {
    for (; line_ <= source_.line_count(); ++line_, byte_ = 0) {
      const std::string& text = source_.line(line_);
      while (byte_ < text.size() && (text[byte_] == ' ' || text[byte_] == '\t')) ++byte_;
      if (byte_ < text.size()) return text[byte_];
    }
    return '\0';
  }

  Place here() const {
    return line_ > source_.line_count()
               ? source_.place(source_.line_count(), source_.line(source_.line_count()).size())
               : source_.place(line_, byte_);
  }
  SyntaxError error(const std::string& what) const { return source_.error(here(), what); }

  std::string found() {
    const char c = peek();
    if (c == '\0') return "the end of the file";
    if (c == '/' || c == '#') return "a comment, which JSON does not have";
    if (c == '\'') return "'; JSON writes \" around texts";
    std::size_t end = byte_ + 1;
    const std::string& text = source_.line(line_);
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
    return "'" + text.substr(byte_, end - byte_) + "'";
  }

  JsonValue read(int depth) {
    const char c = peek();
    JsonValue value;
    value.place = here();
    if (depth > kDeepestList)
      throw error("lists are nested deeper than " + std::to_string(kDeepestList) + " levels");
    if (c == '{') return object(std::move(value), depth);
    if (c == '[') return array(std::move(value), depth);
    if (c == '"') return string(std::move(value));
    if (is_digit(c) || c == '-' || c == '+' || c == '.') return number(std::move(value));
    if (std::isalpha(static_cast<unsigned char>(c))) return word(std::move(value));
    throw error("expected a value, found " + found());
  }

  JsonValue object(JsonValue value, int depth) {
    value.kind = JsonValue::Kind::object;
    const Place open = here();
    ++byte_;
    if (peek() == '}') return ++byte_, value;
    for (;;) {
      if (peek() == '\0') throw source_.error(open, "this { is never closed");
      if (peek() == '}') throw error("a comma stands before this }; the last member has none behind it");
      if (peek() != '"') throw error("expected a key in double quotes, found " + found());
      JsonValue key;
      key.place = here();
      key = string(std::move(key));
      if (value.find(key.text))
        throw source_.error(key.place, "the key \"" + shortened(key.text) + "\" stands twice");
      if (peek() != ':')
        throw error("expected : behind the key \"" + shortened(key.text) + "\", found " + found());
      ++byte_;
      value.members.push_back({std::move(key), read(depth + 1)});
      if (separated('}', open)) return value;
    }
  }

  JsonValue array(JsonValue value, int depth) {
    value.kind = JsonValue::Kind::array;
    const Place open = here();
    ++byte_;
    if (peek() == ']') return ++byte_, value;
    for (;;) {
      if (peek() == '\0') throw source_.error(open, "this [ is never closed");
      if (peek() == ']') throw error("a comma stands before this ]; the last entry has none behind it");
      value.items.push_back(read(depth + 1));
      if (separated(']', open)) return value;
    }
  }

  /// Reads a comma (false) or what closes the list (true).
  bool separated(char close, Place open) {
    const char c = peek();
    if (c == ',') return ++byte_, false;
    if (c == close) return ++byte_, true;
    if (c == '\0')
      throw source_.error(open, std::string("this ") + (close == ']' ? "[" : "{") + " is never closed");
    throw error(std::string("expected , or ") + close + ", found " + found());
  }

  JsonValue string(JsonValue value) {
    value.kind = JsonValue::Kind::string;
    const Place open = here();
    const std::string& text = source_.line(line_);
    value.byte = ++byte_;
    for (; byte_ < text.size() && text[byte_] != '"'; ++byte_) {
      if (text[byte_] != '\\') {
        value.text += text[byte_];
        continue;
      }
      value.plain = false;
      value.text += escaped(text);
    }
    if (byte_ >= text.size())
      throw source_.error(open, "this text is not closed on its line: a \" is missing");
    ++byte_;
    return value;
  }

  /// One escape, the cursor left on its last character.
  std::string escaped(const std::string& text) {
    static constexpr std::string_view kLetters = "\"\\/bfnrt";
    static constexpr std::string_view kMeanings = "\"\\/    ";
    const char c = byte_ + 1 < text.size() ? text[byte_ + 1] : '\0';
    if (const std::size_t i = kLetters.find(c); c != '\0' && i != std::string_view::npos) {
      ++byte_;
      return std::string(1, i < kMeanings.size() ? kMeanings[i] : ' ');
    }
    if (c != 'u') throw error("expected one of \" \\ / b f n r t u behind \\");
    unsigned code = four_digits(text, byte_ + 2);
    const bool high = code >= 0xD800 && code < 0xDC00;
    if (high && text.compare(byte_ + 6, 2, "\\u") == 0) {
      const unsigned low = four_digits(text, byte_ + 8);
      if (low >= 0xDC00 && low < 0xE000) {
        byte_ += 6;
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      }
    }
    if (code >= 0xD800 && code < 0xE000) throw error("a \\u of D800 to DFFF is half a character");
    byte_ += 5;
    return in_utf8(code);
  }

  unsigned four_digits(const std::string& text, std::size_t from) const {
    unsigned code = 0;
    const char* const begin = text.data() + std::min(from, text.size());
    const char* const end = text.data() + std::min(from + 4, text.size());
    const auto [stopped, problem] = std::from_chars(begin, end, code, 16);
    if (problem != std::errc{} || stopped != begin + 4)
      throw error("expected four hexadecimal digits behind \\u");
    return code;
  }

  /// RFC 3629 (2003), section 3.
  static std::string in_utf8(unsigned code) {
    if (code < 0x20 || code == 0x7F) return " ";  // a control character, as \n is
    if (code < 0x80) return {static_cast<char>(code)};
    std::string bytes;
    const auto put = [&](unsigned byte) { bytes += static_cast<char>(byte); };
    if (code < 0x800) {
      put(0xC0 | code >> 6);
    } else if (code < 0x10000) {
      put(0xE0 | code >> 12);
      put(0x80 | (code >> 6 & 0x3F));
    } else {
      put(0xF0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3F));
      put(0x80 | (code >> 6 & 0x3F));
    }
    put(0x80 | (code & 0x3F));
    return bytes;
  }

  JsonValue number(JsonValue value) {
    value.kind = JsonValue::Kind::number;
    const std::string& text = source_.line(line_);
    value.byte = byte_;
    std::size_t end = byte_;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) ||
                                 std::string_view("+-._/").find(text[end]) != std::string_view::npos))
      ++end;
    value.text = text.substr(byte_, end - byte_);
    if (const std::string complaint = number_complaint(value.text); !complaint.empty())
      throw error(complaint);
    byte_ = end;
    return value;
  }

  JsonValue word(JsonValue value) {
    const std::string& text = source_.line(line_);
    std::size_t end = byte_;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
      ++end;
    value.text = text.substr(byte_, end - byte_);
    std::string lower = value.text;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower == "nan" || lower == "inf" || lower == "infinity")
      throw error("'" + value.text + "' is not a number");
    if (lower == "true" || lower == "false" || lower == "null") {
      if (value.text != lower) throw error("'" + value.text + "' is written " + lower);
    } else {
      throw error("expected a value, found '" + shortened(value.text) +
                  "'; texts and fractions stand in double quotes");
    }
    value.kind = lower == "null" ? JsonValue::Kind::null : JsonValue::Kind::boolean;
    byte_ = end;
    return value;
  }

  const Source& source_;
  int line_ = 1;
  std::size_t byte_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto found = std::ranges::find_if(members, [&](const auto& m) { return m.first.text == key; });
  return found == members.end() ? nullptr : &found->second;
}

std::string JsonValue::described() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return text;
    case Kind::number:
      return "the number " + shortened(text);
    case Kind::string:
      return "the text \"" + shortened(text) + "\"";
    case Kind::array:
      return "a list";
    case Kind::object:
      break;
  }
  return "an object";
}

JsonValue json_value(const Source& source) {
  Reader reader(source);
  return reader.whole();
}

}  // namespace shortfall
