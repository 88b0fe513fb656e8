// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_plan.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/floating/exact_pair.hpp"
#include "analysis/floating/exact_step.hpp"
#include "analysis/floating/exact_words.hpp"

using namespace shortfall;

namespace {

class RandomIntegers {
 public:
  explicit RandomIntegers(unsigned seed) : engine_(seed), numbers_(gmp_randinit_mt) { numbers_.seed(seed); }
  int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
  mpz_class bits(int count) {
    const mpz_class size = numbers_.get_z_bits(static_cast<mp_bitcnt_t>(count));
    return below(2) ? size : mpz_class(-size);
  }
  /// Zeros, units, powers of two, words, and longer ones now and then.
  mpz_class entry(bool long_ones) {
    switch (below(long_ones ? 7 : 6)) {
      case 0:
        return 0;
      case 1:
        return below(2) ? 1 : -1;
      case 2:
        return (below(2) ? 1 : -1) * (mpz_class(1) << below(60));
      case 6:
        return bits(200);
      default:
        return bits(1 + below(61));
    }
  }

 private:
  std::mt19937 engine_;
  gmp_randclass numbers_;
};

std::vector<std::vector<mpz_class>> matrix(RandomIntegers& random, std::size_t size, bool long_ones) {
  std::vector<std::vector<mpz_class>> m(size, std::vector<mpz_class>(size));
  for (auto& row : m)
    for (mpz_class& entry : row) entry = random.entry(long_ones);
  // Rows that differ in one entry are where one row is made of another.
  if (random.below(2) && size > 1) {
    m[1] = m[0];
    m[1][0] += random.entry(false);
  }
  return m;
}

std::vector<mpz_class> vector(RandomIntegers& random, std::size_t size) {
  std::vector<mpz_class> z;
  for (std::size_t i = 0; i < size; ++i) z.push_back(random.below(9) ? random.bits(random.below(600)) : 0);
  return z;
}

}  // namespace

TEST_CASE("a plan of few passes is the matrix, for random matrices and long integers") {
  RandomIntegers random(1);
  for (int run = 0; run < 3000; ++run) {
    const std::size_t size = 1 + random.below(5);
    const auto m = matrix(random, size, true);
    auto z = vector(random, size);
    std::vector<mpz_class> room(size);
    const ExactPlan plan(m);
    for (int step = 0; step < 3; ++step) {
      const auto expected = product(m, z);
      plan.apply(z, room);
      REQUIRE(z == expected);
    }
  }
}

TEST_CASE("two rows in one pass over the limbs are the matrix, also where leading limbs cancel") {
  RandomIntegers random(2);
  int runs = 0;
  for (int run = 0; run < 5000; ++run) {
    auto m = matrix(random, 2, false);
    if (!ExactPair::fits(m)) continue;
    auto z = vector(random, 2);
    if (run % 3 == 0) {
      // m00 z0 + m01 z1 is small, or zero, of either sign: leading limbs do not tell which.
      z[0] = m[0][1] * random.bits(500);
      if (m[0][1] != 0) z[1] = -m[0][0] * (z[0] / m[0][1]) + random.below(3) - 1;
    }
    const ExactPair pair(m);
    for (int step = 0; step < 3; ++step) {
      const auto expected = product(m, z);
      pair.apply(z);
      REQUIRE(z == expected);
    }
    ++runs;
  }
  CHECK(runs > 3000);
}

TEST_CASE("entries of 61 bits and limbs of ones do not overflow the pass") {
  const mpz_class most = (mpz_class(1) << 61) - 1, ones = (mpz_class(1) << 640) - 1;
  for (const int signs : {0, 1, 2, 3, 5, 10, 15}) {
    std::vector<std::vector<mpz_class>> m(2, std::vector<mpz_class>(2));
    for (int i = 0; i < 4; ++i) m[i / 2][i % 2] = signs >> i & 1 ? mpz_class(-most) : most;
    for (const int of_z : {0, 1, 3}) {
      std::vector<mpz_class> z{of_z & 1 ? mpz_class(-ones) : ones, of_z & 2 ? mpz_class(-ones) : ones};
      const auto expected = product(m, z);
      ExactPair(m).apply(z);
      CHECK(z == expected);
    }
  }
}

TEST_CASE("words stop before they overflow, and hold what was computed until then") {
  RandomIntegers random(3);
  for (int run = 0; run < 500; ++run) {
    const std::size_t size = 1 + random.below(6);
    std::vector<std::int64_t> m;
    std::vector<std::vector<mpz_class>> same(size, std::vector<mpz_class>(size));
    for (std::size_t i = 0; i < size * size; ++i) {
      m.push_back(random.below(7) - 3);
      if (random.below(4) == 0) m.back() = 0;
      same[i / size][i % size] = m.back();
    }
    std::vector<Int128> start;
    std::vector<mpz_class> z;
    for (std::size_t i = 0; i < size; ++i) {
      start.push_back(random.below(1000) - 500);
      z.emplace_back(static_cast<long>(start.back()));
    }
    ExactWords words(m, start);
    const std::int64_t done = words.advance(1 + random.below(300));
    for (std::int64_t n = 0; n < done; ++n) z = product(same, z);
    const mpz_class limit = mpz_class(1) << 126;
    for (std::size_t i = 0; i < size; ++i) {
      REQUIRE(static_cast<bool>(abs(z[i]) < limit));
      const Int128 w = words.state()[i];
      const mpz_class high = static_cast<long>(w >> 64),
                      low = static_cast<unsigned long>(static_cast<std::uint64_t>(w));
      REQUIRE(static_cast<bool>((high << 64) + low == z[i]));
    }
  }
}
