// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/frame_flight.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/motion/variable_steps.hpp"

namespace shortfall {

/// A jump whose frames have lengths of their own.
struct FrameJumpQuestion {
  Rational height;              ///< H, metres
  std::vector<Rational> steps;  ///< seconds
  bool repeat = false;          ///< whether the list begins anew when it is over
  Rational g = Rational(981, 100);
  int substeps = 1;
  Values parameters = {};
  Rational fixed_dt = Rational(1, 50);  ///< step of the accumulator that is offered instead
};

/// A frame of the jump, positions in metres.
struct JumpedFrame {
  Rational t;      ///< seconds
  Rational h;      ///< its length, seconds
  Surd height;     ///< computed
  Surd exact;      ///< the exact motion then
  Surd shortfall;  ///< exact - height
};

/// Frames which begin alike and then need different launches: so no launch that is chosen beforehand is right
/// for both.
struct LaunchCounterExample {
  struct Ending {
    std::vector<Rational> steps;  ///< what follows after the common beginning, seconds
    Rational t;                   ///< when it is over
    Surd needed;                  ///< what the launch needs added for the last frame to be exact, m/s
  };
  std::size_t beginning = 0;  ///< how many frames of the list both begin with
  Ending one;
  Ending other;
};

/// The same game with a fixed step and an accumulator: a frame takes as many fixed steps as fit into the time
/// that has passed, and what is left waits for the next frame.
struct AccumulatorJump {
  Rational dt;
  LaunchCorrection correction;  ///< known beforehand, since all steps are equal
  std::size_t frame = 0;        ///< the drawn frame that is the highest
  Rational steps;               ///< fixed steps taken by then
  Surd height;
  Surd shortfall;  ///< H - height; all of it sampling when the correction exists
};

/// What becomes of a jump over a list of frames, in exact arithmetic.
struct FrameJump {
  /// landed: back on the ground; falling: the list is over while the body falls; rising: it is over before
  /// the top, and then best_frame is only the highest so far.
  enum class End { landed, falling, rising };

  std::string integrator;
  int substeps = 1;
  Rational g;
  Rational target;
  Surd launch_velocity;             ///< sqrt(2 g H)
  Surd ideal_time;                  ///< launch / g, when the exact motion is at H
  std::vector<JumpedFrame> frames;  ///< frame 0 is the launch
  End end = End::landed;
  bool top_is_certain = true;  ///< when falling: whether no further frame can be higher (proved)
  Frame best_frame;
  bool tie = false;
  bool lifts_off = false;
  JumpShortfall shortfall;
  LiftOff lift_off;  ///< H above which frame 1 is above the ground

  VariableSteps steps;               ///< the law in letters
  ListExactness exactness;           ///< with the values of the parameters
  std::vector<Expr> unrolled;        ///< shortfalls of the first frames in letters, where there is no law
  bool equal_steps = false;          ///< whether all frames of the list are equal
  std::size_t longest = 0;           ///< the longest frame up to the best one
  std::optional<Surd> longest_cost;  ///< of the method's shortfall, what that frame alone is to blame for

  std::optional<Surd> hindsight;  ///< what the launch needed added for the best frame to be exact
  std::optional<LaunchCounterExample> counter_example;

  struct Corrected {
    Program program;
    Expr added;  ///< to x at the end of each frame, in a and h
    Frame best_frame;
    JumpShortfall shortfall;
    bool exact_at_every_frame = false;  ///< compared, frame by frame; for every list it is proved
  };
  std::optional<Corrected> term;  ///< with x += (1/2 - alpha) a h^2 in every frame
  std::string no_term;            ///< why there is none
  std::optional<AccumulatorJump> accumulator;
};

/// throws  BadInput  for a height, gravity or step that is not positive, parameters or substeps that lower
/// refuses;  Unable  when the body is not back on the ground after FrameFlight::kMost frames
FrameJump jump(const Program& program, const FrameJumpQuestion& question);

/// Which integrators of the catalogue are exact for every list of frames.
std::vector<ListExactness> catalogue_exactness();

}  // namespace shortfall
