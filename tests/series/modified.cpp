// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/modified.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/series/modifying.hpp"
#include "tests/series/plane_field.hpp"

using namespace shortfall;
using testing::PlaneField;

namespace {

Rational checksum(const ModifiedEquation& m) { return m.checksum.constant(); }

/// "-1/2 f'f; 1/3 f'f'f; ..." of one power of h.
std::string terms(const ModifiedEquation& m, int power, const std::string& component) {
  std::string text;
  for (const FieldTerm& t : m.terms)
    if (t.power == power && t.component == component)
      text += (text.empty() ? "" : "; ") + t.coefficient.constant().str() + " " + t.differential;
  return text;
}

struct RandomRational {
  std::mt19937 generator;
  Rational operator()() {
    return {std::uniform_int_distribution<int>(-4, 4)(generator),
            std::uniform_int_distribution<int>(1, 3)(generator)};
  }
};

ButcherTableau<Rational> random_explicit(RandomRational& random, std::size_t stages) {
  ButcherTableau<Rational> t;
  Rational last = 1;
  for (std::size_t i = 0; i < stages; ++i) {
    t.a.emplace_back(stages);
    t.c.emplace_back();
    for (std::size_t j = 0; j < i; ++j) t.c[i] += t.a[i][j] = random();
    if (i + 1 < stages) last -= t.b.emplace_back(random());
  }
  t.b.push_back(last);  // consistent
  return t;
}

PlaneField::Vector random_field(RandomRational& random) {
  const Polynomial x = Polynomial::letter(0), y = Polynomial::letter(1);
  PlaneField::Vector f;
  for (Polynomial& p : f)
    p = Polynomial(random()) + Polynomial(random()) * x + Polynomial(random()) * y +
        Polynomial(random()) * x * y + Polynomial(random()) * y * y + Polynomial(random()) * x * x * x;
  return f;
}

constexpr int kOrder = 4;

/// The step itself, in polynomials of y and h: what the field is, h left out.
PlaneField::Vector step(const ButcherTableau<Rational>& t, const PlaneField::Vector& f) {
  const PlaneField field(f, kOrder);
  const Polynomial h = Polynomial::letter(PlaneField::kStep);
  std::vector<PlaneField::Vector> slopes;
  PlaneField::Vector result{Polynomial::letter(0), Polynomial::letter(1)};
  for (std::size_t i = 0; i < t.stages(); ++i) {
    PlaneField::Vector place{Polynomial::letter(0), Polynomial::letter(1)};
    for (std::size_t j = 0; j < i; ++j)
      for (int k : {0, 1}) place[k] += Polynomial(t.a[i][j]) * h * slopes[j][k];
    slopes.push_back(field.at(place));
    for (int k : {0, 1}) result[k] += Polynomial(t.b[i]) * h * slopes[i][k];
  }
  return {field.truncated(result[0]), field.truncated(result[1])};
}

/// The flow of h f over the time 1, by iterated derivatives along f.
PlaneField::Vector flow(const PlaneField::Vector& hf) {
  const PlaneField truncation({}, kOrder);
  PlaneField::Vector result{Polynomial::letter(0), Polynomial::letter(1)}, term = result;
  for (int k = 1; k <= kOrder; ++k)
    for (int i : {0, 1}) {
      term[i] = truncation.truncated(Polynomial(Rational(1, k)) * PlaneField::along(term[i], hf));
      result[i] += term[i];
    }
  return result;
}

}  // namespace

TEST_CASE("explicit midpoint to order 9: the published checksums") {
  const SeriesSource source(find_integrator("midpoint"), {});
  CHECK(checksum(modified_equation(source, nullptr, 9)) == Rational(19063, 26880));
  CHECK(checksum(modifying_equation(source, nullptr, 9)) == Rational(5460293, 241920));
  CHECK(modified_equation(source, nullptr, 9).trees == 486);
}

TEST_CASE("explicit Euler: checksums of both equations, and the series of the textbooks") {
  const SeriesSource source(find_integrator("explicit-euler"), {});
  // Written for x'' = a; as a tableau of one stage it is the same method for y' = f(y).
  ButcherTableau<Rational> euler{{{0}}, {1}, {0}, {}};
  const std::vector<Rational> modified{1, {1, 2}, 1, {1, 2}, {31, 30}},
      modifying{1, {3, 2}, 2, {5, 2}, {61, 20}};
  for (int n = 1; n <= 9; ++n) {
    const TreeTable table(Signature::first_order(), n);
    Rational sum, other;
    for (const Rational& b : logarithm(table, ElementaryWeights<Rational>(euler, table).result(euler.b)))
      sum += b;
    for (const Rational& b : modifying_field(euler, table)) other += b;
    if (n <= 5) {
      CHECK(sum == modified[static_cast<std::size_t>(n - 1)]);
      CHECK(other == modifying[static_cast<std::size_t>(n - 1)]);
    }
    if (n == 9) {
      CHECK(sum == Rational(143, 140));
      CHECK(other == Rational(359069, 60480));
    }
  }
  const ModifiedEquation m = modified_equation(source, &force_class("position_only"), 3);
  CHECK(terms(m, 1, "x") == "-1/2 a");
  CHECK(terms(m, 1, "v") == "-1/2 a_x v");
  CHECK(terms(m, 2, "v") == "1/3 a_x a; 1/12 a_xx(v, v)");
}

