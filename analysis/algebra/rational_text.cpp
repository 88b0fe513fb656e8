// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>

#include "analysis/algebra/characters.hpp"
#include "analysis/algebra/decimal.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {
namespace {

constexpr long kMostDigits = 10'000;
/// Beyond this a number has more than kMostDigits digits whatever cancels: a decimal whose mantissa has no
/// factor 10 keeps at least a power of two below (2^100000), or most of its mantissa above.
constexpr long kHopeless = 100'000;

/// The text, quoted, short and printable.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  return "\"" + shown + (text.size() > kShown ? "..." : "") + "\"";
}

[[noreturn]] void refuse_length(std::string_view text) {
  throw BadInput(in_quotes(text) + " has more than 10,000 digits, which is our limit");
}

[[noreturn]] void refuse(std::string_view text) {
  if (text.find_first_of(" \t\r\n") != std::string_view::npos)
    throw BadInput(in_quotes(text) + " is not a number: there is a space in it");
  throw BadInput(in_quotes(text) + " is not a number; a number looks like 3, -1/50, 0.02 or 1.5e-3");
}

std::string_view leading_digits(std::string_view& rest) {
  std::size_t n = 0;
  while (n < rest.size() && is_digit(rest[n])) ++n;
  const std::string_view digits = rest.substr(0, n);
  rest.remove_prefix(n);
  return digits;
}

mpz_class integer(std::string_view digits) {
  return digits.empty() ? mpz_class(0) : mpz_class(std::string(digits), 10);
}

/// The exponent after an e, clipped where the number is hopeless anyway.
long exponent(std::string_view digits, bool negative) {
  long value = 0;
  for (const char c : digits) value = std::min(10 * value + (c - '0'), 100 * kHopeless);
  return negative ? -value : value;
}

}  // namespace

Rational Rational::parse(std::string_view text) {
  if (text.empty()) throw BadInput("an empty text is not a number");
  if (text.size() > static_cast<std::size_t>(kHopeless)) refuse_length(text);
  std::string_view rest = text;
  const bool negative = rest.front() == '-';
  if (negative || rest.front() == '+') rest.remove_prefix(1);
  const std::string_view whole = leading_digits(rest);

  Rational value;
  if (!rest.empty() && rest.front() == '/') {
    rest.remove_prefix(1);
    const std::string_view below = leading_digits(rest);
    if (whole.empty() || below.empty() || !rest.empty()) refuse(text);
    if (below.find_first_not_of('0') == std::string_view::npos)
      throw BadInput(in_quotes(text) + " is a division by zero");
    value = rational(integer(whole), integer(below));
  } else {
    std::string mantissa(whole);
    long ten = 0;
    if (!rest.empty() && rest.front() == '.') {
      rest.remove_prefix(1);
      const std::string_view after = leading_digits(rest);
      if (after.empty()) refuse(text);
      mantissa += after;
      ten = -static_cast<long>(after.size());
    }
    if (mantissa.empty()) refuse(text);
    if (!rest.empty() && (rest.front() == 'e' || rest.front() == 'E')) {
      rest.remove_prefix(1);
      const bool down = !rest.empty() && rest.front() == '-';
      if (down || (!rest.empty() && rest.front() == '+')) rest.remove_prefix(1);
      const std::string_view digits = leading_digits(rest);
      if (digits.empty()) refuse(text);
      ten += exponent(digits, down);
    }
    if (!rest.empty()) refuse(text);
    mantissa.erase(0, mantissa.find_first_not_of('0'));
    if (mantissa.empty()) return 0;
    const std::size_t last = mantissa.find_last_not_of('0');
    ten += static_cast<long>(mantissa.size() - 1 - last);
    mantissa.resize(last + 1);
    if (ten > kMostDigits || ten < -kHopeless) refuse_length(text);
    mpz_class above = integer(mantissa);
    mpz_class below = 1;
    (ten > 0 ? above : below) *= power_of_ten(static_cast<unsigned long>(ten > 0 ? ten : -ten));
    value = rational(std::move(above), std::move(below));
  }
  if (value.digits() > static_cast<std::size_t>(kMostDigits)) refuse_length(text);
  return negative ? -value : value;
}

