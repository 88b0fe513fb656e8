// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/known_digits.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

KnownDigits KnownDigits::printed(const std::string& decimal) {
  const Rational value = Rational::parse(decimal);
  if (decimal.find('/') != std::string::npos) throw BadInput("'" + decimal + "' is no decimal");
  // One unit of the last digit printed: digits after the point, moved by the exponent.
  const std::size_t e = decimal.find_first_of("eE");
  const std::string mantissa = decimal.substr(0, e);
  const std::size_t point = mantissa.find('.');
  int last = point == std::string::npos ? 0 : -static_cast<int>(mantissa.size() - point - 1);
  if (e != std::string::npos) last += std::stoi(decimal.substr(e + 1));
  const Rational unit = Rational(10).pow(last);
  return KnownDigits(hull(Ball(value - unit, kBits), Ball(value + unit, kBits)));
}

int KnownDigits::digits() const {
  constexpr int kMost = 76;  // of 256 bits
  const Ball centred = ball_ - Ball(ball_.midpoint(), kBits);
  int digits = 0;
  while (digits < kMost && !centred.is_exact()) {
    const Rational bound = Rational(10).pow(-(digits + 1));
    if (centred.contains(bound) || centred.contains(-bound)) break;
    ++digits;
  }
  return centred.is_exact() ? kMost : digits;
}

std::string KnownDigits::str() const {
  if (is_zero()) return "0";
  for (int count = 60; count >= 1; --count)
    if (const auto text = ball_.significant(count)) return *text;
  return "0";
}

}  // namespace shortfall
