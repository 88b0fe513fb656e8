// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/physical_quantity.hpp"

#include <doctest/doctest.h>

#include <string>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

namespace {

std::string quantity_refusal(const std::string& text) {
  try {
    physical_quantity(text);
  } catch (const BadInput& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("numbers with units are exact, in SI units") {
  const auto is = [](const char* text, const Rational& value, PhysicalDimension d) {
    CAPTURE(text);
    const PhysicalQuantity q = physical_quantity(text);
    CHECK(q.value == value);
    REQUIRE(q.dimension);
    CHECK(*q.dimension == d);
  };
  is("1.7 m", Rational(17, 10), {1, 0, 0});
  is("170cm", Rational(17, 10), {1, 0, 0});
  is("-9.81 m/s^2", Rational(-981, 100), {1, -2, 0});
  is("36 km/h", 10, {1, -1, 0});
  is("1/3 N/kg", Rational(1, 3), {1, -2, 0});
  is("60 Hz", 60, {0, -1, 0});
  is("2e3 g", 2, {0, 0, 1});
  is("5 1/m", 5, {-1, 0, 0});
  is("4 kg m^2/s^2", 4, {2, -2, 1});
  is("4 J", 4, {2, -2, 1});
  is("1 s^-2", 1, {0, -2, 0});
  is("1 %", Rational(1, 100), {});
  is("2 kg/m*s", 2, {-1, 1, 1});
  CHECK(!physical_quantity("12").dimension);
  CHECK(physical_quantity(" 1e-3 ").value == Rational(1, 1000));
  // Half a turn is pi to the digits that are promised.
  CHECK((physical_quantity("180 deg").value -
         Rational::parse("3.14159265358979323846264338327950288419716939937510582097494"))
            .is_zero());
}

TEST_CASE("what is no quantity is refused in a sentence") {
  CHECK(quantity_refusal("fast").find("not a number") != std::string::npos);
  CHECK(quantity_refusal("3 metres").find("unknown unit 'metres'") != std::string::npos);
  CHECK(quantity_refusal("3 m^").find("is no unit") != std::string::npos);
  CHECK(quantity_refusal("3 m^77").find("is no unit") != std::string::npos);
  CHECK(quantity_refusal("3 *m").find("is no unit") != std::string::npos);
  CHECK(quantity_refusal("3 kh").find("did you mean") != std::string::npos);
  CHECK(!quantity_refusal("").empty());
  CHECK_THROWS_AS(physical_quantity("1/0 m"), Error);
}

TEST_CASE("a scene's own units") {
  const UnitSystem u = UnitSystem::of("au", "day", "kg");
  CHECK(u.from_si(Rational(149'597'870'700), {1, 0, 0}) == Rational(1));
  CHECK(u.from_si(Rational(149'597'870'700) / Rational(86400), {1, -1, 0}) == Rational(1));
  CHECK(u.unit({1, -2, 0}) == "au/day^2");
  CHECK(u.unit({}).empty());
  CHECK(UnitSystem().unit({0, -1, 0}) == "1/s");
  CHECK_THROWS_AS(UnitSystem::of("s", "s", "kg"), BadInput);
}
