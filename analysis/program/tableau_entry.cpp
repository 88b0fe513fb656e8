// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tableau_entry.hpp"

#include <algorithm>
#include <string_view>

#include "analysis/algebra/characters.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

/// The length of the decimal number, without a sign, that begins at i.
std::size_t decimal_length(std::string_view text, std::size_t i) {
  std::size_t end = i;
  while (end < text.size() && is_digit(text[end])) ++end;
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1]))
    for (++end; end < text.size() && is_digit(text[end]);) ++end;
  std::size_t exponent = end + 1;
  if (end > i && end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    if (exponent < text.size() && is_digit(text[exponent]))
      for (end = exponent; end < text.size() && is_digit(text[end]);) ++end;
  }
  return end - i;
}

std::size_t longest_run_of_digits(std::string_view text) {
  std::size_t longest = 0, run = 0;
  for (const char c : text) longest = std::max(longest, run = is_digit(c) ? run + 1 : 0);
  return longest;
}

/// How many digits a single decimal number has after its point, its exponent taken into account.
std::optional<int> decimal_places(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos || text.empty() || decimal_length(text, 0) != text.size())
    return std::nullopt;
  std::size_t end = point + 1;
  while (end < text.size() && is_digit(text[end])) ++end;
  long places = static_cast<long>(end - point - 1);
  if (end < text.size()) {
    long exponent = 0;
    for (const char c : text.substr(end))
      if (is_digit(c)) exponent = std::min(10 * exponent + (c - '0'), 1'000'000L);
    places += text.find('-', end) == std::string_view::npos ? -exponent : exponent;
  }
  return static_cast<int>(places);
}

}  // namespace

/// What is wrong with numbers in an entry, before the language reads it; "" when nothing is.
std::string TableauEntryReader::complaint(const std::string& text) const {
  if (std::ranges::count(text, '(') > std::ranges::count(text, ')'))
    return "'" + shortened(text) + "' has a ( that is not closed";
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '#') return "'#' does not belong into a coefficient";
    if (text[i] == '.' && !(i + 1 < text.size() && is_digit(text[i + 1])))
      return "'" + shortened(text) + "' has a point without digits";
    if (is_alphabetic(text[i])) {
      std::size_t end = i;
      while (end < text.size() && (is_alphabetic(text[end]) || is_digit(text[end]))) ++end;
      const std::string word = text.substr(i, end - i);
      if (word != "sqrt")
        return "'" + shortened(text) +
               "' is not a coefficient: a number, a fraction such as 1/3, or these with sqrt and + - * / ^";
      i = end;
      continue;
    }
    if (!is_digit(text[i]) && text[i] != '.') {
      ++i;
      continue;
    }
    const std::size_t length = decimal_length(text, i);
    const std::size_t end = i + std::max<std::size_t>(length, 1);
    const std::string kept = text.substr(0, i + length);
    if (end < text.size() && text[end] == '.' && !(end + 1 < text.size() && is_digit(text[end + 1])))
      return "the number '" + shortened(text.substr(i, length) + ".") + "' ends in a point; did you mean " +
             shortened(kept) + "?";
    if (end < text.size() && (text[end] == '(' || std::string_view(text).substr(end).starts_with("sqrt")))
      return "a product is written with *: " + shortened(kept + "*" + text.substr(end));
    if (end < text.size() && (is_alphabetic(text[end]) || text[end] == '.'))
      return "'" + shortened(text) + "' is not a number; did you mean " + shortened(kept) + "?";
    i = end;
  }
  return "";
}

std::optional<int> TableauEntryReader::places(const TableauEntry& entry) const {
  if (!entry.exact || entry.exact->is_zero()) return std::nullopt;
  if (digits_ && longest_run_of_digits(entry.text) >= kRoundedFrom) return digits_;
  const std::optional<int> printed = decimal_places(entry.text);
  if (!printed || decimals_ == Decimals::exact || *printed < 1) return std::nullopt;
  const std::string_view after = std::string_view(entry.text).substr(entry.text.find('.') + 1);
  const auto end = std::ranges::find_if_not(after, is_digit);
  const bool is_long = static_cast<std::size_t>(end - after.begin()) >= kRoundedFrom;
  return is_long || decimals_ == Decimals::rounded ? printed : std::nullopt;
}

void TableauEntryReader::approximate(TableauEntry& entry, const std::string& name) {
  const std::string decimal = entry.exact->decimal(*entry.digits);
  const auto [found, is_new] = names_.try_emplace(decimal, name);
  if (is_new) approximations_.push_back({name, Rational::parse(decimal), decimal, entry.place});
  entry.value = shortfall::name(found->second, entry.place);
}

TableauEntry TableauEntryReader::entry(const JsonValue& value, const std::string& name) {
  if (value.kind != JsonValue::Kind::number && value.kind != JsonValue::Kind::string)
    throw source_.error(value.place, "expected a coefficient, a number or a text such as \"1/3\"; found " +
                                         value.described());
  if (!value.plain) throw source_.error(value.place, "a coefficient is written without \\");
  TableauEntry entry;
  entry.place = value.place;
  if (value.kind == JsonValue::Kind::string) ++entry.place.column;
  entry.text = value.text;
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  const auto first = std::ranges::find_if_not(entry.text, blank);
  if (first == entry.text.end())
    throw source_.error(value.place, "the coefficient is empty; a zero is written 0");
  const std::size_t skipped = static_cast<std::size_t>(first - entry.text.begin());
  while (blank(entry.text.back())) entry.text.pop_back();
  entry.text.erase(0, skipped);
  entry.place.column += static_cast<int>(skipped);
  if (const std::string what = complaint(entry.text); !what.empty()) throw source_.error(entry.place, what);
  const std::size_t begin = value.byte + skipped;
  TokenReader in(source_, tokens_between(source_, value.place.line, begin, begin + entry.text.size()));
  entry.value = in.expression();
  in.expect_end("a coefficient");
  entry.exact = literal_value(entry.value);
  entry.decimal = entry.text.find('.') != std::string::npos;
  entry.digits = places(entry);
  if (entry.digits) approximate(entry, name);
  return entry;
}

}  // namespace shortfall
