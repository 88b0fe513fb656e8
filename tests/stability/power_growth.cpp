// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/power_growth.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "analysis/stability/square_matrix.hpp"

using namespace shortfall;

namespace {

using RationalMatrix = SquareMatrix<Rational>;
using Kind = PowerGrowth::Kind;

RationalMatrix zero(std::size_t size) { return RationalMatrix(size, std::vector<Rational>(size)); }

/// Blocks along the diagonal.
RationalMatrix joined(const std::vector<RationalMatrix>& blocks) {
  std::size_t size = 0;
  for (const RationalMatrix& b : blocks) size += b.size();
  RationalMatrix result = zero(size);
  std::size_t at = 0;
  for (const RationalMatrix& b : blocks) {
    for (std::size_t i = 0; i < b.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) result[at + i][at + j] = b[i][j];
    at += b.size();
  }
  return result;
}

RationalMatrix jordan(const Rational& eigenvalue, std::size_t size) {
  RationalMatrix m = zero(size);
  for (std::size_t i = 0; i < size; ++i) {
    m[i][i] = eigenvalue;
    if (i + 1 < size) m[i][i + 1] = 1;
  }
  return m;
}

/// Blocks of a rotation by the angle of (c, s), coupled as in a Jordan block: c^2 + s^2 = 1.
RationalMatrix rotations(const Rational& c, const Rational& s, std::size_t count) {
  RationalMatrix m = zero(2 * count);
  for (std::size_t b = 0; b < count; ++b) {
    m[2 * b][2 * b] = m[2 * b + 1][2 * b + 1] = c;
    m[2 * b][2 * b + 1] = -s;
    m[2 * b + 1][2 * b] = s;
    if (b + 1 < count) m[2 * b][2 * b + 2] = m[2 * b + 1][2 * b + 3] = 1;
  }
  return m;
}

/// The same map in random other coordinates.
RationalMatrix disguised(RationalMatrix m) {
  const int size = static_cast<int>(m.size());
  for (int k = 0; k < 2 * size && size > 1; ++k) {
    const auto i = static_cast<std::size_t>(*rc::gen::inRange(0, size));
    const auto j = static_cast<std::size_t>((static_cast<int>(i) + *rc::gen::inRange(1, size)) % size);
    const Rational f(*rc::gen::inRange(-2, 3));
    for (std::size_t c = 0; c < m.size(); ++c) m[i][c] += f * m[j][c];
    for (std::size_t r = 0; r < m.size(); ++r) m[r][j] -= f * m[r][i];
  }
  return m;
}

}  // namespace

TEST_CASE("Jordan blocks of every kind are found again in random coordinates") {
  CHECK(rc::check([] {
    std::vector<RationalMatrix> blocks;
    int degree = 0, inside = 0, plus = 0, minus = 0, pairs = 0;
    bool outside = false, on_circle = false;
    for (int b = *rc::gen::inRange(1, 4); b > 0; --b) {
      const auto size = static_cast<std::size_t>(*rc::gen::inRange(1, 4));
      const int n = static_cast<int>(size);
      switch (*rc::gen::inRange(0, 7)) {
        case 0:
          blocks.push_back(jordan(1, size));
          degree = std::max(degree, n - 1);
          plus = std::max(plus, n);
          on_circle = true;
          break;
        case 1:
          blocks.push_back(jordan(-1, size));
          degree = std::max(degree, n - 1);
          minus = std::max(minus, n);
          on_circle = true;
          break;
        case 2:
          blocks.push_back(rotations(Rational(3, 5), Rational(4, 5), size));
          degree = std::max(degree, n - 1);
          pairs = std::max(pairs, n);
          on_circle = true;
          break;
        case 3:
          blocks.push_back(jordan(Rational(-2, 3), size));
          inside += n;
          break;
        case 4:
          blocks.push_back(rotations(Rational(1, 2), Rational(1, 3), size));
          inside += 2 * n;
          break;
        case 5:
          blocks.push_back(jordan(0, size));
          break;
        default:
          // Rarely, or hardly anything else would be seen.
          if (*rc::gen::inRange(0, 3) == 0) {
            blocks.push_back(rotations(Rational(4, 5), Rational(4, 5), 1));
            outside = true;
          } else {
            blocks.push_back(jordan(Rational(99, 100), 1));
            ++inside;
          }
      }
    }
    const PowerGrowth g = power_growth(disguised(joined(blocks)));
    if (outside) {
      RC_ASSERT(g.kind == Kind::exponential);
      return;
    }
    RC_ASSERT(g.kind == (degree > 0 ? Kind::polynomial : Kind::bounded));
    RC_ASSERT(g.degree == degree);
    RC_ASSERT(g.inside == inside);
    RC_ASSERT(g.decays == !on_circle);
    const auto largest = [&](CircleEigenvalues::Kind kind) {
      int block = 0;
      for (const CircleEigenvalues& e : g.circle)
        if (e.kind == kind) block = std::max(block, e.largest_block);
      return block;
    };
    RC_ASSERT(largest(CircleEigenvalues::Kind::plus_one) == plus);
    RC_ASSERT(largest(CircleEigenvalues::Kind::minus_one) == minus);
    RC_ASSERT(largest(CircleEigenvalues::Kind::pairs) == pairs);
    for (const CircleEigenvalues& e : g.circle)
      if (e.kind == CircleEigenvalues::Kind::pairs) RC_ASSERT(e.cosine == Rational(3, 5));
  }));
}

