// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/named_formulas.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/motion/formula_text.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/arithmetic.hpp"
#include "analysis/program/tape.hpp"

using namespace shortfall;

namespace {

Rational value(const Expr& e, const Values& names) {
  return arithmetic<Rational>(e, [&](const Expr& leaf) -> Rational {
    if (leaf->op == Expression::Op::number) return leaf->value;
    if (leaf->op == Expression::Op::name) return names.at(leaf->name);
    std::int64_t exponent = 0;
    REQUIRE(leaf->op == Expression::Op::power);
    REQUIRE(literal_value(leaf->operands[1])->fits_int64(exponent));
    return value(leaf->operands[0], names).pow(static_cast<int>(exponent));
  });
}

const Wording kWords{{"n", "h", "t", "k", "c"}, "n", true};

/// In h, k and c, with up to 20 terms and up to 20 digits each.
Fraction some_fraction() {
  const auto polynomial = [] {
    Polynomial p;
    for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
      const Rational c(*rc::gen::inRange(-2'000'000'000, 2'000'000'000), *rc::gen::inRange(1, 100'000));
      p += Polynomial(c) * Polynomial::letter(kStepLetter, *rc::gen::inRange(0, 9)) *
           Polynomial::letter(kStiffness, *rc::gen::inRange(0, 5)) *
           Polynomial::letter(kDamping, *rc::gen::inRange(0, 3));
    }
    return p;
  };
  const Polynomial below = *rc::gen::inRange(0, 3) == 0 ? polynomial() : Polynomial(1);
  return Fraction(polynomial(), below.is_zero() ? Polynomial(1) : below);
}

}  // namespace

TEST_CASE("names put back give the formula's value, and what is left between them is short") {
  CHECK(rc::check([] {
    const Fraction a = some_fraction(), b = some_fraction();
    const Expr e = joined(formula(a, name("x0"), kWords), formula(b, kWords) * name("v0")) -
                   formula(a / Fraction(2), kWords) * name("n");
    NamedFormulas names(Style::language, false, kWords.letters);
    const Expr shorter = names.shortened(e);
    Values at{{"h", Rational(3, 7)},  {"k", Rational(-5, 3)},  {"c", Rational(11, 2)},
              {"x0", Rational(2, 9)}, {"v0", Rational(-7, 4)}, {"n", 13}};
    Rational expected;
    try {
      expected = value(e, at);
    } catch (const Undefined&) {
      return;  // a denominator that vanishes there
    }
    for (const auto& [piece, meaning] : names.named_values()) {
      RC_ASSERT(print(meaning).size() > kLongestPiece);
      at[piece] = value(meaning, at);
    }
    RC_ASSERT(value(shorter, at) == expected);
  }));
}

TEST_CASE("half of a piece is half of its name, and short formulas stay as they are") {
  Polynomial p = 2;
  for (int k = 1; k < 9; ++k)
    p += Polynomial(Rational(123'456'789 + k, 987'654'321)) * Polynomial::letter(kStepLetter, 2 * k) *
         Polynomial::letter(kStiffness, k);
  NamedFormulas names(Style::language, false, kWords.letters);
  CHECK(names.print(formula(Fraction(p), kWords)) == "p1");
  CHECK(names.print(formula(Fraction(p) / Fraction(2), kWords) * name("x0")) == "1/2*p1*x0");
  CHECK(names.print(formula(-Fraction(p), kWords)) == "-p1");
  CHECK(names.print(formula(Fraction(p).pow(2), kWords)) == "p2");
  CHECK(names.print(formula(Fraction::letter(kStepLetter) + Fraction(1), kWords)) == "h + 1");
  const std::string told = names.introduced();
  CHECK(told.starts_with("    p1 = "));
  CHECK(told.find(
            " + ... (a polynomial of 9 terms, degree 16 in h, 8 in k; rounded here; --full prints it)\n") !=
        std::string::npos);
  CHECK(names.introduced().empty());
  NamedFormulas full(Style::language, true, kWords.letters);
  CHECK(full.print(formula(Fraction(p), kWords)) == print(formula(Fraction(p), kWords)));
  CHECK(full.introduced().empty());
  NamedFormulas beside(Style::language, false, {"h", "p1"});  // the integrator's own p1
  CHECK(beside.print(formula(Fraction(p), kWords)) == "pp1");
}
