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

  /// z = M z, in place where no later row needs what an earlier one replaces.
  ///
  /// param   room  another vector of the same size, for what cannot be done in place
  void apply(std::vector<mpz_class>& z, std::vector<mpz_class>& room) const;

  /// Of applying it, in passes of one multiplication by a word.
  static double cost(const std::vector<std::vector<mpz_class>>& matrix);

  /// A coefficient times an entry.
  struct Term {
    int source = 0;
    bool fresh = false;  ///< of the new one
    mpz_class magnitude;
    bool negative = false;
    enum class Kind { unit, shift, word, integer } kind = Kind::unit;
    unsigned long word = 0;  ///< the magnitude, or the exponent of two
  };
  struct Row {
    int target = 0;
    std::vector<Term> terms;
  };
  /// The rows in the cheapest order that was found, each with what is dear in the first place.
  static std::vector<Row> rows(const std::vector<std::vector<mpz_class>>& matrix);
  /// Whether a row can be put where its entry was, as every old entry is used before it changes.
  static bool in_place(const std::vector<Row>& rows);

 private:
  /// out = a op b, or a op word; entries of z, then those of `room`.
  struct Operation {
    enum class Kind {
      zero,
      copy,
      negate,
      shift,
      multiply,
      add,
      subtract,
      add_product,       ///< out += a word
      subtract_product,  ///< out -= a word
      multiply_long,     ///< by longs_[word]
      add_long,
      subtract_long,
    };
    Kind kind;
    int out = 0;
    int a = 0;
    int b = 0;
    unsigned long word = 0;
  };
  void translate(const Row& row);

  int size_;
  bool in_place_ = true;
  std::vector<Operation> operations_;
  std::vector<mpz_class> longs_;
};

}  // namespace shortfall
