// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/motion/story.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// Evaluates the lines of a derivation at a whole number n, literally: sums are added up term by term, and
/// x_k is the vector that k steps in letters gave. So a line is tested by other means than those that
/// produced it. From one n to the next a sum goes on where it stood, and what no index enters is kept.
class LineCheck {
 public:
  /// param  points  how many steps to take in advance
  LineCheck(const StepMap& map, const std::vector<Quantity>& quantities, int degree, int points,
            Progress progress = {});

  /// Whether both sides agree, for index = from .. to; `index` is the name that is given this value, "n" or
  /// "k".
  bool agree(const Expr& left, const Expr& right, const std::string& index, int from, int to) const;

  /// The value of a quantity after n steps: columns x0, v0, then f0..fD.
  LinearForm quantity(int q, int n) const;

 private:
  using Value = std::variant<Fraction, LinearForm>;
  using Indices = std::map<std::string, int>;
  /// What need not be worked out again for the next value of the index.
  struct Memory {
    struct PartialSum {
      std::int64_t next = 0;
      Value value = Fraction();
    };
    std::map<const Expression*, bool> varies;
    std::map<const Expression*, Value> values;
    std::map<std::pair<const Expression*, std::int64_t>, PartialSum> sums;
  };
  Value evaluated(const Expr& e, const Indices& indices, Memory& memory) const;
  Value worked_out(const Expr& e, const Indices& indices, Memory& memory) const;
  Value summed(const Expr& e, const Indices& indices, Memory& memory) const;
  bool varies(const Expr& e, Memory& memory) const;
  bool is_letter(const std::string& name) const;
  Value of_name(const std::string& name, const Indices& indices) const;
  LinearForm exact(int n, bool position) const;

  const StepMap& map_;
  const std::vector<Quantity>& quantities_;
  int degree_;
  Progress progress_;
  std::vector<std::vector<LinearForm>> states_;
};

}  // namespace shortfall
