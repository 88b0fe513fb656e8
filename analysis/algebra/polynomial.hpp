// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A letter of a polynomial, by its place 0..15. What it is called is the caller's business.
using Letter = int;
inline constexpr int kLetters = 16;

/// A product of powers of letters: sixteen exponents of 16 bits. Ordered by total degree, then lexicographically, largest first.
class Monomial {
 public:
  Monomial() = default;
  static Monomial of(Letter letter, int exponent = 1);
  int exponent(Letter) const;
  int total_degree() const;
  bool is_one() const;
  /// throws  Unable  when an exponent would pass 65535
  friend Monomial operator*(const Monomial& a, const Monomial& b);
  Monomial without(Letter) const;  ///< that letter's exponent set to zero
  bool operator==(const Monomial&) const = default;
  bool operator<(const Monomial&) const;

 private:
  std::array<std::uint16_t, kLetters> exponents_{};
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

  const std::vector<Term>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const;
  Rational constant() const;  ///< the coefficient of 1
  int degree(Letter) const;   ///< -1 for zero
  int total_degree() const;
  bool contains(Letter letter) const { return degree(letter) > 0; }

  Polynomial operator-() const;
  Polynomial& operator+=(const Polynomial&);
  Polynomial& operator-=(const Polynomial&);
  Polynomial& operator*=(const Polynomial&);
  Polynomial& operator*=(const Rational&);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
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
  std::vector<Term> terms_;
};

/// The greatest common divisor, monic (leading coefficient 1); zero only for two zeros.  By FLINT.
Polynomial gcd(const Polynomial& a, const Polynomial& b);
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
