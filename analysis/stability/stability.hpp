// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/stability/amplification.hpp"
#include "analysis/stability/drag.hpp"
#include "analysis/stability/limit_motion.hpp"
#include "analysis/stability/stability_function.hpp"
#include "analysis/stability/windows.hpp"

namespace shortfall {

/// What is known exactly about the stability of an integrator.
///
/// Windows are in z = h w of the oscillator x'' = -w^2 x and in d = c h of drag x'' = -c v, h being the
/// frame.
struct Stability {
  std::string integrator;
  int substeps = 1;
  std::optional<Rational> dt;        ///< s, the frame that all is for; none when it holds for every frame
  std::vector<std::string> rounded;  ///< what was rounded to 100 digits; then nothing here is exact
  Values parameters;                 ///< the values that the windows are for
  std::vector<std::string> assumed;  ///< parameters that were not given: the windows are for their defaults
  Amplification undamped;            ///< of a frame; parameters that were not given stay letters
  Amplification numbers;             ///< of one substep, parameters as numbers
  bool of_substep = false;  ///< too many substeps for formulas of a frame: `undamped` is of one substep
  std::optional<Amplification> damped;  ///< of a frame, parameters as numbers
  Windows windows;
  std::optional<PowerGrowth> at_limit;      ///< none without a limit, or when the step does not exist there
  std::optional<LimitMotion> limit_motion;  ///< when the eigenvalues at the limit are rational
  Windows runaway;  ///< where the step stays bounded, in h q, though the motion x'' = q^2 x itself grows like
                    ///< exp(q t)
  std::optional<Drag> drag;                   ///< none when the step is singular with drag
  std::optional<StabilityFunction> function;  ///< of one substep
  std::optional<StabilityProperties> properties;

  /// The largest h w below which the motion is bounded; nullptr when there is no bound or no such window.
  const RealRoot* limit() const;
};

/// The most substeps for which formulas of a whole frame are written out.
inline constexpr int kSubstepsInFormulas = 8;

/// param   substeps  steps in a frame; h is the frame
/// param   dt        s, the frame, for a step that depends on h in another way than through h w and c h, as
///                   one does that damps by a number of its own; no letters are left then, and z = h w varies
///                   with w alone
/// throws  Unable  when the step depends on t, or without dt on h in another way;  Undefined when a stage is
/// singular
Stability stability(const Program& program, const Values& given = {}, int substeps = 1,
                    const std::optional<Rational>& dt = std::nullopt);

/// Windows in z = h w for claims and figures.
Windows oscillator_windows(const Program& program, const Values& given = {});
/// The same from an amplification matrix without damping whose letters, but for k, all stand for numbers.
Windows oscillator_windows(const Amplification& a);

/// The largest h w, for claims: none when it is stable for every h w; 0 when for no small one.
std::optional<RealRoot> stability_limit(const Program& program, const Values& given = {});
std::optional<RealRoot> stability_limit(const Windows& windows);

}  // namespace shortfall