TEST_CASE("implicit midpoint: f + h^2 (1/12 f'f'f - 1/24 f''(f,f)), Hairer, Lubich & Wanner IX.1") {
  const ModifiedEquation m =
      modified_equation(SeriesSource(find_integrator("implicit-midpoint"), {}), nullptr, 4);
  CHECK(terms(m, 0, "y") == "1 f");
  CHECK(terms(m, 1, "y") == "");
  CHECK(terms(m, 2, "y") == "1/12 f'f'f; -1/24 f''(f, f)");
  CHECK(terms(m, 3, "y") == "");
}

TEST_CASE("the flow of the modified equation is the step, on random polynomial fields of the plane") {
  RandomRational random{std::mt19937(7)};
  const TreeTable table(Signature::first_order(), kOrder);
  for (int repeat = 0; repeat < 12; ++repeat) {
    const ButcherTableau<Rational> tableau =
        random_explicit(random, 1 + static_cast<std::size_t>(repeat) % 4);
    const PlaneField::Vector f = random_field(random);
    PlaneField field(f, kOrder);
    const TreeSeries<Rational> modified =
        logarithm(table, ElementaryWeights<Rational>(tableau, table).result(tableau.b));
    CHECK(flow(field.sum(table, modified)) == step(tableau, f));
    // And one wrong coefficient is seen.
    TreeSeries<Rational> wrong = modified;
    wrong[5] += Rational(1, 7);
    CHECK(flow(field.sum(table, wrong)) != step(tableau, f));
  }
}

TEST_CASE(
    "given the modifying equation, the step is the exact flow, on random polynomial fields of the plane") {
  RandomRational random{std::mt19937(8)};
  const TreeTable table(Signature::first_order(), kOrder);
  const Polynomial h = Polynomial::letter(PlaneField::kStep);
  for (int repeat = 0; repeat < 6; ++repeat) {
    const ButcherTableau<Rational> tableau =
        random_explicit(random, 1 + static_cast<std::size_t>(repeat) % 3);
    const PlaneField::Vector f = random_field(random);
    PlaneField field(f, kOrder);
    // The field carries one h too many for a step that multiplies by h itself.
    PlaneField::Vector given = field.sum(table, modifying_field(tableau, table));
    for (Polynomial& p : given) {
      Polynomial less;
      for (int k = 1; k <= kOrder; ++k) less += p.coefficient(PlaneField::kStep, k) * h.pow(k - 1);
      p = less;
    }
    CHECK(step(tableau, given) == flow({h * f[0], h * f[1]}));
  }
}

TEST_CASE("a step that is no tableau: no force makes velocity Verlet exact, and the reason is named") {
  const ModifiedEquation m =
      modifying_equation(SeriesSource(find_integrator("velocity-verlet"), {}), &force_class("a(x)"), 5);
  CHECK(m.terms.empty());
  CHECK(m.obstruction.find("x in h^3 a_x v is -0.166667") != std::string::npos);
  // Implicit midpoint, a tableau, has one of Nystroem type as well where x and v agree? Its x does not.
  CHECK(!modifying_equation(SeriesSource(find_integrator("symplectic-euler"), {}), &force_class("a(x)"), 3)
             .obstruction.empty());
}

TEST_CASE("the step with the force a itself, given as a series, is the step") {
  for (const Signature& signature : {Signature::mechanical(true, true), Signature::mechanical(false, true)}) {
    const TreeTable table(signature, 4);
    const TreeSeries<Rational> a = the_equation<Rational>(table);
    for (const char* name :
         {"generalised-alpha", "velocity-verlet", "newmark", "rk4", "leapfrog", "sdirk4"}) {
      CAPTURE(name);
      const SeriesSource source(find_integrator(name), {});
      const auto plain = source.step<Rational>(table), given = source.step<Rational>(table, &a);
      CHECK(plain.map == given.map);
      CHECK(plain.start == given.start);
    }
  }
}
