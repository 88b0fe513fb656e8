// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/real.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "analysis/algebra/error.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

TEST_CASE("a rational becomes the nearest Real of its precision") {
  CHECK(rc::check([](const Rational& a) {
    const int digits = *random::whole(1, 120);
    const Real r = real(a, digits);
    RC_ASSERT(static_cast<int>(r.precision()) == digits);
    if (a.is_zero()) {
      RC_ASSERT(r == 0);
      return;
    }
    Real up = r, down = r;
    mpfr_nextabove(up.backend().data());
    mpfr_nextbelow(down.backend().data());
    const auto distance = [&](const Real& x) {
      mpq_t exact;
      mpq_init(exact);
      mpfr_get_q(exact, x.backend().data());
      char* text = mpq_get_str(nullptr, 10, exact);
      Rational gap = (a - Rational::parse(text)).abs();
      void (*release)(void*, std::size_t);
      mp_get_memory_functions(nullptr, nullptr, &release);
      release(text, std::char_traits<char>::length(text) + 1);
      mpq_clear(exact);
      return gap;
    };
    RC_ASSERT(distance(r) <= distance(up));
    RC_ASSERT(distance(r) <= distance(down));
  }));
}

TEST_CASE("a surd becomes the Real that MPFR's own square root gives") {
  for (int digits : {3, 17, 50, 300}) {
    const Precision guard(digits);
    for (int d = 0; d < 50; ++d) CHECK(real(Surd::sqrt(d), digits) == sqrt(real(Rational(d), digits)));
  }
}

TEST_CASE("a result has the larger precision of its operands") {
  const Real a = real(Rational(1, 3), 100), b = real(Rational(1, 7), 200);
  CHECK((a + b).precision() == 200);
  CHECK((a * 2).precision() == 100);
  CHECK(sqrt(b).precision() == 200);
}

TEST_CASE("a result of few digits has its operands' precision or that of the guard") {
  const Precision guard(50);
  const Real a = real(Rational(1, 3), 20), b = real(Rational(1, 7), 30);
  CHECK(a.precision() == 20);
  for (const Real& result : {Real(a + b), Real(sqrt(b)), Real(b * 2)}) {
    const bool told = result.precision() == 30 || result.precision() == 50;
    CHECK(told);
  }
  const Precision own(30);
  CHECK((a + b).precision() == 30);
  CHECK(sqrt(b).precision() == 30);
}

TEST_CASE("a precision lasts as long as its guard, exceptions included") {
  const int before = Precision::current();
  {
    const Precision outer(77);
    CHECK(Precision::current() == 77);
    CHECK(Real(2).precision() == 77);
    try {
      const Precision inner(200);
      CHECK(Precision::current() == 200);
      throw std::runtime_error("leave");
    } catch (const std::runtime_error&) {
    }
    CHECK(Precision::current() == 77);
  }
  CHECK(Precision::current() == before);
}

TEST_CASE("converting leaves the default precision alone") {
  const int before = Precision::current();
  CHECK(real(Rational(1, 3), 500).precision() == 500);
  CHECK(real(Surd::sqrt(2), 500).precision() == 500);
  CHECK(Precision::current() == before);
  CHECK_THROWS_AS(real(Rational(1, 3), 0), Error);
  CHECK_THROWS_AS(Precision(0), Error);
  CHECK(Precision::current() == before);
}
