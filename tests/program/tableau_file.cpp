// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tableau_file.hpp"

using namespace shortfall;

namespace {

TableauFile read(const std::string& text) { return parse_tableau(text, "test.json"); }

/// A midpoint rule with this entry, as JSON, below the diagonal.
TableauFile with_entry(const std::string& entry, const std::string& more = "") {
  return read("{\"A\": [[0, 0], [" + entry + ", 0]], \"b\": [0, 1]" + more + "}");
}

}  // namespace

TEST_CASE("an entry is what is written, not the binary number next to it") {
  CHECK(with_entry("0.1").a[1][0].exact == Rational(1, 10));
  CHECK(with_entry("0.1").a[1][0].decimal);
  CHECK(with_entry("-1.25e-2").a[1][0].exact == Rational(-1, 80));
  CHECK(with_entry("\"-7/21\"").a[1][0].exact == Rational(-1, 3));
  CHECK(with_entry("\"-7/21\"").a[1][0].text == "-7/21");
  CHECK(with_entry("\" 1/4 - 1/8 \"").a[1][0].exact == Rational(1, 8));
  CHECK(with_entry("123456789012345678901234567890").a[1][0].exact ==
        Rational::parse("123456789012345678901234567890"));
  CHECK_FALSE(with_entry("\"sqrt(2)/2\"").a[1][0].exact.has_value());
  CHECK(with_entry("\"sqrt(2)/2\"").exact());
}

TEST_CASE("a decimal with eight digits after the point stands for another number, a shorter one for itself") {
  const TableauFile exact = with_entry("0.1234567");
  CHECK(exact.exact());
  const TableauFile rounded = with_entry("0.12345678");
  CHECK_FALSE(rounded.exact());
  CHECK(rounded.a[1][0].digits == 8);
  CHECK(rounded.a[1][0].exact == Rational(12345678, 100000000));
  REQUIRE(rounded.program.approximations.size() == 1);
  CHECK(rounded.program.approximations[0].name == "a2_1");
  CHECK(rounded.program.approximations[0].value == Rational(12345678, 100000000));
  CHECK(with_entry("1.2345678e-3").exact());
  CHECK(with_entry("1.23456789e-3").a[1][0].digits == 11);
  CHECK(with_entry("0.00000000").exact());
}

TEST_CASE("a file may say that its decimals are exact, or rounded") {
  CHECK(with_entry("0.12345678", ", \"decimals\": \"exact\"").exact());
  CHECK(with_entry("0.29", ", \"decimals\": \"rounded\"").a[1][0].digits == 2);
  CHECK(with_entry("1", ", \"decimals\": \"rounded\"").exact());
  CHECK(with_entry("\"1/3\"", ", \"decimals\": \"rounded\"").exact());
}

TEST_CASE("with digits, long fractions agree with what they stand for to so many digits") {
  const TableauFile file = with_entry("\"1767732205903/4055673282236\"", ", \"digits\": 24");
  CHECK(file.a[1][0].digits == 24);
  CHECK(file.a[1][0].exact == Rational::parse("1767732205903/4055673282236"));
  REQUIRE(file.program.approximations.size() == 1);
  CHECK(file.program.approximations[0].text == "0.435866521508458999416019");
  CHECK(with_entry("\"1/3\"", ", \"digits\": 24").exact());
}

TEST_CASE(
    "the same decimal is the same coefficient, so that a last stage can be the first of the next step") {
  const TableauFile file =
      read(R"({"A": [[0, 0], ["0.33333333", 0]], "b": ["0.33333333", "0.66666667"], "c": [0, 0.33333333]})");
  CHECK(file.program.approximations.size() == 2);
  CHECK(same(file.a[1][0].value, file.b[0].value));
  CHECK(same(file.a[1][0].value, file.c[1].value));
}

TEST_CASE("a triangle may be written without what is zero, and without its empty first row") {
  const std::string rest = R"(, "b": ["1/6", "2/3", "1/6"], "c": [0, "1/2", 1]})";
  const Program full = read(R"({"A": [[0, 0, 0], ["1/2", 0, 0], [-1, 2, 0]])" + rest).program;
  for (const std::string rows :
       {R"([[], ["1/2"], [-1, 2]])", R"([["1/2"], [-1, 2]])", R"([[0], ["1/2", 0], [-1, 2, 0]])"}) {
    CAPTURE(rows);
    CHECK(same(read("{\"A\": " + rows + rest).program, full));
  }
  CHECK(read(R"({"A": [["1/4"], ["1/2", "1/4"]], "b": ["1/2", "1/2"]})").program.step.size() ==
        read(R"({"A": [["1/4", 0], ["1/2", "1/4"]], "b": ["1/2", "1/2"]})").program.step.size());
}

