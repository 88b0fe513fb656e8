// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/floating/exact_step.hpp"
#include "analysis/floating/growing_fixed_point.hpp"

namespace shortfall {

/// A power of a ball, the exponent of 64 bits and not negative.
Ball powered(const Ball& base, std::int64_t exponent);

/// The state of an ExactStep whose D is a power of two, one frame after the other: z(n) / D^n as fixed point
/// that grows at its low end, so that a step is a product by a word and an addition in one pass for each
/// coefficient that is not 1, and nothing is shifted. The leading digits of a number can be read without the
/// others.
class ExactDyadic {
 public:
  /// Nothing when D is no power of two above 1, or a step may make a number longer by a whole limb.
  static std::optional<ExactDyadic> of(const ExactStep& step);

  void load(const std::vector<mpz_class>& z, std::int64_t frame);
  void step();
  std::vector<mpz_class> values() const;  ///< z(n)

  int sign(int entry) const { return state_[entry].sign(); }
  /// z_i / D^n, with a radius of at most |z_i / D^n| 2^-bits.
  Ball scaled(int entry, int bits) const;
  std::size_t limbs() const;  ///< of the longest entry

 private:
  /// word 2^-(64 down) times an entry, which is old or new.
  struct Term {
    int source = 0;
    bool fresh = false;
    bool negative = false;
    mp_limb_t word = 1;
    std::size_t down = 0;
  };
  struct Row {
    int target = 0;
    bool keeps = false;  ///< the entry itself, times 1, is one of its terms and not among these
    std::vector<Term> terms;
  };

  bool add_term(Row& row, int source, bool fresh, const mpz_class& coefficient, std::int64_t places);

  std::int64_t places_ = 0;  ///< D = 2^places
  std::int64_t frame_ = 0;
  bool in_place_ = true;
  std::vector<Row> rows_;
  std::vector<GrowingFixedPoint> state_, next_;
};

}  // namespace shortfall
