// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/polynomial.hpp"

namespace shortfall {
namespace {

constexpr int kMostExponent = 65535;

}  // namespace

void Monomial::no_such_letter(Letter letter) {
  throw Error("a polynomial has the letters 0 to 15; there is no letter " + std::to_string(letter));
}

void Monomial::overflow() { throw Unable("a power of a letter would pass 65535, which is our limit"); }

Monomial Monomial::with(Letter letter, int exponent) const {
  check(letter);
  if (exponent < 0) throw Error("a monomial has no negative powers, such as " + std::to_string(exponent));
  if (exponent > kMostExponent) overflow();
  Monomial result = *this;
  std::uint64_t& word = result.words_[static_cast<std::size_t>(letter) / 4];
  word = (word & ~(std::uint64_t{0xFFFF} << shift(letter))) | static_cast<std::uint64_t>(exponent)
                                                                  << shift(letter);
  return result;
}

Monomial Monomial::gcd(const Monomial& a, const Monomial& b) {
  Monomial result;
  for (Letter letter = 0; letter < kLetters; ++letter) {
    const int least = std::min(a.exponent(letter), b.exponent(letter));
    if (least > 0) result = result.with(letter, least);
  }
  return result;
}

Monomial Monomial::pow(int exponent) const {
  if (exponent < 0) throw Error("a monomial has no negative powers, such as " + std::to_string(exponent));
  Monomial result;
  for (Letter letter = 0; letter < kLetters; ++letter) {
    const std::int64_t power = static_cast<std::int64_t>(this->exponent(letter)) * exponent;
    if (power > kMostExponent) overflow();
    if (power > 0) result = result.with(letter, static_cast<int>(power));
  }
  return result;
}

std::size_t Monomial::hash() const {
  std::uint64_t h = 0;
  for (const std::uint64_t word : words_) {
    h = (h ^ word) * 0x9E3779B97F4A7C15ull;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace shortfall
