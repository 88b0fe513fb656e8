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

/// A number in least..past-1, evenly: RapidCheck's own range shrinks with the size of the run and of every
/// resize.
template <class I>
rc::Gen<I> whole(I least, I past) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, past));
}

/// Up to so many elements.
template <class T>
rc::Gen<std::vector<T>> list(int most, rc::Gen<T> element) {
  return rc::gen::mapcat(whole(0, most + 1), [element](int count) {
    return rc::gen::container<std::vector<T>>(static_cast<std::size_t>(count), element);
  });
}

/// A whole number of up to so many decimal digits.
inline rc::Gen<Rational> integer_of_digits(int most) {
  return rc::gen::map(rc::gen::pair(rc::gen::container<std::string>(whole('0', static_cast<char>('9' + 1))),
                                    whole(1, most + 1)),
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
                    whole(-2, 3)),
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
    return rc::gen::map(whole(least, 13), [](int i) { return Rational(i); });
  };
  return quotient(small(0), small(1));
}

/// Up to so many terms in the letters 0, 3 and 15, with exponents below `past`.
inline rc::Gen<Polynomial> polynomial(int most, int past) {
  const auto term = rc::gen::map(
      rc::gen::tuple(whole(0, past), whole(0, past), whole(0, past), small_rational()),
      [](const std::tuple<int, int, int, Rational>& t) {
        const auto& [i, j, k, coefficient] = t;
        return Polynomial::Term{Monomial::of(0, i) * Monomial::of(3, j) * Monomial::of(15, k), coefficient};
      });
  return rc::gen::map(list<Polynomial::Term>(most, term), [](std::vector<Polynomial::Term> terms) {
    return Polynomial::from_terms(std::move(terms));
  });
}

inline rc::Gen<Polynomial> nonzero_polynomial(int most, int past) {
  return rc::gen::suchThat(polynomial(most, past), [](const Polynomial& p) { return !p.is_zero(); });
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
    const auto long_word = gen::map(whole<std::int64_t>(1, std::numeric_limits<std::int64_t>::max()),
                                    [](std::int64_t i) { return shortfall::Rational(i); });
    return gen::oneOf(small_rational(), quotient(word, word), quotient(long_word, long_word),
                      quotient(edge(), gen::oneOf(edge(), word)),
                      quotient(integer_of_digits(200), integer_of_digits(200)));
  }
};

template <>
struct Arbitrary<shortfall::Polynomial> {
  static Gen<shortfall::Polynomial> arbitrary() { return shortfall::random::polynomial(6, 4); }
};

/// Quotients with and without a common factor above and below.
template <>
struct Arbitrary<shortfall::Fraction> {
  static Gen<shortfall::Fraction> arbitrary() {
    using namespace shortfall;
    const auto factor = gen::oneOf(gen::just(Polynomial(1)), random::nonzero_polynomial(2, 2));
    return gen::map(gen::tuple(random::polynomial(3, 2), random::nonzero_polynomial(2, 2), factor),
                    [](const std::tuple<Polynomial, Polynomial, Polynomial>& t) {
                      const auto& [above, below, common] = t;
                      return Fraction(above * common, below * common);
                    });
  }
};

}  // namespace rc
