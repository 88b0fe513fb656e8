// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <type_traits>

#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/polynomial.hpp"

// Products of polynomials. The coefficients are brought over one common denominator, so that the many
// products of terms need no gcd, and the exponents are packed into one word when they fit, as they nearly
// always do: 64-bit keys with 128-bit sums.

namespace shortfall {
namespace {

using Term = Polynomial::Term;

/// Where each letter's exponent stands in a word: total degree highest, so that words compare as monomials
/// do.
struct Packing {
  std::array<int, kLetters> letters{};
  std::array<int, kLetters> shifts{};
  std::array<std::uint64_t, kLetters> masks{};
  int count = 0;
  int degree_shift = 0;

  std::uint64_t pack(const Monomial& m) const {
    std::uint64_t key = static_cast<std::uint64_t>(m.total_degree()) << degree_shift;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      key |= static_cast<std::uint64_t>(m.exponent(letters[i])) << shifts[i];
    return key;
  }

  Monomial unpack(std::uint64_t key) const {
    Monomial m;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const int exponent = static_cast<int>(key >> shifts[i] & masks[i]);
      if (exponent > 0) m = m.with(letters[i], exponent);
    }
    return m;
  }
};

std::optional<Packing> packing(const Polynomial& a, const Polynomial& b) {
  Packing result;
  int used = 0;
  for (Letter letter = kLetters - 1; letter >= 0; --letter) {
    const int most = a.degree(letter) + b.degree(letter);
    if (most == 0) continue;
    const auto bits = static_cast<int>(std::bit_width(static_cast<unsigned>(most)));
    if (used + bits > 64) return std::nullopt;
    const auto i = static_cast<std::size_t>(result.count++);
    result.letters[i] = letter;
    result.shifts[i] = used;
    result.masks[i] = (std::uint64_t{1} << bits) - 1;
    used += bits;
  }
  const auto bits =
      static_cast<int>(std::bit_width(static_cast<unsigned>(a.total_degree() + b.total_degree())));
  if (used + bits > 64) return std::nullopt;
  result.degree_shift = used;
  return result;
}

/// The coefficients as integers over one denominator.
template <class Integer>
struct OverOne {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

std::optional<OverOne<std::int64_t>> short_form(const Polynomial& p, int& bits) {
  OverOne<std::int64_t> result;
  std::int64_t above, below;
  for (const Term& term : p.terms()) {
    if (!term.coefficient.fits_int64(above, below)) return std::nullopt;
    if (below == 1) continue;
    const auto common = static_cast<std::int64_t>(
        gcd(static_cast<std::uint64_t>(below), static_cast<std::uint64_t>(result.denominator)));
    if (__builtin_mul_overflow(result.denominator, below / common, &result.denominator)) return std::nullopt;
  }
  result.numerators.reserve(p.terms().size());
  std::uint64_t all = 0;
  for (const Term& term : p.terms()) {
    term.coefficient.fits_int64(above, below);
    if (__builtin_mul_overflow(above, result.denominator / below, &above)) return std::nullopt;
    all |= magnitude(above);
    result.numerators.push_back(above);
  }
  bits = static_cast<int>(std::bit_width(all));
  return result;
}

OverOne<mpz_class> long_form(const Polynomial& p) {
  OverOne<mpz_class> result;
  for (const Term& term : p.terms())
    mpz_lcm(result.denominator.get_mpz_t(), result.denominator.get_mpz_t(),
            GmpView(term.coefficient).denominator());
  result.numerators.reserve(p.terms().size());
  for (const Term& term : p.terms()) {
    const GmpView q(term.coefficient);
    mpz_ptr numerator = result.numerators.emplace_back().get_mpz_t();
    mpz_divexact(numerator, result.denominator.get_mpz_t(), q.denominator());
    mpz_mul(numerator, numerator, q.numerator());
  }
  return result;
}

inline std::size_t hash_of(std::uint64_t key) {
  key *= 0x9E3779B97F4A7C15ull;
  return key ^ (key >> 32);
}
inline std::size_t hash_of(const Monomial& key) { return key.hash(); }
inline std::uint64_t key_product(std::uint64_t a, std::uint64_t b) { return a + b; }
inline Monomial key_product(const Monomial& a, const Monomial& b) { return a * b; }

inline void add_product(Int128& sum, std::int64_t a, std::int64_t b) { sum += static_cast<Int128>(a) * b; }
inline void add_product(mpz_class& sum, const mpz_class& a, const mpz_class& b) {
  mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

/// Sums by key: a dense list of entries, and a table of their places by open addressing.
template <class Key, class Sum>
class Sums {
 public:
  struct Entry {
    Key key;
    Sum sum;
  };

  explicit Sums(std::size_t expected) : places_(std::bit_ceil(2 * expected + 16), 0) {
    entries_.reserve(expected);
  }

  Sum& operator[](const Key& key) {
    std::size_t slot = hash_of(key) & (places_.size() - 1);
    while (places_[slot] != 0) {
      Entry& entry = entries_[places_[slot] - 1];
      if (entry.key == key) return entry.sum;
      slot = (slot + 1) & (places_.size() - 1);
    }
    entries_.push_back({key, Sum(0)});
    places_[slot] = static_cast<std::uint32_t>(entries_.size());
    if (2 * entries_.size() > places_.size()) grow();
    return entries_.back().sum;
  }

  /// Largest key first.
  std::vector<Entry>& sorted() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return b.key < a.key; });
    return entries_;
  }

