// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/rational.hpp"

#include <doctest/doctest.h>

#include <boost/multiprecision/gmp.hpp>
#include <limits>
#include <sstream>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

using Oracle =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

/// The same number by another route: through its digits.
Oracle oracle(const Rational& r) { return Oracle(r.str()); }

bool agree(const Rational& r, const Oracle& o) { return r.str() == o.str(); }

}  // namespace

TEST_CASE("rationals add, subtract, multiply and divide as GMP's do") {
  CHECK(rc::check([](const Rational& a, const Rational& b) {
    RC_ASSERT(agree(a + b, oracle(a) + oracle(b)));
    RC_ASSERT(agree(a - b, oracle(a) - oracle(b)));
    RC_ASSERT(agree(a * b, oracle(a) * oracle(b)));
    if (!b.is_zero()) RC_ASSERT(agree(a / b, oracle(a) / oracle(b)));
    RC_ASSERT(agree(-a, -oracle(a)));
  }));
}

TEST_CASE("times a ratio of short numbers is times that rational") {
  CHECK(rc::check([](const Rational& r) {
    const auto short_number = rc::gen::oneOf(random::whole(1U, 60U), random::whole(1U, 4294967295U));
    const unsigned above = *short_number, below = *short_number;
    RC_ASSERT(r.times(above, below) == r * Rational(above, below));
    RC_ASSERT(r.times(above, below).times(below, above) == r);
  }));
  CHECK(Rational(kLeast).times(4, 6) == Rational(kLeast) * Rational(2, 3));
  CHECK(Rational(kLeast).times(1, 2) == Rational(kLeast / 2));
  CHECK(Rational(kMost).times(4294967295U, 1) == Rational(kMost) * 4294967295U);
  CHECK(Rational(1, kMost).times(7, 7) == Rational(1, kMost));
  CHECK(Rational().times(3, 5).is_zero());
}

TEST_CASE("rationals compare as GMP's do") {
  CHECK(rc::check([](const Rational& a, const Rational& b) {
    RC_ASSERT((a < b) == (oracle(a) < oracle(b)));
    RC_ASSERT((a == b) == (oracle(a) == oracle(b)));
    RC_ASSERT((a > b) == (oracle(a) > oracle(b)));
    RC_ASSERT(a.sign() == oracle(a).sign());
  }));
}

