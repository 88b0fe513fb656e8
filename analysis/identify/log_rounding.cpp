// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/log_rounding.hpp"

#include "analysis/algebra/general_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace shortfall {

namespace {

struct Digits {
  int significant = 0;
  int decimals = 0;
};

Digits digits_of(std::string_view text) {
  Digits result;
  bool point = false, leading = true;
  int exponent = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == 'e' || c == 'E') {
      const std::size_t from = i + 1 + (text.substr(i + 1).starts_with('+') ? 1 : 0);
      std::from_chars(text.data() + std::min(from, text.size()), text.data() + text.size(), exponent);
      break;
    }
    if (c == '.') point = true;
    if (c < '0' || c > '9') continue;
    if (c != '0') leading = false;
    if (!leading) ++result.significant;
    if (point) ++result.decimals;
  }
  result.decimals = std::max(0, result.decimals - exponent);
  return result;
}

/// Whether a program that writes a binary32 with all its digits would write this.
bool written_as_binary32(double value) {
  const float narrow = static_cast<float>(value);
  if (double_of(general_text(static_cast<double>(narrow), 9)) == value) return true;
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), narrow).ptr;
  return double_of({text.data(), end}) == value;
}

}  // namespace

double LogRounding::half(double value) const {
  if (kind == Kind::decimals) return 0.5 * std::pow(10.0, -digits);
  if (kind != Kind::significant) return 0;
  const double size = std::fabs(value);
  return 0.5 * std::pow(10.0, (size > 0 ? std::floor(std::log10(size)) : -300.0) + 1 - digits);
}

std::string LogRounding::str() const {
  if (kind == Kind::binary32) return "binary32";
  if (kind == Kind::binary64) return "binary64";
  return std::to_string(digits) + (kind == Kind::decimals ? " decimals" : " significant digits");
}

void RoundingWatch::see(std::string_view text, double value) {
  const Digits d = digits_of(text);
  ++seen_;
  narrow_ += written_as_binary32(value);
  most_significant_ = std::max(most_significant_, d.significant);
  most_decimals_ = std::max(most_decimals_, d.decimals);
  ++decimals_[static_cast<std::size_t>(std::clamp(d.decimals, 0, 31))];
}

LogRounding RoundingWatch::rounding() const {
  if (most_significant_ >= 15) return {LogRounding::Kind::binary64, 0};
  if (most_significant_ >= 8 && narrow_ == seen_) return {LogRounding::Kind::binary32, 0};
  // Printed to so many digits in all, large numbers have fewer of them after the point. Zeros at the end may
  // have been left out, in one number of ten.
  const long full = decimals_[static_cast<std::size_t>(std::clamp(most_decimals_, 0, 31))];
  if (most_significant_ <= 9 && 2 * full < seen_ && most_significant_ >= 5)
    return {LogRounding::Kind::significant, most_significant_};
  return {LogRounding::Kind::decimals, most_decimals_};
}

}  // namespace shortfall
