// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of several steps: trace and determinant by recurrence, against powers of the step's matrix in
// numbers.
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/stability/amplification.hpp"

using namespace shortfall;

namespace {

const Rational kY(7, 13), kD(3, 11);  // h^2 k and c h of the frame

SquareMatrix<Rational> in_numbers(const Amplification& a, int count) {
  SquareMatrix<Rational> result;
  for (const auto& row : a.matrix) {
    result.emplace_back();
    for (const Fraction& f : row)
      result.back().push_back(f.evaluate({{kStiffness, kY / (count * count)}, {kDamping, kD / count}}));
  }
  return result;
}

}  // namespace

TEST_CASE(
    "a frame of N steps has the trace and the determinant of the N-th power, with and without damping") {
  int compared = 0;
  for (const Program& p : catalogue())
    for (const Damping damping : {Damping::none, Damping::viscous}) {
      CAPTURE(p.name);
      Amplification step;
      try {
        step = amplification(p, parameter_values(p, {}), damping);
      } catch (const Error&) {
        continue;  // not for every length of the step
      }
      if (!step.algebraic.empty() || step.nonzero.size() != 3) continue;
      for (const int count : {2, 3, 5, 8}) {
        if (count == 8 && p.name.starts_with("blanes-moan")) continue;  // long formulas
        CAPTURE(count);
        const Amplification frame = repeated(step, count);
        const SquareMatrix<Rational> once = in_numbers(step, count);
        SquareMatrix<Rational> power = once;
        for (int k = 1; k < count; ++k) power = product(power, once);
        // The characteristic polynomial of the whole matrix, whose further eigenvalues are 0.
        const std::vector<Rational> whole = characteristic_coefficients(power);
        const std::size_t size = whole.size() - 1;
        for (std::size_t k = 0; k + 2 < size; ++k) CHECK(whole[k].is_zero());
        const auto at = [&](const Fraction& f) { return f.evaluate({{kStiffness, kY}, {kDamping, kD}}); };
        CHECK(-at(frame.trace()) == whole[size - 1]);
        CHECK(at(frame.determinant()) == whole[size - 2]);
        CHECK(frame.zeros == step.zeros);
        ++compared;
      }
    }
  CHECK(compared > 200);
}
