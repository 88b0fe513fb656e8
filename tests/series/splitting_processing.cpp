// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_processing.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/word_series.hpp"
#include "tests/algebra/polynomial_field.hpp"
#include "tests/series/known_splittings.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;
using testing::kDriftKick, testing::kDriftKickDrift, testing::kKickDrift, testing::kKickDriftKick;
using Element = LieElement<Rational>;
using Parts = SplittingParts<Rational>;

namespace {

SplittingProcessing<Rational> processed(const Parts& parts, int degree,
                                        VectorFields kind = VectorFields::any) {
  return splitting_processing(splitting_logarithm(parts, degree), kind);
}

}  // namespace

TEST_CASE("processing symplectic Euler is velocity Verlet: c_1 = -B/2, effective order 2, for every force") {
  const auto result = processed(kKickDrift, 6);
  CHECK(result.order == 1);
  CHECK(result.effective_order == 2);
  CHECK(text(corrector_logarithm(result)) == "-1/2*B");
  // P Phi P^-1 as kicks and drifts, not only to some order.
  const Parts launched =
      merged(composed(composed(Parts{{true, Rational(-1, 2)}}, kKickDrift), Parts{{true, Rational(1, 2)}}));
  REQUIRE(launched.size() == 3);
  CHECK(result.processed == splitting_logarithm(kKickDriftKick, 6));
}

TEST_CASE("the obstruction of Verlet and both symplectic Eulers is 1/12 - 1/24 = 1/24 in degree 3") {
  for (const Parts& parts : {kKickDrift, kDriftKick, kKickDriftKick, kDriftKickDrift})
    for (const VectorFields kind : {VectorFields::any, VectorFields::mechanical}) {
      const auto result = processed(parts, 6, kind);
      REQUIRE(result.obstruction);
      CHECK(result.effective_order == 2);
      CHECK(result.obstruction->degree == 3);
      CHECK(result.obstruction->functionals == std::vector<std::vector<Rational>>{{1, 1}});
      CHECK(result.obstruction->values == std::vector<Rational>{Rational(1, 24)});
    }
}

TEST_CASE("P is undone by its inverse, and P exp(L) P^-1 is what is said, for random splittings") {
  CHECK(rc::check([] {
    const Parts parts = *random::consistent_splitting(5);
    const auto result = processed(parts, 6);
    const Element p = corrector_logarithm(result);
    WordSeries<Rational> product(6);
    for (std::size_t k = result.corrections.size(); k-- > 0;) product = product * exp(result.corrections[k]);
    WordSeries<Rational> inverse(6);
    for (const Element& c : result.corrections) inverse = inverse * exp(-c);
    RC_ASSERT(product * inverse == WordSeries<Rational>(6));
    RC_ASSERT(exp(p) == product);
    RC_ASSERT(log(product * word_series(parts, 6) * inverse) == result.processed);
  }));
}

TEST_CASE("the processed step is exp(A + B) up to the effective order, and no further") {
  CHECK(rc::check([] {
    const Parts parts = *random::consistent_splitting(5);
    const auto result = processed(parts, 5);
    RC_ASSERT(result.effective_order >= result.order);
    RC_ASSERT(splitting_order(result.processed, VectorFields::any) == result.effective_order);
    if (!result.corrections.empty()) RC_ASSERT(result.corrections[0].at(1, 0).is_zero());
  }));
}

TEST_CASE("conjugating by anything changes neither the effective order nor the obstruction") {
  CHECK(rc::check([] {
    const Parts parts = *random::consistent_splitting(4), other = *random::splitting(3);
    const auto one = processed(parts, 5);
    const auto two = processed(composed(composed(other, parts), inverse(other)), 5);
    RC_ASSERT(one.effective_order == two.effective_order);
    RC_ASSERT(one.obstruction.has_value() == two.obstruction.has_value());
    if (one.obstruction) RC_ASSERT(one.obstruction->values == two.obstruction->values);
  }));
}

TEST_CASE("what was conjugated on purpose is found: a fourth-order step, disguised") {
  // Suzuki's order-4 composition needs irrational weights; three steps of A + B with a rational error do as
  // well: take L = A + B exactly to degree 4 by construction.
  Element exact = Element::a(5) + Element::b(5) + Rational(1, 7) * Element::basis_element(5, 5, 4);
  const Element disguise = Rational(1, 3) * Element::b(5) - Rational(1, 5) * Element::basis_element(5, 2, 0) +
                           Element::basis_element(5, 3, 1);
  const auto result = splitting_processing(exp_ad(disguise, exact), VectorFields::any);
  CHECK(result.order == 1);
  CHECK(result.effective_order == 4);
  CHECK(result.obstruction->degree == 5);
}

TEST_CASE("without consistency there is no order") {
  const auto result = processed({{true, Rational(1, 2)}, {false, 1}}, 4);
  CHECK(result.order == 0);
  CHECK(result.effective_order == 0);
  CHECK(result.corrections.empty());
}

TEST_CASE("Ruth's third-order splitting is of order 3, and for x'' = a(x) processing makes it 4") {
  const Parts ruth{{true, Rational(7, 24)},  {false, Rational(2, 3)},  {true, Rational(3, 4)},
                   {false, Rational(-2, 3)}, {true, Rational(-1, 24)}, {false, 1}};
  CHECK(processed(ruth, 5).order == 3);
  CHECK(processed(ruth, 5).effective_order == 3);
  const auto mechanical = processed(ruth, 5, VectorFields::mechanical);
  CHECK(mechanical.order == 3);
  CHECK(mechanical.effective_order == 4);
  // Independently: launch, one step and read-out on x'' = 2 - x + x^2 + 5 x^3 against the flow, to h^4.
  const Polynomial x = Polynomial::letter(0), v = Polynomial::letter(1);
  const test::Field drift{v, Polynomial()};
  const test::Field kick{Polynomial(), Polynomial(2) - x + x * x + Polynomial(5) * x * x * x};
  test::Brackets brackets(drift, kick, 5);
  const Element corrector = corrector_logarithm(mechanical);
  const auto flow_of = [&](const Element& element) {
    std::vector<test::Field> fields{{}};
    for (int d = 1; d <= 5; ++d) fields.push_back(brackets.value(element, d));
    return test::flow(fields, 5);
  };
  // Maps are composed the other way round than operators are multiplied: the launch is substituted last.
  const std::vector<Polynomial> launch = flow_of(corrector), read_out = flow_of(-corrector);
  std::vector<Polynomial> state = launch;
  for (const auto& [is_kick, weight] : ruth) test::move(state, is_kick ? kick : drift, weight, 5);
  const Polynomial h = Polynomial::letter(test::kStepLetter);
  std::vector<Polynomial> processed_step;
  for (const Polynomial& p : read_out) {
    // The read-out's own powers of h are coefficients here.
    Polynomial sum;
    for (int k = 0; k <= 5; ++k)
      sum += test::truncated(h.pow(k) * test::composed(p.coefficient(test::kStepLetter, k), state, 5), 5);
    processed_step.push_back(sum);
  }
  const std::vector<Polynomial> exact = flow_of(Element::a(5) + Element::b(5));
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(test::truncated(processed_step[i] - exact[i], 4).is_zero());
    CHECK_FALSE((processed_step[i] - exact[i]).is_zero());
  }
}
