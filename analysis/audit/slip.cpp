// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/slip.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "analysis/algebra/characters.hpp"
#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  if (text.starts_with('+')) text.erase(0, 1);
  return text;
}

std::optional<Rational> value_of(const std::string& text) {
  try {
    return Rational::parse(text);
  } catch (const Error&) {
    return std::nullopt;
  }
}

struct Quotient {
  std::string numerator;
  std::string denominator;
};

/// p/q of digits, as it is written.
std::optional<Quotient> quotient(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  Quotient q{text.substr(0, slash), text.substr(slash + 1)};
  const auto digits = [](std::string part) {
    if (part.starts_with('-')) part.erase(0, 1);
    return !part.empty() && std::ranges::all_of(part, is_digit);
  };
  if (!digits(q.numerator) || !digits(q.denominator)) return std::nullopt;
  return q;
}

int places(const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
}

/// The characters that differ, when the texts are of one length.
std::vector<std::size_t> differences(const std::string& a, const std::string& b) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) result.push_back(i);
  return result;
}

bool is_sign(char c) { return c == '+' || c == '-'; }

std::optional<Slip> of_one_length(const std::string& printed, const std::string& right) {
  const auto at = differences(printed, right);
  if (at.size() == 1) {
    if (is_sign(printed[at[0]]) && is_sign(right[at[0]])) return Slip{"a sign is the other one", 1};
    if (is_digit(printed[at[0]]) && is_digit(right[at[0]])) return Slip{"a digit is wrong", 1};
    return Slip{"a character is wrong", 1.5};
  }
  if (at.size() == 2 && printed[at[0]] == right[at[1]] && printed[at[1]] == right[at[0]])
    return at[1] == at[0] + 1 ? Slip{"two digits change places", 1}
                              : Slip{"two characters are exchanged", 1.5};
  return std::nullopt;
}

/// `longer` is `shorter` with one character more.
std::optional<std::size_t> one_more(const std::string& longer, const std::string& shorter) {
  if (longer.size() != shorter.size() + 1) return std::nullopt;
  std::size_t i = 0;
  while (i < shorter.size() && longer[i] == shorter[i]) ++i;
  if (longer.substr(i + 1) != shorter.substr(i)) return std::nullopt;
  return i;
}

std::optional<Slip> of_lengths(const std::string& printed, const std::string& right) {
  if (const auto i = one_more(right, printed)) {
    if (is_sign(right[*i])) return Slip{"a sign is lost", 1};
    if (is_digit(right[*i])) return Slip{"a digit is dropped", 1.1};
    return Slip{"a character is dropped", 1.5};
  }
  if (const auto i = one_more(printed, right)) {
    if (is_sign(printed[*i])) return Slip{"there is a sign too many", 1};
    const bool doubled = (*i > 0 && printed[*i - 1] == printed[*i]) ||
                         (*i + 1 < printed.size() && printed[*i + 1] == printed[*i]);
    if (is_digit(printed[*i])) return Slip{doubled ? "a digit is doubled" : "there is a digit too many", 1.1};
    return Slip{"there is a character too many", 1.5};
  }
  return std::nullopt;
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::vector<std::string> before_a_slip(const std::string& printed) {
  std::vector<std::string> result{printed.starts_with('-') ? printed.substr(1) : "-" + printed};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const auto add = [&](auto&& change) {
      std::string text = printed;
      change(text);
      result.push_back(std::move(text));
    };
    if (i > 0 && is_sign(printed[i])) add([&](std::string& t) { t[i] = t[i] == '+' ? '-' : '+'; });
    if (!is_digit(printed[i])) continue;
    for (char c = '0'; c <= '9'; ++c) {
      if (c != printed[i]) add([&](std::string& t) { t[i] = c; });
      add([&](std::string& t) { t.insert(i, 1, c); });
      if (i + 1 == printed.size() || !is_digit(printed[i + 1]))
        add([&](std::string& t) { t.insert(i + 1, 1, c); });
    }
    const bool alone =
        (i == 0 || !is_digit(printed[i - 1])) && (i + 1 == printed.size() || !is_digit(printed[i + 1]));
    if (!alone) add([&](std::string& t) { t.erase(i, 1); });
    if (i + 1 < printed.size() && is_digit(printed[i + 1]))
      add([&](std::string& t) { std::swap(t[i], t[i + 1]); });
  }
  return result;
}