std::string Rational::str() const {
  if (!big_) {
    std::string text = std::to_string(numerator_);
    return denominator_ == 1 ? text : text + "/" + std::to_string(denominator_);
  }
  return gmp(*this).get_str();
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

void check_digits(int digits, int least) {
  if (digits < least)
    throw Error("at least " + std::to_string(least) + " digits can be shown, not " + std::to_string(digits));
  if (digits > 1'000'000) throw Unable("more than a million digits are not shown");
}

std::string decimal_text(const mpz_class& whole, int places) {
  std::string digits = mpz_class(::abs(whole)).get_str();
  const auto after = static_cast<std::size_t>(places);
  if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
  if (after > 0) digits.insert(digits.size() - after, ".");
  return whole < 0 ? "-" + digits : digits;
}

std::string significant_text(const mpz_class& whole, long exponent) {
  std::string digits = mpz_class(::abs(whole)).get_str();
  const long count = static_cast<long>(digits.size());
  if (exponent < -6 || exponent >= 15) {
    if (count > 1) digits.insert(1, ".");
    const std::string size = std::to_string(exponent < 0 ? -exponent : exponent);
    digits += (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" + size : size);
  } else if (exponent < 0) {
    digits.insert(0, "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0'));
  } else if (exponent + 1 < count) {
    digits.insert(static_cast<std::size_t>(exponent + 1), ".");
  } else {
    digits.append(static_cast<std::size_t>(exponent + 1 - count), '0');
  }
  return whole < 0 ? "-" + digits : digits;
}

namespace {

/// above / below * 10^shift, rounded to the nearest integer, ties upwards; both positive.
mpz_class scaled(mpz_class above, mpz_class below, long shift) {
  (shift > 0 ? above : below) *= power_of_ten(static_cast<unsigned long>(shift > 0 ? shift : -shift));
  return (2 * above + below) / (2 * below);
}

}  // namespace

std::string Rational::decimal(int places) const {
  check_digits(places, 0);
  mpz_class whole = scaled(::abs(gmp_numerator(*this)), gmp_denominator(*this), places);
  if (sign() < 0) whole = -whole;
  return decimal_text(whole, places);
}

std::string Rational::significant(int digits) const {
  check_digits(digits, 1);
  if (is_zero()) return "0";
  const mpz_class above = ::abs(gmp_numerator(*this));
  const mpz_class below = gmp_denominator(*this);
  // 10^exponent <= |x| < 10^(exponent + 1); the sizes are right to one digit.
  long exponent = static_cast<long>(mpz_sizeinbase(above.get_mpz_t(), 10)) -
                  static_cast<long>(mpz_sizeinbase(below.get_mpz_t(), 10)) + 1;
  const auto below_power = [&](long e) {
    return e >= 0 ? above < below * power_of_ten(static_cast<unsigned long>(e))
                  : above * power_of_ten(static_cast<unsigned long>(-e)) < below;
  };
  while (below_power(exponent)) --exponent;
  mpz_class whole = scaled(above, below, digits - 1 - exponent);
  if (whole == power_of_ten(static_cast<unsigned long>(digits))) {
    whole /= 10;
    ++exponent;
  }
  if (sign() < 0) whole = -whole;
  return significant_text(whole, exponent);
}

std::size_t Rational::digits() const {
  std::size_t most = 1;
  for (const mpz_class& z : {mpz_class(::abs(gmp_numerator(*this))), gmp_denominator(*this)}) {
    std::size_t count = mpz_sizeinbase(z.get_mpz_t(), 10);
    // GMP's estimate may be one too large.
    if (count > 1 && z < power_of_ten(count - 1)) --count;
    most = std::max(most, count);
  }
  return most;
}

}  // namespace shortfall
