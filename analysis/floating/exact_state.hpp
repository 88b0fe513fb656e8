// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "analysis/floating/exact_dyadic.hpp"
#include "analysis/floating/exact_pair.hpp"
#include "analysis/floating/exact_plan.hpp"
#include "analysis/floating/exact_step.hpp"
#include "analysis/floating/exact_words.hpp"

namespace shortfall {

/// The scaled state of an ExactStep on its way: in words of 128 bits while it fits, in GMP integers
/// afterwards.
///
/// Steps of long integers are not made before somebody looks: several at once, by a power of M whose entries
/// still fit into words, cost hardly more than one. Who looks at every frame of a dyadic step gets growing
/// fixed point.
class ExactState {
 public:
  explicit ExactState(const ExactStep& step);

  std::int64_t frame() const { return frame_; }
  void advance(std::int64_t steps);
  /// The same by z^steps modulo the polynomial that annihilates the state (Fiduccia): about as many
  /// multiplications as `steps` has binary digits.
  ///
  /// source  Fiduccia (1985), An efficient formula for linear recurrences, SIAM Journal on Computing 14
  void jump(std::int64_t steps);

  bool in_words() const { return words_.has_value(); }
  /// The scaled state at this frame.
  const std::vector<mpz_class>& values();
  /// Of an entry of the scaled state.
  int sign(int entry);
  /// An entry / D^n with so many certain bits at least, by its leading digits; nothing where
  /// the state is no growing fixed point.
  std::optional<Ball> scaled(int entry, int bits);

 private:
  void apply(std::int64_t steps);
  bool add_power();
  void apply_power(std::int64_t steps);
  void step_dyadic();
  void settle();  ///< makes the steps that are counted
  void check_length(std::size_t limbs) const;
  void make_room();
  void enter_words();
  void leave_words();

  const ExactStep& step_;
  std::int64_t frame_ = 0;
  std::optional<ExactWords> words_;
  /// M^1, M^2, ... as far as entries fit into a word; how they are applied is found out when they are.
  std::vector<std::vector<std::vector<mpz_class>>> powers_;
  std::vector<std::variant<std::monostate, ExactPair, ExactPlan>> ways_;
  std::int64_t pending_ = 0;  ///< steps that are counted but not made; at most powers_.size()
  bool all_powers_ = false;
  std::int64_t seen_ = -1;  ///< the frame for which z_ is a copy of the words
  std::size_t room_ = 0;    ///< limbs that z_ and next_ have at least
  std::vector<mpz_class> z_, next_;
  /// Where it is in use, z_ is a copy of it, for the frame `copied_`.
  std::optional<ExactDyadic> dyadic_;
  bool in_dyadic_ = false;
  std::int64_t copied_ = -1;
};

/// No number of a trajectory may be longer, in binary digits (256 MB).
inline constexpr std::int64_t kLongestExactNumber = std::int64_t{1} << 31;

}  // namespace shortfall
