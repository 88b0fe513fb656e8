// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/floating/double_double.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/series/processing.hpp"
#include "analysis/trade/smooth_tape.hpp"

namespace shortfall {

/// What the forces of a tape (of x, v, t) read: "a(x, v, t)", "a(x, t)", "a(x, v)", "a(x)".
std::string force_read_by(const SmoothTape& acceleration);

/// The launch and read-out that raise an integrator's order for forces of a class; none when nothing does.
///
/// throws  Unable  when the step has no series
std::optional<Processing> launch_for(const Program& program, const Values& parameters,
                                     const std::string& forces);

/// The elementary differentials of a launch at a state, in numbers: what is added to x and to v.
///
/// A tree of the differential is evaluated by its meaning: a[t1, t2] is the second derivative of the force in
/// the directions of t1 and t2, taken exactly by numbers with one nilpotent part for each direction.
class LaunchTerms {
 public:
  /// param  terms  with numbers for coefficients
  LaunchTerms(SmoothTape acceleration, const std::vector<FieldTerm>& terms);

  /// Adds what belongs to a step h.
  void add(std::vector<DoubleDouble>& x, std::vector<DoubleDouble>& v, const DoubleDouble& t,
           const DoubleDouble& h) const;

 private:
  using Vector = std::vector<DoubleDouble>;
  struct Tree {
    char root;  ///< 'a', 'v' or '1'
    std::vector<Tree> children;
  };
  struct Term {
    bool of_velocity;
    int power;
    DoubleDouble coefficient;
    Tree tree;
  };
  struct At {
    const Vector& x;
    const Vector& v;
    const DoubleDouble& t;
  };
  static Tree tree(const std::string& text, std::size_t& next);
  Vector differential(const Tree& tree, const At& at) const;
  Vector derivative(const Tree& tree, const At& at) const;

  SmoothTape tape_;
  std::vector<Term> terms_;
};

}  // namespace shortfall
