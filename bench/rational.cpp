// SPDX-License-Identifier: GPL-3.0-or-later
// Rational beside the rational numbers of GMP (mpq_t), Boost (mpq_rational, expression templates off) and
// FLINT (fmpq): the same operations on the same numbers, each library in the way that is natural to it.
#include <gmpxx.h>

#include <flint/flint.h>
#include <flint/fmpq.h>

#include <boost/multiprecision/gmp.hpp>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/ratios.hpp"

using shortfall::Rational;
using BoostRational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

namespace {

/// mpq_t and fmpq with a life, and nothing else: the operations below write into what is there.
struct Gmp {
  Gmp() { mpq_init(q); }
  explicit Gmp(const std::string& text) : Gmp() { mpq_set_str(q, text.c_str(), 10); }
  Gmp(const Gmp& other) : Gmp() { mpq_set(q, other.q); }
  Gmp& operator=(const Gmp& other) {
    mpq_set(q, other.q);
    return *this;
  }
  ~Gmp() { mpq_clear(q); }
  std::string str() const { return mpq_class(q).get_str(); }
  mpq_t q;
};

struct Flint {
  Flint() { fmpq_init(q); }
  explicit Flint(const std::string& text) : Flint() { fmpq_set_str(q, text.c_str(), 10); }
  Flint(const Flint& other) : Flint() { fmpq_set(q, other.q); }
  Flint& operator=(const Flint& other) {
    fmpq_set(q, other.q);
    return *this;
  }
  ~Flint() { fmpq_clear(q); }
  std::string str() const {
    mpq_class value;
    fmpq_get_mpq(value.get_mpq_t(), q);
    return value.get_str();
  }
  fmpq_t q;
};

void sum_into(Gmp& r, const Gmp& a, const Gmp& b) { mpq_add(r.q, a.q, b.q); }
void product_into(Gmp& r, const Gmp& a, const Gmp& b) { mpq_mul(r.q, a.q, b.q); }
void quotient_into(Gmp& r, const Gmp& a, const Gmp& b) { mpq_div(r.q, a.q, b.q); }
void add_to(Gmp& sum, const Gmp& b) { mpq_add(sum.q, sum.q, b.q); }
void multiply_to(Gmp& product, const Gmp& b) { mpq_mul(product.q, product.q, b.q); }
bool less(const Gmp& a, const Gmp& b) { return mpq_cmp(a.q, b.q) < 0; }
void sum_into(Flint& r, const Flint& a, const Flint& b) { fmpq_add(r.q, a.q, b.q); }
void product_into(Flint& r, const Flint& a, const Flint& b) { fmpq_mul(r.q, a.q, b.q); }
void quotient_into(Flint& r, const Flint& a, const Flint& b) { fmpq_div(r.q, a.q, b.q); }
void add_to(Flint& sum, const Flint& b) { fmpq_add(sum.q, sum.q, b.q); }
void multiply_to(Flint& product, const Flint& b) { fmpq_mul(product.q, product.q, b.q); }
bool less(const Flint& a, const Flint& b) { return fmpq_cmp(a.q, b.q) < 0; }
template <class T>
void sum_into(T& r, const T& a, const T& b) {
  r = a + b;
}
template <class T>
void product_into(T& r, const T& a, const T& b) {
  r = a * b;
}
template <class T>
void add_to(T& sum, const T& b) {
  sum += b;
}
template <class T>
void multiply_to(T& product, const T& b) {
  product *= b;
}
template <class T>
void quotient_into(T& r, const T& a, const T& b) {
  r = a / b;
}
template <class T>
bool less(const T& a, const T& b) {
  return a < b;
}

template <class T>
T number(const std::string& text) {
  return T(text);
}
template <>
Rational number<Rational>(const std::string& text) {
  return Rational::parse(text);
}

/// Texts of random non-zero numbers, the same in every run; numerator and denominator up to so many bits.
std::vector<std::string> texts(int bits, bool integers, unsigned seed) {
  gmp_randclass random(gmp_randinit_default);
  random.seed(seed);
  std::vector<std::string> result;
  for (int i = 0; i < 256; ++i) {
    mpz_class above = random.get_z_bits(static_cast<mp_bitcnt_t>(bits)) + 1;
    if (random.get_z_bits(1) == 1) above = -above;
    mpq_class q(above,
                integers ? mpz_class(1) : mpz_class(random.get_z_bits(static_cast<mp_bitcnt_t>(bits)) + 1));
    q.canonicalize();
    result.push_back(q.get_str());
  }
  return result;
}

template <class T>
std::vector<T> numbers(const std::vector<std::string>& from) {
  std::vector<T> result;
  for (const std::string& text : from) result.push_back(number<T>(text));
  return result;
}

/// A piece of work for every kind of number; `fold` gives a text of its result, by which the libraries are
/// held against one another.
template <class T>
struct Work {
  std::vector<T> a, b;
  mutable T result = number<T>("0");
  mutable std::vector<T> copies;

