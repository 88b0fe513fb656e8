// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/identify/bit_run.hpp"
#include "analysis/identify/candidate.hpp"
#include "analysis/identify/fit.hpp"
#include "analysis/identify/log.hpp"

namespace shortfall {

/// A map that was held against a log.
struct Match {
  Candidate candidate;
  Fit fit;
  bool exact = false;            ///< every row agrees to the last bit
  double ulp = 0;                ///< the largest difference, in units of the last place that was recorded
  double allowed = 0;            ///< what rounding explains, in the same units
  EngineFlight flight;           ///< with the numbers that a program would have been given
  std::optional<Rational> c, k;  ///< as it would have been given; none where it is not told
  std::array<std::optional<Rational>, 3> a;  ///< of the acceleration's constant part
  int group = 0;  ///< maps that no experiment of ours tells apart have the same number

  bool reproduces() const { return exact || ulp <= allowed; }
};

/// From a frame on the log shows something else.
struct Break {
  enum class Kind { rest_before, first_frame, sleep, limit, contact, unexplained };
  Kind kind = Kind::unexplained;
  std::size_t row =
      0;  ///< the first row that the map does not explain; of rest_before, the first that it does
  std::string text;
};

/// What a log says about the map that made it.
struct Identification {
  enum class Kind {
    map,            ///< maps of the family reproduce it
    joint,          ///< nearly one: a spring of the engine's own, which it solves implicitly
    unequal_steps,  ///< its frames are not equally long
    resampled,      ///< its velocities change less often than its positions
    none,           ///< no map of the family made it
  };
  Kind kind = Kind::none;
  Rational dt = 0;                  ///< seconds
  std::string dt_source;            ///< "given", "time stamps", "velocities", "gravity", "one frame"
  std::size_t first = 0, last = 0;  ///< the rows that were explained: first <= i < last
  std::vector<Match> matches;       ///< that reproduce it, the best first
  std::vector<Match> nearest;       ///< the best of those that do not
  std::vector<Break> breaks;
  std::size_t candidates = 0;  ///< how many maps were tried
  int groups = 0;              ///< of different maps among the matches
  bool identifiable = false;   ///< one group
  bool bits = false;           ///< the log holds all bits of its numbers
  std::string advice;          ///< the experiment that tells the matches apart; why there is none
};

struct IdentifyOptions {
  std::optional<Rational> dt;
  std::optional<Rational> g;    ///< in the log's unit of length
  std::optional<int> up;        ///< axis
  std::vector<Candidate> only;  ///< these instead of all that are known
};

/// Holds every map that is known against a log.
///
/// throws  Undefined  when the body does not move;  BadInput
Identification identify(const Log& log, const IdentifyOptions& options = {});

}  // namespace shortfall