 private:
  void grow() {
    places_.assign(2 * places_.size(), 0);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      std::size_t slot = hash_of(entries_[i].key) & (places_.size() - 1);
      while (places_[slot] != 0) slot = (slot + 1) & (places_.size() - 1);
      places_[slot] = static_cast<std::uint32_t>(i + 1);
    }
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> places_;
};

template <class Sum, class Key, class Integer, class ToMonomial>
std::vector<Term> product(const std::vector<Key>& keys_a, const OverOne<Integer>& a,
                          const std::vector<Key>& keys_b, const OverOne<Integer>& b, ToMonomial to_monomial) {
  Sums<Key, Sum> sums(2 * (keys_a.size() + keys_b.size()));
  for (std::size_t i = 0; i < keys_a.size(); ++i)
    for (std::size_t j = 0; j < keys_b.size(); ++j)
      add_product(sums[key_product(keys_a[i], keys_b[j])], a.numerators[i], b.numerators[j]);
  const Sum denominator = Sum(a.denominator) * Sum(b.denominator);
  std::vector<Term> terms;
  for (const auto& [key, sum] : sums.sorted())
    if (sum != 0) terms.push_back({to_monomial(key), rational(sum, denominator)});
  return terms;
}

template <class ToKey>
auto keys(const Polynomial& p, ToKey to_key) {
  std::vector<std::decay_t<decltype(to_key(Monomial()))>> result;
  result.reserve(p.terms().size());
  for (const Term& term : p.terms()) result.push_back(to_key(term.monomial));
  return result;
}

template <class Key, class ToKey, class ToMonomial>
std::vector<Term> product(const Polynomial& a, const Polynomial& b, ToKey to_key, ToMonomial to_monomial) {
  const std::vector<Key> keys_a = keys(a, to_key);
  const std::vector<Key> keys_b = keys(b, to_key);
  int bits_a = 0, bits_b = 0;
  const auto short_a = short_form(a, bits_a);
  const auto short_b = short_a ? short_form(b, bits_b) : std::nullopt;
  // A coefficient is a sum of at most so many products: no sum can pass 2^126.
  const auto repeats = std::bit_width(std::min(a.terms().size(), b.terms().size()));
  if (short_b && bits_a + bits_b + repeats <= 126)
    return product<Int128>(keys_a, *short_a, keys_b, *short_b, to_monomial);
  return product<mpz_class>(keys_a, long_form(a), keys_b, long_form(b), to_monomial);
}

Polynomial times_term(const Polynomial& p, const Term& by) {
  std::vector<Term> terms;
  terms.reserve(p.terms().size());
  for (const Term& term : p.terms())
    terms.push_back({term.monomial * by.monomial,
                     by.coefficient.is_one() ? term.coefficient : term.coefficient * by.coefficient});
  return Polynomial::from_terms(std::move(terms));
}

}  // namespace

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  if (b.terms().size() == 1) return times_term(a, b.terms().front());
  if (a.terms().size() == 1) return times_term(b, a.terms().front());
  if (const auto packed = packing(a, b))
    return Polynomial::from_terms(product<std::uint64_t>(
        a, b, [&](const Monomial& m) { return packed->pack(m); },
        [&](std::uint64_t key) { return packed->unpack(key); }));
  const auto itself = [](const Monomial& m) { return m; };
  return Polynomial::from_terms(product<Monomial>(a, b, itself, itself));
}

}  // namespace shortfall