TEST_CASE("without c the times are the row sums") {
  const TableauFile file = read(R"({"A": [[], ["1/2"], [-1, "5/2"]], "b": [0, 0, 1]})");
  CHECK_FALSE(file.c_given);
  CHECK(file.c[0].exact == Rational(0));
  CHECK(file.c[2].exact == Rational(3, 2));
  const TableauFile roots =
      read(R"({"A": [["1/4", "1/4-sqrt(3)/6"], ["1/4+sqrt(3)/6", "1/4"]], "b": ["1/2", "1/2"]})");
  CHECK(print(roots.c[0].value) == "1/4 + (1/4 - sqrt(3)/6)");
}

TEST_CASE("a wrong c is kept: finding it is the audit's work") {
  const TableauFile file = read(R"({"A": [[], ["1/2"]], "b": [0, 1], "c": [0, 2]})");
  CHECK(file.c_given);
  CHECK(file.c[1].exact == Rational(2));
}

TEST_CASE("claims are kept with their places") {
  const TableauFile file = read(
      "{\"A\": [[\"1/2\"]], \"b\": [1],\n \"order\": 2, \"stage_order\": 1,\n \"symplectic\": true, "
      "\"A-stable\": true, \"L-stable\": false}");
  REQUIRE(file.claims.order);
  CHECK(file.claims.order->value == 2);
  CHECK(file.claims.order->place.line == 2);
  CHECK(file.claims.order->place.column == 11);
  CHECK(file.claims.symplectic->value);
  CHECK_FALSE(file.claims.l_stable->value);
  CHECK_FALSE(file.claims.symmetric.has_value());
  CHECK_FALSE(file.claims.embedded_order.has_value());
}

TEST_CASE("any text can be the name; the integrator's is made of it") {
  CHECK(read(R"json({"name": "Dormand-Prince 5(4)", "A": [[]], "b": [1]})json").name == "dormand-prince-5-4");
  CHECK(read(R"json({"name": "Dormand-Prince 5(4)", "A": [[]], "b": [1]})json").program.aliases ==
        std::vector<std::string>{"Dormand-Prince 5(4)"});
  CHECK(read(R"({"name": "3/8 rule", "A": [[]], "b": [1]})").name == "method-3-8-rule");
  CHECK(read(R"({"A": [[]], "b": [1]})").name == "test");
  CHECK(parse_tableau(R"({"name": "??", "A": [[]], "b": [1]})", "folder/My_Method.json").name == "my-method");
  CHECK(parse(print(read(R"({"name": "Tom\nJones", "A": [[]], "b": [1]})").program), "printed").name ==
        "tom-jones");
  const auto about = [](const std::string& text) { return print(read(text).program); };
  CHECK(about(R"({"description": "\u00b5s, \ud83d\ude00", "A": [[]], "b": [1]})").find("µs, 😀") !=
        std::string::npos);
  CHECK_THROWS_WITH(read(R"({"description": "\ud83d", "A": [[]], "b": [1]})"),
                    doctest::Contains("half a character"));
}

TEST_CASE("a description or source of several lines is still a comment in the integrator") {
  const TableauFile file = read(R"({"description": "one\ntwo", "source": ["a\tb"], "A": [[]], "b": [1]})");
  CHECK(same(parse(print(file.program), "printed"), file.program));
}

TEST_CASE("a tableau file is found wherever an integrator is asked for") {
  const std::string path = std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods/gauss4.json";
  CHECK(find_integrator(path).name == "gauss4");
  CHECK_THROWS_AS(find_integrator("no-such-file.json"), UnreadableFile);
  CHECK_THROWS_AS(find_integrator("/"), UnreadableFile);
}

TEST_CASE("an implicit Nystroem tableau solves for its stages") {
  const TableauFile file =
      read(R"({"kind": "nystroem", "Abar": [["1/4"]], "bbar": ["1/2"], "b": [1], "c": ["1/2"]})");
  REQUIRE(file.program.step.size() == 3);
  CHECK(file.program.step[0].kind == Statement::Kind::solve);
  CHECK(print(file.program).find("solve k1 : L/T^2 = a(x + 1/2*h*v + h^2*(1/4*k1), v, t + 1/2*h)") !=
        std::string::npos);
}
