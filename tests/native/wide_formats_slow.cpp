// SPDX-License-Identifier: GPL-3.0-or-later
#include <quadmath.h>

#include "analysis/algebra/real.hpp"
#include "analysis/floating/double_double.hpp"
#include "analysis/floating/float_access.hpp"
#include "analysis/floating/quad.hpp"
#include "tests/native/same_bits.hpp"

namespace shortfall::native {
namespace {

TEST_CASE("native runs have the bits of the interpreter's in binary128") {
  const BinaryFormat storage = float_format("f128").storage();
  const std::function<Quad::Native(Quad::Native, long)> scaled = [](Quad::Native value, long e) {
    return ldexpq(value, static_cast<int>(e));
  };
  const Round<Quad> round = [&](const Rational& value) {
    const Quad::Native infinity = static_cast<Quad::Native>(std::numeric_limits<double>::infinity());
    return Quad(stored_as<Quad::Native>(value, storage, Rounding::nearest_even, infinity, scaled));
  };
  CHECK(check_catalogue<Quad>(round, 6, 60) > 600);
}

TEST_CASE("native runs have the bits of the interpreter's in double-double") {
  const Round<DoubleDouble> round = [](const Rational& value) {
    const double high = value.to_double();
    return DoubleDouble(high, (value - Rational::from_double(high)).to_double());
  };
  CHECK(check_catalogue<DoubleDouble>(round, 7, 60) > 600);
}

TEST_CASE("native runs have the bits of the interpreter's in MPFR with 50 digits") {
  const Precision precision(50);
  const Round<Real> round = [](const Rational& value) { return real(value, 50); };
  CHECK(check_catalogue<Real>(round, 8, 30) > 600);
}

}  // namespace
}  // namespace shortfall::native
