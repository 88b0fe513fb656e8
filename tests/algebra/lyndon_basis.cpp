// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/lyndon_basis.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

namespace {

/// [P_i, P_j] by multiplying the words out.
std::vector<std::int64_t> commutator_in_words(const LyndonBasis& basis, int d1, int i, int d2, int j) {
  const auto u = basis.polynomial(d1, i), v = basis.polynomial(d2, j);
  std::vector<std::int64_t> result(u.size() * v.size());
  for (std::size_t x = 0; x < u.size(); ++x)
    for (std::size_t y = 0; y < v.size(); ++y) {
      result[x * v.size() + y] += static_cast<std::int64_t>(u[x]) * v[y];
      result[y * u.size() + x] -= static_cast<std::int64_t>(u[x]) * v[y];
    }
  return result;
}

}  // namespace

TEST_CASE(
    "there are as many Lyndon words as Witt's formula says: 2, 1, 2, 3, 6, 9, 18, 30, 56, 99, 186, 335") {
  const std::vector<int> known{2, 1, 2, 3, 6, 9, 18, 30, 56, 99, 186, 335};
  const LyndonBasis& basis = LyndonBasis::up_to(12);
  for (int d = 1; d <= 12; ++d) {
    CHECK(basis.dimension(d) == known[static_cast<std::size_t>(d) - 1]);
    CHECK(witt_dimension(d) == known[static_cast<std::size_t>(d) - 1]);
  }
}

TEST_CASE("the Lyndon words of five letters and their brackets are those of the literature") {
  const LyndonBasis& basis = LyndonBasis::up_to(5);
  std::vector<std::string> words, brackets;
  for (int i = 0; i < basis.dimension(5); ++i) {
    words.push_back(basis.words(5)[static_cast<std::size_t>(i)].str());
    brackets.push_back(basis.bracket_text(5, i));
  }
  CHECK(words == std::vector<std::string>{"AAAAB", "AAABB", "AABAB", "AABBB", "ABABB", "ABBBB"});
  CHECK(brackets == std::vector<std::string>{"[A,[A,[A,[A,B]]]]", "[A,[A,[[A,B],B]]]", "[[A,[A,B]],[A,B]]",
                                             "[A,[[[A,B],B],B]]", "[[A,B],[[A,B],B]]", "[[[[A,B],B],B],B]"});
}

TEST_CASE("a standard bracket is its Lyndon word plus larger words") {
  const LyndonBasis& basis = LyndonBasis::up_to(10);
  for (int d = 1; d <= 10; ++d)
    for (int i = 0; i < basis.dimension(d); ++i) {
      const auto p = basis.polynomial(d, i);
      std::size_t first = 0;
      while (p[first] == 0) ++first;
      CHECK((std::size_t{1} << d) + first == basis.words(d)[static_cast<std::size_t>(i)].code);
      CHECK(p[first] == 1);
    }
}

TEST_CASE("brackets of basis elements are what multiplying out the words gives, to degree 8") {
  const LyndonBasis& basis = LyndonBasis::up_to(8);
  for (int d1 = 1; d1 < 8; ++d1)
    for (int d2 = 1; d1 + d2 <= 8; ++d2)
      for (int i = 0; i < basis.dimension(d1); ++i)
        for (int j = 0; j < basis.dimension(d2); ++j) {
          std::vector<std::int64_t> rest = commutator_in_words(basis, d1, i, d2, j);
          for (const auto& [index, c] : basis.bracket(d1, i, d2, j)) {
            const auto p = basis.polynomial(d1 + d2, index);
            for (std::size_t w = 0; w < p.size(); ++w) rest[w] -= static_cast<std::int64_t>(c) * p[w];
          }
          CHECK(rest == std::vector<std::int64_t>(rest.size(), 0));
        }
}

TEST_CASE("words are taken apart and put together") {
  const Word w = Word::of("AABAB");
  CHECK(w.length() == 5);
  CHECK(w.count_b() == 2);
  CHECK(w.part(1, 3) == Word::of("ABA"));
  CHECK(w.part(0, 2) * w.part(2, 3) == w);
  CHECK(Word{} * w == w);
  CHECK_THROWS_AS(Word::of("AXB"), Error);
}

TEST_CASE("a degree beyond the table is refused with the limit") {
  CHECK_THROWS_WITH_AS(LyndonBasis::up_to(13), doctest::Contains("to degree 12, not in degree 13"), Unable);
  CHECK_THROWS_AS(LyndonBasis::up_to(0), Unable);
}