  void sums() const {
    for (std::size_t i = 0; i < a.size(); ++i) sum_into(result, a[i], b[i]), shortfall::bench::keep(result);
  }
  void products() const {
    for (std::size_t i = 0; i < a.size(); ++i)
      product_into(result, a[i], b[i]), shortfall::bench::keep(result);
  }
  void quotients() const {
    for (std::size_t i = 0; i < a.size(); ++i)
      quotient_into(result, a[i], b[i]), shortfall::bench::keep(result);
  }
  void comparisons() const {
    long count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += less(a[i], b[i]);
    shortfall::bench::keep(count);
    result = number<T>(std::to_string(count));
  }
  void copying() const {
    copies = std::vector<T>(a);
    shortfall::bench::keep(copies);
  }
  /// 1 + 1/2 + ... + 1/256, adding in place.
  void harmonic() const {
    T sum = number<T>("0");
    for (const T& term : b) add_to(sum, term);
    result = sum;
  }
  /// Horner's rule in place at the first of b, with 24 coefficients.
  void horner() const {
    T sum = number<T>("0");
    for (std::size_t i = 0; i < 24; ++i) {
      multiply_to(sum, b[0]);
      add_to(sum, a[i]);
    }
    result = sum;
  }
};

std::string text(const Rational& r) { return r.str(); }
std::string text(const BoostRational& r) { return r.str(); }
std::string text(const Gmp& r) { return r.str(); }
std::string text(const Flint& r) { return r.str(); }

int differences = 0;

/// Ours over theirs, by who they are and whether the numbers are short.
std::map<std::pair<std::string, bool>, std::vector<double>> ratios;
bool short_numbers = true;

/// One row: all four libraries at the same work; `operations` of it are counted.
template <class Do>
void row(const char* name, const std::vector<std::string>& a, const std::vector<std::string>& b,
         int operations, Do work) {
  using shortfall::bench::here;
  const Work<Rational> ours{numbers<Rational>(a), numbers<Rational>(b), {}, {}};
  const Work<Gmp> gmp{numbers<Gmp>(a), numbers<Gmp>(b), {}, {}};
  const Work<BoostRational> boost{numbers<BoostRational>(a), numbers<BoostRational>(b), {}, {}};
  const Work<Flint> flint{numbers<Flint>(a), numbers<Flint>(b), {}, {}};
  const auto least =
      shortfall::bench::least_times({here("", [&] { work(ours); }), here("", [&] { work(gmp); }),
                                     here("", [&] { work(boost); }), here("", [&] { work(flint); })},
                                    15, 0.002);
  const std::string result = text(ours.result);
  const bool agree =
      result == text(gmp.result) && result == text(boost.result) && result == text(flint.result);
  if (!agree) ++differences;
  std::printf("%-34s %8.1f ns %8.2f %8.2f %8.2f%s\n", name, least[0] * 1e9 / operations, least[0] / least[1],
              least[0] / least[2], least[0] / least[3], agree ? "" : "  DIFFERENT RESULTS");
  std::fflush(stdout);
  const char* const names[] = {"GMP mpq_t", "Boost mpq_rational", "FLINT fmpq"};
  for (std::size_t i = 0; i < 3; ++i) ratios[{names[i], short_numbers}].push_back(least[0] / least[i + 1]);
}

void rows(const std::string& kind, int bits, bool integers) {
  const auto a = texts(bits, integers, 1), b = texts(bits, integers, 2);
  const int n = static_cast<int>(a.size());
  short_numbers = bits < 62;
  row((kind + ", sum").c_str(), a, b, n, [](const auto& w) { w.sums(); });
  row((kind + ", product").c_str(), a, b, n, [](const auto& w) { w.products(); });
  row((kind + ", quotient").c_str(), a, b, n, [](const auto& w) { w.quotients(); });
  row((kind + ", a < b").c_str(), a, b, n, [](const auto& w) { w.comparisons(); });
  row((kind + ", copy").c_str(), a, b, n, [](const auto& w) { w.copying(); });
}

}  // namespace

int main() {
  std::printf(
      "One operation of Rational, least of 15 interleaved rounds, and its time divided by that of the "
      "others\n"
      "(below 1: Rational is faster)\n"
      "%-34s %11s %8s %8s %8s\n",
      "", "Rational", "/mpq_t", "/Boost", "/fmpq");
  rows("integers of 10 bits", 10, true);
  rows("p/q, 5 bits each", 5, false);
  rows("p/q, 10 bits each", 10, false);
  rows("p/q, 31 bits each", 31, false);
  rows("p/q, 62 bits each", 62, false);
  rows("p/q, 256 bits each", 256, false);
  short_numbers = true;
  const auto a = texts(10, false, 3);
  std::vector<std::string> unit_fractions;
  for (int k = 1; k <= 256; ++k) unit_fractions.push_back("1/" + std::to_string(k));
  row("1 + 1/2 + ... + 1/256, a term", a, unit_fractions, 256, [](const auto& w) { w.harmonic(); });
  row("Horner at p/q, 24 terms, a term", a, a, 24, [](const auto& w) { w.horner(); });
  for (const auto& [who, all] : ratios)
    shortfall::bench::note_mean_ratio(
        std::string("one operation of Rational, ") + (who.second ? "up to 31 bits" : "62 and 256 bits"),
        who.first, all);
  if (differences > 0) std::printf("%d rows with different results\n", differences);
  return differences > 0 ? 1 : 0;
}
