// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random elements of the algebras for laws: CHECK(rc::check([](const Rational& a, const Rational& b) { ...
// })).

#include <rapidcheck.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

inline const std::vector<std::string>& letter_names() {
  static const std::vector<std::string> names{"a", "b", "c", "d", "e", "f", "g", "h",
                                              "i", "j", "k", "l", "m", "n", "o", "p"};
  return names;
}
inline void showValue(const Polynomial& p, std::ostream& out) { out << p.str(letter_names()); }
inline void showValue(const Fraction& f, std::ostream& out) { out << f.str(letter_names()); }

namespace random {

/// A whole number of up to so many decimal digits.
inline rc::Gen<Rational> integer_of_digits(int most) {
  return rc::gen::map(
      rc::gen::pair(rc::gen::container<std::string>(rc::gen::inRange('0', static_cast<char>('9' + 1))),
                    rc::gen::inRange(1, most + 1)),
      [](const std::pair<std::string, int>& p) {
        std::string digits;
        // Repeat what came with its length, so that large sizes are reached in short runs.
        while (static_cast<int>(digits.size()) < p.second) digits += p.first + "7";
        return Rational::parse(digits.substr(0, static_cast<std::size_t>(p.second)));
      });
}

/// Numbers at the edge of 64 bits.
inline rc::Gen<Rational> edge() {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  return rc::gen::map(
      rc::gen::pair(rc::gen::element(kLeast, kMost, kLeast / 2, kMost / 2, std::int64_t{1} << 32),
                    rc::gen::inRange(-2, 3)),
      [](const std::pair<std::int64_t, int>& p) { return Rational(p.first) + p.second; });
}

inline rc::Gen<Rational> quotient(rc::Gen<Rational> above, rc::Gen<Rational> below) {
  return rc::gen::map(rc::gen::tuple(std::move(above), std::move(below), rc::gen::arbitrary<bool>()),
                      [](const std::tuple<Rational, Rational, bool>& t) {
                        const auto& [p, q, negative] = t;
                        const Rational size = q.is_zero() ? p : p / q;
                        return negative ? -size : size;
                      });
}

inline rc::Gen<Rational> small_rational() {
  const auto small = [](int least) {
    return rc::gen::map(rc::gen::inRange(least, 13), [](int i) { return Rational(i); });
  };
  return quotient(small(0), small(1));
}

}  // namespace random
}  // namespace shortfall

namespace rc {

/// One in four of each: small, words, at the edge of a word, hundreds of digits.
template <>
struct Arbitrary<shortfall::Rational> {
  static Gen<shortfall::Rational> arbitrary() {
    using namespace shortfall::random;
    const auto word =
        gen::map(gen::arbitrary<std::int64_t>(), [](std::int64_t i) { return shortfall::Rational(i); });
    const auto long_word = gen::map(gen::inRange<std::int64_t>(1, std::numeric_limits<std::int64_t>::max()),
                                    [](std::int64_t i) { return shortfall::Rational(i); });
    return gen::oneOf(small_rational(), quotient(word, word), quotient(long_word, long_word),
                      quotient(edge(), gen::oneOf(edge(), word)),
                      quotient(integer_of_digits(200), integer_of_digits(200)));
  }
};

template <>
struct Arbitrary<shortfall::Polynomial> {
  static Gen<shortfall::Polynomial> arbitrary() {
    using namespace shortfall;
    const auto term = gen::map(
        gen::tuple(gen::inRange(0, 4), gen::inRange(0, 4), gen::inRange(0, 3),
                   shortfall::random::small_rational()),
        [](const std::tuple<int, int, int, Rational>& t) {
          const auto& [i, j, k, coefficient] = t;
          return Polynomial::Term{Monomial::of(0, i) * Monomial::of(3, j) * Monomial::of(15, k), coefficient};
        });
    return gen::map(
        gen::resize(8, gen::container<std::vector<Polynomial::Term>>(term)),
        [](std::vector<Polynomial::Term> terms) { return Polynomial::from_terms(std::move(terms)); });
  }
};

template <>
struct Arbitrary<shortfall::Fraction> {
  static Gen<shortfall::Fraction> arbitrary() {
    using namespace shortfall;
    const auto polynomial = gen::resize(4, gen::arbitrary<Polynomial>());
    return gen::map(gen::pair(polynomial, polynomial), [](const std::pair<Polynomial, Polynomial>& p) {
      return p.second.is_zero() ? Fraction(p.first) : Fraction(p.first, p.second);
    });
  }
};

}  // namespace rc
