// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/trade/scene.hpp"
#include "analysis/trade/scene_forces.hpp"
#include "analysis/trade/smooth_tape.hpp"

namespace shortfall {

/// Which forces of a scene count, by index; all when empty.
using ForceChoice = std::vector<bool>;

/// The accelerations of a scene as a tape: inputs x (m), v (m), t; outputs m.
///
/// throws  Undefined  when an expression divides by zero
SmoothTape acceleration_tape(const Scene& scene, const ForceChoice& chosen = {});

/// The energy of a scene (masses included) as a tape of x, v, t; none when a force has no potential.
///
/// param  why  is told which force has none
std::optional<SmoothTape> energy_tape(const Scene& scene, const ForceChoice& chosen = {},
                                      std::string* why = nullptr);

/// A potential V(x) and its derivatives up to so many primes: inputs x, v, t; outputs V, V', V'', ....
///
/// throws  Undefined  when the expression divides by zero;  Unable  for a function that has no tape
SmoothTape potential_tape(const Expr& potential, int derivatives);

/// A tape run in plain numbers: for expressions, and for energies.
template <class S>
class TapeValues {
 public:
  explicit TapeValues(SmoothTape tape);
  int outputs() const { return static_cast<int>(tape_.outputs.size()); }
  /// param  x, v  m numbers each;  out  one number for each output
  void operator()(const S* x, const S* v, const S& t, int m, S* out);
  /// One coordinate, one output, kTapeLanes trajectories: the same, number by number. S is float or double.
  void lanes(const S* x, const S* v, const S& t, S* out);

 private:
  SmoothTape tape_;
  std::vector<S> values_;
  std::vector<S> rows_;  ///< of `lanes`
};

/// The accelerations of a scene in plain numbers: the terms of the library natively, expressions by their
/// tapes. S is float, double or DoubleDouble.
template <class S>
class SceneAcceleration {
 public:
  explicit SceneAcceleration(const Scene& scene, const ForceChoice& chosen = {});
  int coordinates() const { return m_; }
  /// The forces that are held over a frame are evaluated now.
  void begin_frame(const S* x, const S* v, const S& t);
  bool holds() const { return !held_.empty(); }
  void operator()(const S* x, const S* v, const S& t, S* a);
  /// Of `count` motions of one coordinate, without forces that are held: the same, number by number. S is
  /// float or double.
  void many(const S* x, const S* v, const S& t, S* a, std::size_t count);

 private:
  void add(const std::vector<int>& which, const S* x, const S* v, const S& t, S* a);

  int m_;
  std::vector<ForceTerm<S>> terms_;
  std::vector<TapeValues<S>> tapes_;  ///< of the terms that are expressions
  std::vector<int> tape_of_;          ///< index of a term's tape, or -1
  std::vector<int> free_, held_;      ///< indices of terms
  std::vector<S> kept_, extra_;
};

}  // namespace shortfall
