// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_language.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/check.hpp"
#include "analysis/program/parse.hpp"
#include "notebooks-export/code.hpp"
#include "notebooks-export/code_template.hpp"

namespace shortfall {
namespace {

Expr formula(const std::string& text) {
  Names names;
  for (const char* letter : {"p", "q", "r", "alpha_m", "lambda"})
    names.declare(letter, {Sort::scalar, kPure, false});
  return parse_formula(text, "test", names, {Sort::scalar, kPure, false});
}

std::string in(Language language, const std::string& text) { return code(formula(text), language); }

TEST_CASE("numbers are written so that one rounding is all that happens to them") {
  CHECK(literal(Rational(1, 2), Language::csharp) == "0.5f");
  CHECK(literal(Rational(1, 2), Language::rust) == "0.5");
  CHECK(literal(3, Language::cpp) == "3.0f");
  CHECK(literal(3, Language::gdscript) == "3.0");
  CHECK(literal(3, Language::python) == "3");
  CHECK(literal(Rational(981, 100), Language::javascript) == "9.81");
  CHECK(literal(Rational(-2, 3), Language::cpp) == "-2.0f / 3.0f");
}

TEST_CASE("the order of operations is the author's") {
  CHECK(in(Language::python, "p*(q*r)") == "p * (q * r)");
  CHECK(in(Language::python, "p*q*r") == "p * q * r");
  CHECK(in(Language::python, "p/(q/r)") == "p / (q / r)");
  CHECK(in(Language::python, "p - (q - r)") == "p - (q - r)");
  CHECK(in(Language::python, "(p + q)*r") == "(p + q) * r");
  CHECK(in(Language::python, "p*(-q)") == "p * -q");
  CHECK(in(Language::python, "-(p + q)") == "-(p + q)");
  CHECK(in(Language::python, "p - (-q)") == "p - -q");
  CHECK(in(Language::python, "-(-p)") == "-(-p)");
  CHECK(in(Language::cpp, "1/2*p") == "1.0f / 2.0f * p");
}

TEST_CASE("powers are products, from the left") {
  CHECK(in(Language::cpp, "p^3") == "p * p * p");
  CHECK(in(Language::cpp, "q*p^2") == "q * (p * p)");
  CHECK(in(Language::cpp, "p^2*q") == "p * p * q");
  CHECK(in(Language::cpp, "(p + q)^2") == "(p + q) * (p + q)");
  CHECK(in(Language::javascript, "p^-2") == "1 / (p * p)");
  CHECK(in(Language::javascript, "p^0") == "1");
  CHECK_THROWS_AS(in(Language::javascript, "p^33"), Unable);
}

TEST_CASE("names follow the language's habit and keep out of the way of its keywords") {
  CHECK(in(Language::csharp, "alpha_m") == "alphaM");
  CHECK(in(Language::rust, "alpha_m") == "alpha_m");
  CHECK(in(Language::python, "lambda") == "lambda_");
  CHECK(constant_identifier("alpha_m", Language::csharp) == "AlphaM");
  CHECK(constant_identifier("alpha_m", Language::cpp) == "kAlphaM");
  CHECK(constant_identifier("alpha_m", Language::python) == "ALPHA_M");
}

TEST_CASE("languages have several names") {
  CHECK(language_named("C#") == Language::csharp);
  CHECK(language_named("cpp") == Language::cpp);
  CHECK(language_named("JS") == Language::javascript);
  CHECK_FALSE(language_named("cobol"));
  for (const std::string& name : language_names()) CHECK(language_named(name));
}

TEST_CASE("a formula becomes a function") {
  const CodeFunction function{"corrected_launch",
                              {"v0 corrected."},
                              {"v0", "g", "h"},
                              name("v0") + number(Rational(1, 2)) * name("g") * name("h")};
  CHECK(code(function, Language::python) ==
        "# v0 corrected.\ndef corrected_launch(v0, g, dt):\n    return v0 + 0.5 * g * dt\n");
  CHECK(code(function, Language::csharp) ==
        "// v0 corrected.\nstatic float CorrectedLaunch(float v0, float g, float dt)\n{\n    return v0 + "
        "0.5f * g * dt;\n}\n");
}

TEST_CASE("a template is filled line by line, and asks for nothing that is not there") {
  CHECK(filled("a\n  @lines@\nb @word@!\n", {{"lines", {"x", "", "y"}}, {"word", {"c"}}}) ==
        "a\n  x\n\n  y\nb c!\n");
  CHECK(filled("a\n  @lines@\nb", {{"lines", {}}}) == "a\nb");
  CHECK_THROWS_AS(filled("@missing@\n", {}), Error);
}

}  // namespace
}  // namespace shortfall
