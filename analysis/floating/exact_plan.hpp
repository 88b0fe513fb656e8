// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <vector>

namespace shortfall {

/// How a matrix of whole numbers is applied to long integers with few passes over them: zeros are left out,
/// a coefficient of 1 is an addition, a power of two a shift, and a row may use one that has just been
/// computed (x = x + h v after v has changed), as an author's step does.
class ExactPlan {
 public:
  explicit ExactPlan(const std::vector<std::vector<mpz_class>>& matrix);

  /// next = M z; the two must not be the same.
  void apply(const std::vector<mpz_class>& z, std::vector<mpz_class>& next) const;

  /// In passes of one multiplication by a word.
  double cost() const { return cost_; }

  struct Term {
    int source = 0;
    bool fresh = false;  ///< of `next` instead of z
    mpz_class coefficient;
    mpz_class magnitude;
    bool negative = false;
    enum class Kind { unit, shift, word, integer } kind = Kind::unit;
    unsigned long word = 0;  ///< |coefficient|, or the exponent of two
  };

 private:
  struct Row {
    int target = 0;
    std::vector<Term> terms;
  };
  std::vector<Row> rows_;
  double cost_ = 0;
};

}  // namespace shortfall