TEST_CASE("a reciprocal pair of real eigenvalues is not on the circle") {
  CHECK(power_growth(RationalMatrix{{2, 0}, {0, Rational(1, 2)}}).kind == Kind::exponential);
  CHECK(power_growth(RationalMatrix{{3, -1}, {1, 0}}).kind == Kind::exponential);  // trace 3, determinant 1
  CHECK(power_growth(RationalMatrix{{-3, -1}, {1, 0}}).kind == Kind::exponential);
  CHECK(power_growth(RationalMatrix{{1, -1}, {1, 0}}).kind == Kind::bounded);  // sixth roots of unity
  CHECK(power_growth(RationalMatrix{{1, -1}, {1, 0}}).circle.front().cosine == Rational(1, 2));
}

TEST_CASE("Salem's number: a reciprocal polynomial with roots on the circle and one outside") {
  // source: Lehmer (1933): x^10 + x^9 - x^7 - x^6 - x^5 - x^4 - x^3 + x + 1, largest root 1.17628...
  const std::vector<Rational> lehmer{1, 1, 0, -1, -1, -1, -1, -1, 0, 1};
  RationalMatrix companion = zero(10);
  for (std::size_t i = 0; i < 10; ++i) {
    companion[9][i] = -lehmer[i];
    if (i < 9) companion[i][i + 1] = 1;
  }
  CHECK(power_growth(companion).kind == Kind::exponential);
  // A cyclotomic polynomial of the same look: all ten roots on the circle, each once (x^11 - 1)/(x - 1).
  for (std::size_t i = 0; i < 10; ++i) companion[9][i] = -1;
  const PowerGrowth cyclotomic = power_growth(companion);
  CHECK(cyclotomic.bounded());
  CHECK(cyclotomic.circle.front().count == 10);
}

TEST_CASE("over a number field: a rotation by an irrational cosine, sqrt(2)/2, and a hair more") {
  const auto generator = std::make_shared<const RealRoot>(Univariate<Rational>({-2, 0, 1}), 1, 2);
  const Algebraic c = Algebraic(Univariate<Rational>({0, Rational(1, 2)}), generator);
  const PowerGrowth turning = power_growth(SquareMatrix<Algebraic>{{c, -c}, {c, c}});
  CHECK(turning.bounded());
  CHECK_FALSE(turning.decays);
  const Algebraic hair = Algebraic(Rational(1) / Rational(10).pow(60));
  CHECK(power_growth(SquareMatrix<Algebraic>{{c + hair, -c}, {c, c + hair}}).kind == Kind::exponential);
  CHECK(power_growth(SquareMatrix<Algebraic>{{c - hair, -c}, {c, c - hair}}).decays);
}