Slip slip(const std::string& printed_text, const std::string& right_text) {
  constexpr std::size_t kLongest = 200;
  const std::string printed = without_blanks(printed_text).substr(0, kLongest),
                    right = without_blanks(right_text).substr(0, kLongest);
  if (printed == right) return {"", 0};
  const auto is = value_of(printed), should = value_of(right);
  if (is && is->is_zero()) return {"an entry is left out", 2};
  if (is && should && printed.find('.') != std::string::npos && right.find('.') == std::string::npos &&
      (*is - *should).abs() < Rational(1) / Rational(10).pow(places(printed)))
    return {"a decimal has too few digits", 0.5};
  if (is && should && !should->is_zero() && (*is * *should).is_one())
    return {"a fraction is upside down", 1.3};
  if (printed.size() == right.size())
    if (const auto found = of_one_length(printed, right)) return *found;
  if (const auto found = of_lengths(printed, right)) return *found;
  if (is && should && *is == -*should) return {"a sign is lost", 1};
  if (is && should && !should->is_zero()) {
    const Rational ratio = *is / *should;
    if (ratio == Rational(10) || ratio == Rational(1, 10)) return {"the point, or a zero, is misplaced", 1.4};
  }
  const int distance = edit_distance(printed, right);
  const auto p = quotient(printed), r = quotient(right);
  if (p && r && p->numerator == r->numerator)
    return {"the denominator is wrong", 1.6 + 0.2 * std::min(distance, 8)};
  if (p && r && p->denominator == r->denominator)
    return {"the numerator is wrong", 1.6 + 0.2 * std::min(distance, 8)};
  // A long number is found by a slip of a few characters less easily than by a computation gone wrong.
  return {"", 2.2 + 0.3 * std::min(distance, 8) +
                  0.08 * static_cast<double>(std::min<std::size_t>(right.size(), 60))};
}

std::string written_like(const Rational& value, const std::string& printed_text) {
  const std::string printed = without_blanks(printed_text);
  std::vector<std::string> forms{value.str()};
  if (const auto q = quotient(printed)) {
    const Rational below = Rational::parse(q->denominator), above = Rational::parse(q->numerator);
    if ((value * below).is_integer()) forms.push_back((value * below).str() + "/" + q->denominator);
    if (!value.is_zero()) {
      const Rational needed = above / value;
      if (needed.is_integer() && needed.sign() != 0)
        forms.push_back(needed.sign() > 0 ? q->numerator + "/" + needed.str()
                                          : (-above).str() + "/" + (-needed).str());
    }
  } else if (printed.find('.') != std::string::npos) {
    for (int k = 1; k <= 40; ++k)
      if ((value * Rational(10).pow(k)).is_integer()) {
        forms.push_back(value.decimal(k));
        if (k < places(printed)) forms.push_back(value.decimal(places(printed)));
        break;
      }
  }
  // Not in lowest terms only where a small slip leads to it: nobody reduces long fractions, everybody 2/8.
  constexpr double kSmall = 1.2;
  constexpr std::size_t kLongDenominator = 3;
  const auto cost = [&](const std::string& f) { return slip(printed, f).cost; };
  const std::string& best = *std::ranges::min_element(forms, {}, cost);
  const auto q = quotient(printed);
  const bool is_long = !q || q->denominator.size() >= kLongDenominator;
  return cost(best) <= kSmall && is_long && !value.is_integer() ? best : forms.front();
}

}  // namespace shortfall
