// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_force_correction.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/linear_solve.hpp"
#include "tests/algebra/polynomial_field.hpp"
#include "tests/series/known_splittings.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;
using testing::kDriftKickDrift, testing::kKickDrift, testing::kKickDriftKick;
using Element = LieElement<Rational>;
using Parts = SplittingParts<Rational>;

TEST_CASE("a~ = a + h^2/12 a_x[a] gives both Verlets and symplectic Euler the effective order 4") {
  for (const Parts& parts : {kKickDrift, kKickDriftKick, kDriftKickDrift}) {
    const auto result = splitting_force_correction(parts, 6);
    CHECK(text(result.kick) == "B - 1/24*[[A,B],B]");
    CHECK(result.processing.effective_order == 4);
  }
}

TEST_CASE("[[A,B],B] is the kick -2 a_x[a], also for a force with curl") {
  const Polynomial x = Polynomial::letter(0), y = Polynomial::letter(1);
  const test::Field drift{Polynomial::letter(2), Polynomial::letter(3), Polynomial(), Polynomial()};
  const Polynomial ax = x * y - y * y * y, ay = Polynomial(2) * x + x * x * y;
  test::Brackets brackets(drift, {Polynomial(), Polynomial(), ax, ay}, 3);
  const auto along = [&](const Polynomial& f) { return ax * f.derivative(0) + ay * f.derivative(1); };
  CHECK(brackets(3, 1) ==
        test::Field{Polynomial(), Polynomial(), Polynomial(-2) * along(ax), Polynomial(-2) * along(ay)});
}

TEST_CASE("with it kick-drift-kick is launched by x -= h^2/12 a, v += h^2/12 a_x[v]") {
  const auto result = splitting_force_correction(kKickDriftKick, 5);
  REQUIRE(result.processing.corrections.size() == 3);
  CHECK(result.processing.corrections[0].is_zero());
  CHECK(text(result.processing.corrections[1]) == "1/12*[A,B]");
  CHECK(result.processing.corrections[2].is_zero());
  // [A,B] is the field x' = -a, v' = a_x[v].
  const Polynomial x = Polynomial::letter(0), v = Polynomial::letter(1), a = Polynomial(1) - x * x * x;
  test::Brackets brackets({v, Polynomial()}, {Polynomial(), a}, 2);
  CHECK(brackets(2, 0) == test::Field{-a, a.derivative(0) * v});
}

TEST_CASE("drift-kick-drift is launched by x += h^2/24 a, v -= h^2/24 a_x[v]") {
  const auto result = splitting_force_correction(kDriftKickDrift, 5);
  CHECK(text(corrector_logarithm(result.processing)).starts_with("-1/24*[A,B]"));
}

TEST_CASE("order 6 by a position-only force is impossible: two conditions in degree 5, one kick") {
  for (const Parts& parts : {kKickDrift, kKickDriftKick, kDriftKickDrift}) {
    const auto result = splitting_force_correction(parts, 7);
    REQUIRE(result.limit);
    CHECK(result.limit->degree == 5);
    CHECK(result.limit->conditions == 2);
    CHECK(result.limit->unknowns == 1);
    CHECK(result.limit->conclusive);
    CHECK(result.limit->residual == Rational(-1, 1440));
    // The certificate: multipliers that no kick of degree 5 is seen by.
    const auto kicks = position_only_kicks(5);
    REQUIRE(kicks.size() == 1);
    Rational seen;
    for (std::size_t r = 0; r < 2; ++r)
      seen += result.limit->certificate[r] *
              result.processing.obstruction->functionals[r][static_cast<std::size_t>(kicks[0])];
    CHECK(seen.is_zero());
  }
}

TEST_CASE("no other kick than -1/24 [[A,B],B] takes Verlet to effective order 4") {
  CHECK(rc::check([] {
    const Rational kappa = *random::small_rational();
    const Element kick = Element::b(5) + kappa * Element::basis_element(5, 3, 1);
    const auto result =
        splitting_processing(splitting_logarithm(kKickDriftKick, kick), VectorFields::mechanical);
    RC_ASSERT(result.effective_order == (kappa == Rational(-1, 24) ? 4 : 2));
    if (kappa != Rational(-1, 24))
      RC_ASSERT(result.obstruction->values == std::vector<Rational>{Rational(1, 24) + kappa});
  }));
}

TEST_CASE(
    "there are 1, 1, 1, 2, 3 and 6 kinds of position-only kicks in the odd degrees, none in even ones") {
  const std::vector<std::size_t> known{1, 0, 1, 0, 1, 0, 2, 0, 3, 0, 6, 0};  // Wedderburn and Etherington
  for (int d = 1; d <= 12; ++d)
    CHECK(position_only_kicks(d).size() == known[static_cast<std::size_t>(d) - 1]);
}

TEST_CASE("with the kick B the step is the splitting itself") {
  CHECK(rc::check([] {
    const Parts parts = *random::splitting(5);
    RC_ASSERT(splitting_logarithm(parts, Element::b(6)) == splitting_logarithm(parts, 6));
  }));
}

TEST_CASE("launch, a step with a~ and read-out agree with the motion to h^4, on a cubic force") {
  const Polynomial x = Polynomial::letter(0), v = Polynomial::letter(1);
  const Polynomial a = Polynomial(2) - x + x * x - Polynomial(3) * x * x * x;
  const Polynomial h = Polynomial::letter(test::kStepLetter);
  const Rational twelfth(1, 12);
  constexpr int kHighest = 5;
  // The launch by its formula, h^2 being of no concern to the map's own inverse up to h^4.
  const auto shift = [&](int sign) {
    return std::vector<Polynomial>{x - h * h * a * Polynomial(twelfth * sign),
                                   v + h * h * a.derivative(0) * v * Polynomial(twelfth * sign)};
  };
  const auto inserted = [&](const Polynomial& p, const std::vector<Polynomial>& state) {
    Polynomial sum;
    for (int k = 0; k <= kHighest; ++k)
      sum += test::truncated(h.pow(k) * test::composed(p.coefficient(test::kStepLetter, k), state, kHighest),
                             kHighest);
    return sum;
  };
  const std::vector<Polynomial> launch = shift(1);
  std::vector<Polynomial> state = launch;
  const auto kick = [&] {
    const Polynomial better = a + h * h * Polynomial(twelfth) * a * a.derivative(0);
    state[1] += test::truncated(h * Polynomial(Rational(1, 2)) * inserted(better, state), kHighest);
  };
  kick();
  state[0] += h * state[1];
  kick();
  for (Polynomial& p : state) p = test::truncated(p, kHighest);
  // The motion, launched alike: launch(flow(x, v)) has to agree with step(launch(x, v)).
  test::Brackets brackets({v, Polynomial()}, {Polynomial(), a}, kHighest);
  const Element field = Element::a(kHighest) + Element::b(kHighest);
  std::vector<test::Field> fields{{}};
  for (int d = 1; d <= kHighest; ++d) fields.push_back(brackets.value(field, d));
  const std::vector<Polynomial> exact = test::flow(fields, kHighest);
  for (std::size_t i = 0; i < 2; ++i) {
    const Polynomial difference = inserted(launch[i], exact) - state[i];
    CHECK(test::truncated(difference, 4).is_zero());
    CHECK_FALSE(test::truncated(difference, 5).is_zero());
  }
}
