// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A letter of a polynomial, by its place 0..15. What it is called is the caller's business.
using Letter = int;
inline constexpr int kLetters = 16;

/// A product of powers of letters: sixteen exponents of 16 bits. Ordered by total degree, then
/// lexicographically, largest first.
///
/// Four exponents share a word, letter 0 highest, so that words compare as the exponents do.
class Monomial {
 public:
  Monomial() = default;
  /// throws  Unable  when the exponent is not in 0..65535;  Error  when there is no such letter
  static Monomial of(Letter letter, int exponent = 1) { return Monomial().with(letter, exponent); }
  int exponent(Letter letter) const {
    check(letter);
    return static_cast<int>(words_[static_cast<std::size_t>(letter) / 4] >> shift(letter) & 0xFFFF);
  }
  int total_degree() const {
    constexpr std::uint64_t kEvenLanes = 0x0000'FFFF'0000'FFFF;
    std::uint64_t sum = 0;
    for (const std::uint64_t w : words_) sum += (w & kEvenLanes) + (w >> 16 & kEvenLanes);
    return static_cast<int>((sum & 0xFFFF'FFFF) + (sum >> 32));
  }
  bool is_one() const { return (words_[0] | words_[1] | words_[2] | words_[3]) == 0; }
  /// throws  Unable  when an exponent would pass 65535
  friend Monomial operator*(const Monomial& a, const Monomial& b) {
    Monomial product;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.words_.size(); ++i) {
      const std::uint64_t x = a.words_[i], y = b.words_[i], sum = x + y;
      carry |= (x & y) | ((x | y) & ~sum);
      product.words_[i] = sum;
    }
    if (carry & kHighBits) overflow();
    return product;
  }
  bool divides(const Monomial& other) const {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t x = other.words_[i], y = words_[i], difference = x - y;
      borrow |= (~x & y) | ((~x | y) & difference);
    }
    return (borrow & kHighBits) == 0;
  }
  /// The quotient; b must divide a.
  friend Monomial operator/(Monomial a, const Monomial& b) {
    for (std::size_t i = 0; i < a.words_.size(); ++i) a.words_[i] -= b.words_[i];
    return a;
  }
  Monomial with(Letter, int exponent) const;  ///< that letter's exponent replaced
  Monomial without(Letter letter) const { return with(letter, 0); }
  /// The largest monomial that divides both.
  static Monomial gcd(const Monomial& a, const Monomial& b);
  Monomial pow(int exponent) const;
  bool operator==(const Monomial&) const = default;
  bool operator<(const Monomial& other) const {
    const int mine = total_degree(), theirs = other.total_degree();
    return mine != theirs ? mine < theirs : words_ < other.words_;
  }
  std::size_t hash() const;

 private:
  static constexpr std::uint64_t kHighBits = 0x8000'8000'8000'8000;
  static int shift(Letter letter) { return 48 - 16 * (letter % 4); }
  static void check(Letter letter) {
    if (letter < 0 || letter >= kLetters) no_such_letter(letter);
  }
  [[noreturn]] static void no_such_letter(Letter);
  [[noreturn]] static void overflow();
  std::array<std::uint64_t, kLetters / 4> words_{};
};

/// A polynomial in up to sixteen letters over the rationals.
///
/// Invariant: terms sorted by decreasing monomial, no zero coefficient; so equality is structural.
class Polynomial {
 public:
  struct Term {
    Monomial monomial;
    Rational coefficient;
    bool operator==(const Term&) const = default;
  };

  Polynomial() = default;
  Polynomial(Rational constant);
  template <std::integral I>
  Polynomial(I constant) : Polynomial(Rational(constant)) {}
  static Polynomial letter(Letter letter, int exponent = 1);
  /// Sum of coefficients[k] letter^k.
  static Polynomial in(Letter letter, std::span<const Rational> coefficients);
  static Polynomial from_terms(std::vector<Term> terms);  ///< in any order, with repeats

  const std::vector<Term>& terms() const& { return terms_; }
  std::vector<Term> terms() && { return std::move(terms_); }  ///< so that a loop over a temporary is safe
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const;
  Rational constant() const;  ///< the coefficient of 1
  int degree(Letter) const;   ///< -1 for zero
  int total_degree() const;   ///< -1 for zero
  bool contains(Letter letter) const { return degree(letter) > 0; }

  Polynomial operator-() const;
  Polynomial& operator+=(const Polynomial&);
  Polynomial& operator-=(const Polynomial&);
  Polynomial& operator*=(const Polynomial&);
  Polynomial& operator*=(const Rational&);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    a += b;
    return a;
  }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) {
    a -= b;
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  bool operator==(const Polynomial&) const = default;
  Polynomial pow(int exponent) const;

  /// The coefficient of letter^power, a polynomial in the other letters.
  Polynomial coefficient(Letter letter, int power) const;
  /// All of them, lowest power first.
  std::vector<Polynomial> coefficients(Letter letter) const;
  Polynomial substitute(Letter letter, const Polynomial& value) const;
  Polynomial substitute(Letter letter, const Rational& value) const;
  /// throws  Error  when a letter that occurs has no value
  Rational evaluate(const std::map<Letter, Rational>& values) const;
  Polynomial derivative(Letter letter) const;

  /// "3/2*h^2*n - 1", letters named by the caller; "0" for zero.
  std::string str(std::span<const std::string> names) const;

 private:
  void add(const Polynomial&, bool negated);
  std::vector<Term> terms_;
};

/// The greatest common divisor, monic (leading coefficient 1); zero only for two zeros.  By FLINT.
Polynomial gcd(const Polynomial& a, const Polynomial& b);
/// The same, with a and b divided by it (where wanted; not a or b themselves), which comes nearly for
/// nothing.
Polynomial gcd(const Polynomial& a, const Polynomial& b, Polynomial* a_rest, Polynomial* b_rest);
/// a / b.  throws  Undefined  when b is zero or does not divide a.
Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);
/// Whether b divides a; then *quotient is set.
bool divides(const Polynomial& b, const Polynomial& a, Polynomial* quotient);
/// Irreducible factors over the rationals with multiplicities, monic, and the constant in front.
struct Factorization {
  Rational constant;
  std::vector<std::pair<Polynomial, int>> factors;
};
Factorization factor(const Polynomial&);

}  // namespace shortfall
