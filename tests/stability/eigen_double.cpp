// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues of amplification matrices by Eigen in binary64, beside what is decided exactly. One EigenSolver
// in this file: it takes its time to compile.
#include <doctest/doctest.h>

#ifdef SHORTFALL_WITH_EIGEN
#include <Eigen/Eigenvalues>
#include <cmath>

#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/stability/sampled.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

/// Sizes of the eigenvalues, largest first.
std::vector<double> sizes(const SquareMatrix<Rational>& m) {
  const Eigen::Index n = static_cast<Eigen::Index>(m.size());
  Eigen::MatrixXd numbers(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      numbers(i, j) = m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].to_double();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(numbers, false);
  std::vector<double> result;
  for (Eigen::Index i = 0; i < n; ++i) result.push_back(std::abs(solver.eigenvalues()[i]));
  std::ranges::sort(result, std::greater<>());
  return result;
}

}  // namespace

TEST_CASE("exact growth agrees with Eigen's eigenvalues for the whole catalogue, at 60 steps each") {
  int compared = 0;
  for (const Program& p : testing::undamped_catalogue()) {
    CAPTURE(p.name);
    const Amplification a = amplification(p, parameter_values(p));
    if (!a.algebraic.empty()) continue;  // irrational numbers have tests of their own
    const SampledEigenvalues sampled(a);
    for (int i = 1; i <= 60; ++i) {
      const Rational z(i, 11);
      CAPTURE(z.str());
      const SquareMatrix<Rational> m = matrix_at(a.matrix, kStiffness, z * z);
      const PowerGrowth growth = power_growth(m);
      const std::vector<double> found = sizes(m);
      // A double eigenvalue is known to half the digits; the growth rates here are not as small as that but
      // for the smallest steps.
      constexpr double kClear = 1e-6;
      if (growth.kind == PowerGrowth::Kind::exponential)
        CHECK(found.front() > 1 - kClear);
      else
        CHECK(found.front() < 1 + kClear);
      if (growth.decays) CHECK(found.front() < 1);
      if (found.front() > 1 + kClear) CHECK(growth.kind == PowerGrowth::Kind::exponential);
      // How many lie inside, where that is clear.
      if (growth.kind != PowerGrowth::Kind::exponential) {
        int inside = 0, unclear = 0;
        for (const double size : found) {
          if (std::abs(size - 1) < kClear) ++unclear;
          if (size < 1 - kClear) ++inside;
        }
        CHECK(inside <= growth.inside + a.zeros);
        CHECK(inside + unclear >= growth.inside + a.zeros);
      }
      // What pictures are drawn from.
      const std::vector<double> drawn = sampled.sizes(z.to_double());
      for (std::size_t k = 0; k < drawn.size(); ++k)
        CHECK(drawn[k] == doctest::Approx(found[k]).epsilon(1e-6));
      ++compared;
    }
  }
  CHECK(compared > 1000);
}
#else
TEST_CASE("eigenvalues by Eigen in binary64" * doctest::skip()) {}
#endif