TEST_CASE("rationals obey the laws of a field") {
  CHECK(rc::check([](const Rational& a, const Rational& b, const Rational& c) {
    RC_ASSERT(a + b == b + a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    if (!a.is_zero()) RC_ASSERT((a / a).is_one());
    if (!a.is_zero()) RC_ASSERT(b / a * a == b);
  }));
}

TEST_CASE("equal rationals are represented equally, whichever way they were made") {
  CHECK(rc::check([](const Rational& a, const Rational& b) {
    const Rational back = (a + b) - b;
    RC_ASSERT(back == a);
    RC_ASSERT(back.hash() == a.hash());
    std::int64_t p = 0, q = 0, p_back = 0, q_back = 0;
    RC_ASSERT(a.fits_int64(p, q) == back.fits_int64(p_back, q_back));
    RC_ASSERT(p == p_back);
    RC_ASSERT(q == q_back);
  }));
}

TEST_CASE("a rational that fits into two words lives there, after any detour") {
  const Rational huge = Rational(10).pow(40);
  for (const Rational& r :
       {Rational(kMost), Rational(kLeast), Rational(1, kMost), Rational(kLeast, kMost), Rational(0)}) {
    std::int64_t p, q;
    CHECK((r + huge - huge).fits_int64(p, q));
    CHECK((r * huge / huge).fits_int64(p, q));
    CHECK(r * huge / huge == r);
  }
  std::int64_t p, q;
  CHECK_FALSE((Rational(kMost) + 1).fits_int64(p, q));
  CHECK_FALSE((-Rational(kLeast)).fits_int64(p, q));
  CHECK_FALSE((1 / Rational(kLeast)).fits_int64(p, q));
}

TEST_CASE("arithmetic passes the ends of 64 bits without a seam") {
  CHECK((Rational(kMost) + 1).str() == "9223372036854775808");
  CHECK((Rational(kLeast) - 1).str() == "-9223372036854775809");
  CHECK((-Rational(kLeast)).str() == "9223372036854775808");
  CHECK((Rational(kLeast) * kLeast).str() == "85070591730234615865843651857942052864");
  CHECK((Rational(kLeast) / -1).str() == "9223372036854775808");
  CHECK(Rational(1, kLeast).str() == "-1/9223372036854775808");
  CHECK(Rational(kLeast, kLeast).is_one());
  CHECK(Rational(std::numeric_limits<std::uint64_t>::max()).str() == "18446744073709551615");
  CHECK((Rational(kMost, kMost - 1) + Rational(kMost - 1, kMost)).str() ==
        "170141183460469231676347071494755450885/85070591730234615838173535747377725442");
}

TEST_CASE("a rational may be added to, taken from, multiplied and divided by itself") {
  CHECK(rc::check([](const Rational& a) {
    Rational sum = a, difference = a, product = a, quotient = a;
    sum += *&sum;
    difference -= *&difference;
    product *= *&product;
    RC_ASSERT(sum == a * 2);
    RC_ASSERT(difference.is_zero());
    RC_ASSERT(product == a.pow(2));
    if (a.is_zero()) return;
    quotient /= *&quotient;
    RC_ASSERT(quotient.is_one());
  }));
}

TEST_CASE("copies are independent and a moved-from rational can be used again") {
  const Rational big = Rational(7).pow(100);
  Rational a = big;
  Rational b = a;
  b += 1;
  CHECK(a == big);
  Rational c = std::move(a);
  CHECK(c == big);
  a = 5;
  CHECK(a == 5);
  a = c;
  CHECK(a == big);
  Rational& itself = a;
  a = itself;
  CHECK(a == big);
}

TEST_CASE("floor is the largest integer that is not larger") {
  CHECK(Rational(7, 2).floor() == 3);
  CHECK(Rational(-7, 2).floor() == -4);
  CHECK(Rational(-4).floor() == -4);
  CHECK(rc::check([](const Rational& a) {
    const Rational f = a.floor();
    RC_ASSERT(f.is_integer());
    RC_ASSERT(f <= a);
    RC_ASSERT(a < f + 1);
  }));
}

TEST_CASE("powers are repeated products") {
  CHECK(rc::check([](const Rational& a) {
    const int n = *random::whole(0, 8);
    Rational product = 1;
    for (int i = 0; i < n; ++i) product *= a;
    RC_ASSERT(a.pow(n) == product);
    if (!a.is_zero()) RC_ASSERT(a.pow(-n) * product == 1);
  }));
  CHECK(Rational(0).pow(0) == 1);
  CHECK(Rational(-2).pow(-3) == Rational(-1, 8));
  CHECK(Rational(1).pow(std::numeric_limits<int>::min()) == 1);
  CHECK(Rational(-1).pow(std::numeric_limits<int>::min()) == 1);
}

TEST_CASE("what has no answer is undefined, and what is too long is refused") {
  CHECK_THROWS_AS(Rational(1, 0), Undefined);
  CHECK_THROWS_AS(Rational(1) / 0, Undefined);
  CHECK_THROWS_AS(Rational(7).pow(100) / 0, Undefined);
  CHECK_THROWS_AS(Rational(0).pow(-1), Undefined);
  CHECK_THROWS_AS(Rational(2).pow(std::numeric_limits<int>::max()), Unable);
  CHECK_THROWS_AS(Rational(1, 2).pow(std::numeric_limits<int>::min()), Unable);
  CHECK_THROWS_AS(factorial(-1), Undefined);
}

TEST_CASE("numerator and denominator are coprime, the denominator positive") {
  CHECK(rc::check([](const Rational& a) {
    RC_ASSERT(a.denominator() > 0);
    RC_ASSERT(a.numerator() / a.denominator() == a);
    const boost::multiprecision::mpz_int p(a.numerator().str()), q(a.denominator().str());
    RC_ASSERT(boost::multiprecision::gcd(p, q) == 1);
  }));
}

TEST_CASE("integers say so, and whether they fit") {
  std::int64_t value = 7;
  CHECK(Rational(kLeast).fits_int64(value));
  CHECK(value == kLeast);
  CHECK_FALSE(Rational(1, 2).fits_int64(value));
  CHECK_FALSE((Rational(kMost) + 1).fits_int64(value));
  CHECK((Rational(kMost) + 1).is_integer());
  CHECK_FALSE((Rational(kMost) + Rational(3, 2)).is_integer());
  CHECK_FALSE(Rational(1, 2).is_one());
}

TEST_CASE("a rational prints as its fraction") {
  std::ostringstream out;
  out << Rational(6, -4) << ' ' << Rational(4, 2);
  CHECK(out.str() == "-3/2 2");
}

TEST_CASE("binomials are Pascal's triangle and zero outside") {
  for (int n = 1; n <= 80; ++n)
    for (int k = 0; k <= n; ++k) CHECK(binomial(n, k) == binomial(n - 1, k - 1) + binomial(n - 1, k));
  CHECK(binomial(0, 0) == 1);
  CHECK(binomial(5, 6) == 0);
  CHECK(binomial(5, -1) == 0);
  CHECK(binomial(-1, 0) == 0);
}

TEST_CASE("a factorial is the product of the numbers up to it") {
  Rational product = 1;
  for (int n = 1; n <= 40; ++n) CHECK(factorial(n) == (product *= n));
  CHECK(factorial(0) == 1);
}
