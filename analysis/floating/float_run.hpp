// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/floating/float_format.hpp"
#include "analysis/motion/force.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// What a floating-point number is: an exact rational, or none.
struct FloatNumber {
  enum class Kind { finite, infinite, not_a_number };
  Kind kind = Kind::finite;
  Rational value;  ///< when finite; otherwise 1 or -1 for the sign of an infinity

  bool is_finite() const { return kind == Kind::finite; }
  /// Like the number, or "infinity", "-infinity", "NaN".
  std::string str(int digits) const;
};

/// What a step is run with. All numbers are those that are meant; the run rounds each once, as a program that
/// stores them does.
struct FloatQuestion {
  Program program;
  Values parameters;
  int substeps = 1;
  Force force;  ///< with numbers; the step's arithmetic is f0 + t (f1 + t (...)) - k x - c v, left to right
  Rational h;
  std::optional<Rational> kept_h{};  ///< what is stored for h, when that was said: 0.02f for 0.02
  Rational x0;
  Rational v0;
  bool as_meant = false;  ///< of stored(): that the format holds every one of these numbers
};

/// Is shown the vectors that a step makes, each with the statement that it belongs to (null for none).
using Seen = std::function<void(const Statement*, const FloatNumber&)>;

/// A step run in some arithmetic, operation by operation.
class FloatRun {
 public:
  virtual ~FloatRun() = default;
  /// Back to x0, v0.
  virtual void begin() = 0;
  virtual void step() = 0;
  /// Position and velocity as reported now.
  virtual std::pair<FloatNumber, FloatNumber> state() = 0;
  /// The same as binary64, rounded: for figures and searches.
  virtual std::pair<double, double> rough() = 0;
  /// All carried vectors as binary64: the state, exactly for formats of at most 53 bits without variants.
  virtual void carried(std::vector<double>& state) = 0;

  /// The same as begin, step and state, with every vector shown on the way.
  virtual void begin(const Seen& seen) = 0;
  virtual void step(const Seen& seen) = 0;
  virtual std::pair<FloatNumber, FloatNumber> state(const Seen& seen) = 0;

  /// What rounding has done to position and velocity as reported now, exact minus computed, as tracked beside
  /// the run and rounded to binary64; none for runs that do not track.
  virtual std::optional<std::pair<double, double>> rounding() { return std::nullopt; }
};

/// throws  BadInput  for a letter of the force without a number;  Undefined  when a stage is singular
std::unique_ptr<FloatRun> float_run(const FloatFormat& format, const FloatQuestion& question);

/// The same run, bit for bit, that tracks its accumulated rounding error beside it (see tracked.hpp): against
/// the same step in exact arithmetic with the stored constants, for any step and any linear force.
///
/// None for formats whose roundings are not tracked: f128, dd, mpfr, +origin and +tozero.
/// throws  as float_run does
std::unique_ptr<FloatRun> tracked_run(const FloatFormat& format, const FloatQuestion& question);

/// The same in exact rational numbers, which grow with every step that is not exact in a short format.
///
/// throws  Unable  when the step has an irrational coefficient
std::unique_ptr<FloatRun> exact_run(const FloatQuestion& question);

/// The same question with every number as the format stores it: h, x0, v0, the force, parameters, and numbers
/// in the step that are no fractions of whole numbers. What is left between its exact answer and the run is
/// rounding.
///
/// throws  Unable  when a number is infinite in the format
FloatQuestion stored(const FloatQuestion& question, const FloatFormat& format);

}  // namespace shortfall
