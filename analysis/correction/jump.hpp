// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/jump_binary32.hpp"
#include "analysis/correction/jump_flight.hpp"
#include "analysis/correction/jump_launch.hpp"
#include "analysis/correction/jump_limits.hpp"

namespace shortfall {

/// A jump that a game wants: the body gets the launch velocity sqrt(2 g H), which in exact motion takes it to
/// H.
struct JumpQuestion {
  Rational height;                  ///< H, metres
  Rational dt = Rational(1, 50);    ///< seconds a frame
  Rational g = Rational(981, 100);  ///< metres per second squared, positive downwards
  int substeps = 1;
  Values parameters = {};
  std::int64_t binary32_frames = kBinary32Frames;  ///< how many the search in binary32 may step; 0: no search
  LaunchBy by = LaunchBy::velocity;
  int force_frames = 1;  ///< of a launch by a force: how many frames it is held over
};

/// Exact minus computed, metres: positive where the body stays too low. total = damping + method + sampling.
///
/// The exact motion is the one that the integrator is meant to follow: a parabola, or with drag when the
/// program says so (`solves`); with drag exponentials are rounded to 100 digits, and so is what is here.
struct JumpShortfall {
  Surd total;     ///< H - height of the highest frame
  Surd method;    ///< what the integrator loses: exact motion at the time of that frame - its height
  Surd sampling;  ///< what falls between frames: top of the exact motion - exact motion at that time
  Surd damping;   ///< what drag takes: H - top of the exact motion; 0 without drag
};

/// A launch that puts the top of the jump exactly on a frame.
struct OnFrame {
  Rational launch;  ///< metres per second
  Frame top;        ///< its height is H
};

/// What becomes of a jump, in exact arithmetic.  "Peak" has four meanings, all here: the target, the height
/// at the ideal time, the top of the parabola, the highest frame.
struct Jump {
  std::string integrator;
  int substeps = 1;
  Rational dt;
  Rational g;
  Values parameters;  ///< of the integrator, all of them
  LaunchBy by = LaunchBy::velocity;
  int force_frames = 1;              ///< of a launch by a force
  Rational drag;                     ///< of the motion that is meant, per second; 0 for none
  std::vector<std::string> rounded;  ///< what was rounded to 100 digits; then nothing here is exact

  Surd launch_velocity;                   ///< sqrt(2 g H)
  Rational target;                        ///< H
  Surd ideal_time;                        ///< when the exact motion is at its top; seconds
  Surd exact_top;                         ///< which is there: H, or less with drag
  std::optional<Surd> ideal_time_height;  ///< the computed motion then, between frames by its own formula
  std::optional<Surd> parabola_top;       ///< of the parabola through the frames
  /// Of a launch by a force, without drag: the launch that takes the exact motion to H, which rises under the
  /// force for T = force_frames dt: g T/2 + sqrt((g T/2)^2 + 2 g H).
  std::optional<Surd> exact_force_launch;
  /// The launch whose parabola has its top at H, where no correction serves every launch.
  std::optional<Surd> launch_for_top;
  Frame best_frame;  ///< the highest; {0, 0} when the body stays on the ground
  bool tie = false;  ///< whether the next frame is exactly as high
  JumpShortfall shortfall;
  std::optional<LimitMet> limit;  ///< of that flight
  std::string limit_unknown;      ///< why it is not known whether one acts

  bool lifts_off = false;
  LiftOff lift_off;

  LaunchCorrection correction;
  struct Corrected {
    Surd launch;
    Frame best_frame;
    JumpShortfall shortfall;
    bool exact_at_every_frame = false;  ///< whether it is the exact motion, sampled
  };
  std::optional<Corrected> corrected;

  std::optional<OnFrame> on_frame;
  std::string no_on_frame;                 ///< why there is none
  std::optional<LimitMet> on_frame_limit;  ///< of the flight on a frame
  std::optional<Binary32Launch> binary32;
  std::string no_binary32;  ///< why there is none

  /// Of the force over the mass that stands for a launch; metres per second squared.
  Surd force_of(const Surd& launch) const { return launch / Surd(dt * force_frames); }
};

/// throws  BadInput  when height, dt or g is not positive, for a value of an unknown parameter, a wrong
/// number of
///                   substeps, an impulse where there is none;  Unable  when the flight has no closed form
///                   and is too long to be stepped
Jump jump(const Program& program, const JumpQuestion& question);

/// The same for one of many heights: program, dt, substeps and parameters are those of the flight.
Jump jump(const Flight& flight, const Rational& height, const Rational& g,
          std::int64_t binary32_frames = kBinary32Frames);

/// The launch whose frame m is exactly H high and the highest, for the one m that has it.
///
/// Searched for from the frame nearest to the ideal time, by whether too early a frame is passed by later
/// ones, or the reverse.
std::optional<OnFrame> on_frame(const Flight& flight, const Rational& height, const Rational& g);

}  // namespace shortfall
