// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/modular.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "analysis/algebra/error.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

const Rational kPrime = Rational(2).pow(61) - 1;

/// r modulo the prime by exact arithmetic, for an integer r.
Rational residue(const Rational& r) { return r - (r / kPrime).floor() * kPrime; }

}  // namespace

TEST_CASE("a fingerprint of an integer is its remainder") {
  CHECK(rc::check([](const Rational& a) {
    RC_ASSERT(Rational(Modular(a.numerator()).value()) == residue(a.numerator()));
  }));
  CHECK(Modular(std::numeric_limits<std::int64_t>::min()) ==
        Modular(Rational(std::numeric_limits<std::int64_t>::min())));
  CHECK(Modular(std::numeric_limits<std::uint64_t>::max()) ==
        Modular(Rational(std::numeric_limits<std::uint64_t>::max())));
  CHECK(Modular(-1).value() == Modular::kPrime - 1);
  CHECK(Modular(-static_cast<std::int64_t>(Modular::kPrime)).is_zero());
}

TEST_CASE("fingerprints compute as rationals do") {
  const auto has_none = [](const Rational& r) { return residue(r.denominator()).is_zero(); };
  CHECK(rc::check([&](const Rational& a, const Rational& b) {
    RC_PRE(!has_none(a) && !has_none(b));
    RC_ASSERT(Modular(a + b) == Modular(a) + Modular(b));
    RC_ASSERT(Modular(a - b) == Modular(a) - Modular(b));
    RC_ASSERT(Modular(a * b) == Modular(a) * Modular(b));
    RC_ASSERT(Modular(-a) == -Modular(a));
    if (!Modular(b).is_zero()) RC_ASSERT(Modular(a / b) == Modular(a) / Modular(b));
    if (!Modular(a).is_zero()) RC_ASSERT(Modular(a.pow(-3)) == Modular(a).pow(-3));
  }));
}

TEST_CASE("the largest remainders multiply and add without overflow") {
  const Modular last(Modular::kPrime - 1);
  CHECK(last == -1);
  CHECK(last * last == 1);
  CHECK(last + last == -2);
  CHECK((last + 1).is_zero());
  CHECK(Modular(std::uint64_t{1} << 31) * Modular(std::uint64_t{1} << 30) == 1);
}

TEST_CASE("a denominator that the prime divides has no fingerprint") {
  CHECK_THROWS_AS(Modular(1 / kPrime), Undefined);
  CHECK_THROWS_AS(Modular(1 / (kPrime * Rational(10).pow(30))), Undefined);
  CHECK_THROWS_AS(Modular(1) / 0, Undefined);
  CHECK_THROWS_AS(Modular(0).pow(-1), Undefined);
  CHECK(Modular(0).pow(0) == 1);
}
