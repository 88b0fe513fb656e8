// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_corrector.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/series/splitting_first_order.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;

namespace {

/// Whether a published decimal is the number, to within one unit of its last digit.
bool agrees(const Surd& number, const std::string& decimal) {
  const std::size_t places = decimal.size() - decimal.find('.') - 1;
  const Surd difference = number - Surd(Rational::parse(decimal));
  return difference.abs() <= Surd(Rational(1, 10).pow(static_cast<int>(places)));
}

const SplittingParts<Surd> kPositionVerlet{{false, Rational(1, 2)}, {true, 1}, {false, Rational(1, 2)}};

}  // namespace

TEST_CASE("the correctors 3 and 5 have the weights 1/96 and 5/288, -1/288") {
  CHECK(symplectic_corrector(corrector_stages(3)).weights == std::vector<Rational>{Rational(1, 96)});
  CHECK(symplectic_corrector(corrector_stages(5)).weights ==
        std::vector<Rational>{Rational(5, 288), Rational(-1, 288)});
}

TEST_CASE("all correctors agree with Wisdom's coefficients as WHFast publishes them, to 50 digits") {
  // Rein & Tamayo (2015), WHFast, Monthly Notices of the Royal Astronomical Society 452, the coefficients in
  // the code; b_31 with the opposite sign, for there the two stages of the corrector 3 are done in the other
  // order.
  const std::vector<std::pair<int, std::vector<std::string>>> published{
      {3, {"0.024900596027799867499350357910273437184309981229127"}},
      {5,
       {"0.041500993379666445832250596517122395307183302048545",
        "-0.0083001986759332891664501193034244790614366604097090"}},
      {7,
       {"0.053964399093127498721765893493510877532452806339655",
        "-0.018270923246702131478062356884535264841652263842597",
        "0.0024926811426922105779030593952776964450539008582219"}},
      {11,
       {"0.072593394748842738674253180742744961827622366521517",
        "-0.038121613681288650508647613260247372125243616270670",
        "0.012309078592019946317544564763237909911330686448336",
        "-0.0023487215292295354188307328851055489876255097419754",
        "0.00020361579647854651301632818774633716473696537436847"}},
      {17,
       {"0.093056103771425958591541059067553547100903397724386",
        "-0.065192863576377893658290760803725762027864651086787",
        "0.032422198864713580293681523029577130832258806467604",
        "-0.012071760822342291062449751726959664253913904872527",
        "0.0033132577069380655655490196833451994080066801611459",
        "-0.00063599983075817658983166881625078545864140848560259",
        "0.000076436355227935738363241846979413475106795392377415",
        "-0.0000043347415473373580190650223498124944896789841432241"}}};
  for (const auto& [number, decimals] : published) {
    const SymplecticCorrector corrector = symplectic_corrector(corrector_stages(number));
    REQUIRE(corrector.weights.size() == decimals.size());
    for (std::size_t i = 0; i < decimals.size(); ++i)
      CHECK(agrees(corrector.b(static_cast<int>(i) + 1), decimals[i]));
  }
  const SymplecticCorrector corrector = symplectic_corrector(8);
  CHECK(agrees(corrector.a(1), "0.41833001326703777398908601289259374469640768464934"));
  CHECK(agrees(corrector.a(8), "3.3466401061363021919126881031407499575712614771947"));
  CHECK_FALSE(agrees(corrector.a(8), "3.3466401061363021919126881031407499575712614771927"));
}

TEST_CASE("launched and read out with it, the error linear in the kick begins with h^(2 stages + 2)") {
  for (const int stages : {1, 2, 3, 5, 8}) {
    const SplittingParts<Surd> p = symplectic_corrector(stages).parts();
    const auto processed = composed(composed(p, kPositionVerlet), inverse(p));
    const auto first = first_order_in_kick(processed, 2 * stages + 3);
    CHECK(first.drift == Surd(1));
    CHECK(first.logarithm[0] == Surd(1));
    for (int k = 1; k < 2 * stages + 2; ++k) CHECK(first.logarithm[static_cast<std::size_t>(k)].is_zero());
    CHECK_FALSE(first.logarithm[static_cast<std::size_t>(2 * stages + 2)].is_zero());
  }
}

TEST_CASE("the same in the free Lie algebra: [A,[A,..[A,B]]] vanishes to degree 2 stages + 2") {
  for (const int stages : {1, 2}) {
    const SplittingParts<Surd> p = symplectic_corrector(stages).parts();
    const int degree = 2 * stages + 3;
    const auto z = splitting_logarithm(composed(composed(p, kPositionVerlet), inverse(p)), degree);
    for (int d = 2; d < degree; ++d) CHECK(z.at(d, 0).is_zero());
    CHECK_FALSE(z.at(degree, 0).is_zero());
    CHECK(word_series(composed(p, inverse(p)), degree) == WordSeries<Surd>(degree));
  }
}

TEST_CASE("what is of first order in the kick is the first row of the free Lie algebra") {
  CHECK(rc::check([] {
    const SplittingParts<Rational> parts = *random::splitting(6);
    const auto first = first_order_in_kick(parts, 8);
    const auto z = splitting_logarithm(parts, 8);
    RC_ASSERT(first.drift == z.at(1, 0));
    RC_ASSERT(first.logarithm[0] == z.at(1, 1));
    for (int k = 1; k < 8; ++k) RC_ASSERT(first.logarithm[static_cast<std::size_t>(k)] == z.at(k + 1, 0));
  }));
}

TEST_CASE("another alpha gives another corrector of the same order") {
  const SymplecticCorrector corrector = symplectic_corrector(2, Rational(1, 9));
  const auto p = corrector.parts();
  const auto first = first_order_in_kick(composed(composed(p, kPositionVerlet), inverse(p)), 7);
  for (std::size_t k = 1; k < 6; ++k) CHECK(first.logarithm[k].is_zero());
  CHECK_FALSE(first.logarithm[6].is_zero());
}

TEST_CASE("impossible correctors are refused") {
  CHECK_THROWS_AS(corrector_stages(4), BadInput);
  CHECK_THROWS_AS(corrector_stages(1), BadInput);
  CHECK_THROWS_AS(symplectic_corrector(0), BadInput);
  CHECK_THROWS_AS(symplectic_corrector(2, Rational(-1)), Undefined);
}
