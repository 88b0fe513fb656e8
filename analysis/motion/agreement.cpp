// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/agreement.hpp"

#include <algorithm>

namespace shortfall {

namespace {

Rational unit(int digits) { return Rational(1) / Rational(10).pow(digits); }

int digits_after_the_point(const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  const std::size_t end = std::min(decimal.find_first_of("eE"), decimal.size());
  const int shift = end < decimal.size() ? std::stoi(decimal.substr(end + 1)) : 0;
  return std::max(0, static_cast<int>(end - point) - 1 - shift);
}

}  // namespace

int printed_digits(const Program& program) {
  int fewest = 0;
  for (const Approximation& a : program.approximations) {
    const int digits = digits_after_the_point(a.text);
    fewest = &a == program.approximations.data() ? digits : std::min(fewest, digits);
  }
  return fewest;
}

std::string about_printed_decimals(const Program& program) {
  if (!program.approximate()) return {};
  return "the results are about the decimals as printed, " + std::to_string(printed_digits(program)) +
         " digits after the point, which stand for other numbers";
}

void Agreement::add(const Fraction& difference) {
  if (difference.is_zero() || !holds_) return;
  holds_ = printed_ > kLost && difference.is_polynomial();
  if (!holds_) return;
  for (const Polynomial::Term& term : difference.numerator().terms())
    largest_ = std::max(largest_, term.coefficient.abs());
  holds_ = largest_ < unit(printed_ - kLost);
}

void Agreement::add(const Sequence& difference) {
  if (difference.is_polynomial())
    add(difference.polynomial());
  else
    holds_ = false;
}

int Agreement::digits() const {
  if (printed_ == 0) return 0;
  int digits = printed_;
  while (digits > 0 && largest_ >= unit(digits)) --digits;
  return digits;
}

}  // namespace shortfall
