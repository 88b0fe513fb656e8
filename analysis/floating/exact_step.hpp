// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <cstddef>
#include <vector>

#include "analysis/motion/step_matrix.hpp"

namespace shortfall {

/// One step of a trajectory in whole numbers over a known denominator: with the scaled state z,
///
///   z(n+1) = M z(n),   the state's entry i after n steps is z_i(n) / (s_i D0 D^n),
///
/// so that no step needs a greatest common divisor. D is least for a diagonal scaling s: for each prime (or
/// coprime factor) of the denominators the exponent in D is the largest mean over the cycles of the
/// matrix, rounded up, and s are the potentials that reach it; under gravity alone D is 1.
///
/// source  Cuninghame-Green (1979), Minimax Algebra (the cycle mean as eigenvalue of a max-plus matrix);
///         Bach, Driscoll & Shallit (1993), Factor refinement, Journal of Algorithms 15
struct ExactStep {
  /// A reported number is (row z) / (denominator D0 D^n).
  struct Report {
    std::vector<mpz_class> row;
    mpz_class denominator = 1;
    int unit = -1;  ///< the only entry of z that it reads, with weight 1; -1 when it is not so simple
  };

  std::vector<std::vector<mpz_class>> matrix;  ///< M
  std::vector<mpz_class> start;                ///< z(0)
  mpz_class base = 1;                          ///< D
  mpz_class start_denominator = 1;             ///< D0
  Report position, velocity;

  std::size_t size() const { return matrix.size(); }
};

/// param   matrix  of rational numbers only
ExactStep exact_step(const StepMatrix& matrix);

/// Rows times a vector.
std::vector<mpz_class> product(const std::vector<std::vector<mpz_class>>& matrix,
                               const std::vector<mpz_class>& vector);
std::vector<std::vector<mpz_class>> product(const std::vector<std::vector<mpz_class>>& a,
                                            const std::vector<std::vector<mpz_class>>& b);

}  // namespace shortfall
