// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/known_number.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/audit/slip.hpp"

using namespace shortfall;

namespace {

std::string recognised(const std::string& decimal) {
  const int digits = static_cast<int>(decimal.size() - decimal.find('.') - 1);
  const auto found = known_number(Rational::parse(decimal), digits, 1);
  return found ? found->text : "";
}

}  // namespace

TEST_CASE("decimals that stand for rational, quadratic and cubic numbers are recognised") {
  CHECK(recognised("0.333333333333") == "1/3");
  CHECK(recognised("-0.032876712328767") == "-12/365");
  CHECK(recognised("0.211324865405187") == "(3 - sqrt(3))/6");
  CHECK(recognised("0.788675134594813") == "(3 + sqrt(3))/6");
  CHECK(recognised("0.292893218813452") == "(2 - sqrt(2))/2");
  CHECK(recognised("1.35120719195965763405") == "a root of 6 x^3 - 12 x^2 + 6 x - 1");
  CHECK(recognised("0.4358665215084590") == "a root of 6 x^3 - 18 x^2 + 9 x - 1");
}

TEST_CASE("a decimal that is nothing in particular is not recognised") {
  CHECK(recognised("3.14159265358979323846") == "");
  CHECK(recognised("0.33") == "");  // too few digits to say
  CHECK(recognised("0.5772156649015329") == "");
  std::mt19937_64 random(20261125);
  int wrong = 0;
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    std::string decimal = "0.";
    for (int k = 0; k < 16; ++k) decimal += static_cast<char>('0' + random() % 10);
    wrong += !recognised(decimal).empty();
  }
  MESSAGE(wrong << " of " << kTrials << " random decimals with 16 digits are taken for known numbers");
  CHECK(wrong <= 10);  // a surplus of three digits in each of four degrees: 4 in a thousand at most
}

TEST_CASE("slips are told by what they are") {
  CHECK(slip("56/15", "-56/15").words == "a sign is lost");
  CHECK(slip("19732/6561", "19372/6561").words == "two digits change places");
  CHECK(slip("3/2", "2/3").words == "a fraction is upside down");
  CHECK(slip("-5/6", "-53/6").words == "a digit is dropped");
  CHECK(slip("13525/554296", "13525/55296").words == "there is a digit too many");
  CHECK(slip("13525/552296", "13525/55296").words == "a digit is doubled");
  CHECK(slip("0.33333", "1/3").words == "a decimal has too few digits");
  CHECK(slip("0", "18/11").words == "an entry is left out");
  CHECK(slip("1/4-sqrt(3)/6", "1/4+sqrt(3)/6").words == "a sign is the other one");
  CHECK(slip("1/3", "1/3").cost == 0);
  CHECK(slip("3554/2565", "3544/2565").cost < slip("3554/2565", "17/19").cost);
}

TEST_CASE("a number is written in the manner of what is printed") {
  CHECK(written_like(Rational(1, 4), "3/8") == "1/4");
  CHECK(written_like(Rational(18576, 48384), "18574/48384") == "18576/48384");
  CHECK(written_like(Rational(1, 4), "0.26") == "0.25");
  CHECK(written_like(Rational(1), "1/4") == "1");
}

TEST_CASE("the distance of texts is a distance") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("12", "21") == 1);
  CHECK(edit_distance("abc", "abd") == 1);
  CHECK(edit_distance("abc", "ac") == 1);
  std::mt19937 random(7);
  const auto word = [&] {
    std::string text(random() % 7, ' ');
    for (char& c : text) c = static_cast<char>('0' + random() % 3);
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word(), b = word();
    CHECK(edit_distance(a, b) == edit_distance(b, a));
    CHECK((edit_distance(a, b) == 0) == (a == b));
  }
}
