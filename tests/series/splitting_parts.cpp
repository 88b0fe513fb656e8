// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_parts.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/lie_quotient.hpp"
#include "tests/algebra/polynomial_field.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;
using Parts = SplittingParts<Rational>;

namespace {

/// The step done on positions and velocities, as a series in h.
std::vector<Polynomial> stepped(const Parts& parts, const test::Field& drift, const test::Field& kick,
                                int highest) {
  std::vector<Polynomial> state;
  for (std::size_t i = 0; i < drift.size(); ++i) state.push_back(Polynomial::letter(static_cast<Letter>(i)));
  for (const auto& [is_kick, weight] : parts) test::move(state, is_kick ? kick : drift, weight, highest);
  return state;
}

std::vector<Polynomial> flow_of(const LieElement<Rational>& logarithm, test::Field drift, test::Field kick) {
  test::Brackets brackets(std::move(drift), std::move(kick), logarithm.degree());
  std::vector<test::Field> fields{{}};
  for (int d = 1; d <= logarithm.degree(); ++d) fields.push_back(brackets.value(logarithm, d));
  return test::flow(fields, logarithm.degree());
}

const Polynomial kX = Polynomial::letter(0), kV = Polynomial::letter(1);

}  // namespace

TEST_CASE("the flow of the logarithm is the map itself: random splittings of T(p) + V(q)") {
  // T is no square, so that nothing vanishes: x' = 2 v - v^2 + v^3, v' = 1 - x + 3 x^2.
  const test::Field drift{Polynomial(2) * kV - kV * kV + kV * kV * kV, Polynomial()};
  const test::Field kick{Polynomial(), Polynomial(1) - kX + Polynomial(3) * kX * kX};
  CHECK(rc::check([&] {
    const Parts parts = *random::splitting(6);
    constexpr int kDegree = 5;
    RC_ASSERT(flow_of(splitting_logarithm(parts, kDegree), drift, kick) ==
              stepped(parts, drift, kick, kDegree));
  }));
}

TEST_CASE("for x'' = a(x) the normal form in the mechanical quotient has the same flow") {
  const test::Field drift{kV, Polynomial()};
  const test::Field kick{Polynomial(), Polynomial(2) - kX + kX * kX + Polynomial(5) * kX * kX * kX};
  CHECK(rc::check([&] {
    const Parts parts = *random::splitting(6);
    constexpr int kDegree = 6;
    const auto logarithm = splitting_logarithm(parts, kDegree);
    RC_ASSERT(flow_of(LieQuotient::of(VectorFields::mechanical, kDegree).normal_form(logarithm), drift,
                      kick) == stepped(parts, drift, kick, kDegree));
  }));
}

TEST_CASE("for a force with curl in the plane, too") {
  const Polynomial x = Polynomial::letter(0), y = Polynomial::letter(1), u = Polynomial::letter(2),
                   v = Polynomial::letter(3);
  const test::Field drift{u, v, Polynomial(), Polynomial()};
  const test::Field kick{Polynomial(), Polynomial(), y - x * x, x * y + Polynomial(2) * x};
  CHECK(rc::check([&] {
    const Parts parts = *random::splitting(5);
    constexpr int kDegree = 5;
    const auto logarithm = splitting_logarithm(parts, kDegree);
    RC_ASSERT(flow_of(LieQuotient::of(VectorFields::mechanical, kDegree).normal_form(logarithm), drift,
                      kick) == stepped(parts, drift, kick, kDegree));
  }));
}

TEST_CASE("a step and its inverse are nothing, to degree 8; merging changes nothing") {
  CHECK(rc::check([] {
    const Parts parts = *random::splitting(7);
    RC_ASSERT(word_series(composed(parts, inverse(parts)), 8) == WordSeries<Rational>(8));
    RC_ASSERT(merged(composed(parts, inverse(parts))).empty());
    RC_ASSERT(word_series(merged(parts), 6) == word_series(parts, 6));
  }));
}

TEST_CASE("the adjoint has the same logarithm up to the signs of even degrees") {
  CHECK(rc::check([] {
    const Parts parts = *random::splitting(5);
    const auto one = splitting_logarithm(parts, 6), other = splitting_logarithm(adjoint(parts), 6);
    for (int d = 1; d <= 6; ++d)
      for (std::size_t i = 0; i < one.part(d).size(); ++i)
        RC_ASSERT(other.part(d)[i] == (d % 2 == 0 ? -one.part(d)[i] : one.part(d)[i]));
  }));
}

TEST_CASE(
    "kick-drift-kick solves A + B + h^2 (1/12 [A,[A,B]] - 1/24 [[A,B],B]), drift-kick-drift the mirror "
    "image") {
  const Parts kdk{{true, Rational(1, 2)}, {false, 1}, {true, Rational(1, 2)}};
  const Parts dkd{{false, Rational(1, 2)}, {true, 1}, {false, Rational(1, 2)}};
  CHECK(text(splitting_logarithm(kdk, 4)) == "A + B + 1/12*[A,[A,B]] - 1/24*[[A,B],B]");
  CHECK(text(splitting_logarithm(dkd, 4)) == "A + B - 1/24*[A,[A,B]] + 1/12*[[A,B],B]");
}

TEST_CASE(
    "symplectic Euler's modified Hamiltonian is H - h/2 p V' + h^2/12 (V'^2 + p^2 V'') - h^3/12 p V' V''") {
  // With V' = a cubic: the vector field of that Hamiltonian is x' = H_p, v' = -H_x, compared by powers of h.
  const Polynomial slope = Polynomial(3) - kX + Polynomial(2) * kX * kX + kX * kX * kX;  // V'
  const Polynomial bend = slope.derivative(0);
  const std::vector<Polynomial> hamiltonian{Polynomial(Rational(-1, 2)) * kV * slope,
                                            Polynomial(Rational(1, 12)) * (slope * slope + kV * kV * bend),
                                            Polynomial(Rational(-1, 12)) * kV * slope * bend};
  const auto logarithm = splitting_logarithm(Parts{{true, 1}, {false, 1}}, 4);
  test::Brackets brackets({kV, Polynomial()}, {Polynomial(), -slope}, 4);
  for (int power = 1; power <= 3; ++power) {
    const Polynomial& h = hamiltonian[static_cast<std::size_t>(power) - 1];
    CHECK(brackets.value(logarithm, power + 1) == test::Field{h.derivative(1), -h.derivative(0)});
  }
}
