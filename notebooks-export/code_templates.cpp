// SPDX-License-Identifier: GPL-3.0-or-later
// The corrected jump as a file of each language. What varies stands between @; nothing is computed here.
#include "notebooks-export/code_template.hpp"

namespace shortfall {

namespace {

constexpr std::string_view kCsharpJump = R"code(// @about@
using System;

public static class Jump
{
    @constants@
    /// <summary>Upward launch velocity (m/s) of a jump to a height (m).</summary>
    public static float LaunchVelocity(float height, float gravity = @g@@dt_parameter@)
    {
        @correction@
        return (float)Math.Sqrt(2.0f * gravity * height)@plus_correction@;
    }

    /// <summary>The one that puts the top of the jump on a frame: the highest frame is at the height itself.</summary>
    public static float OnFrameLaunchVelocity(float height, float gravity = @g@, float dt = @dt@)
    {
        float frames = (float)Math.Max(1.0, Math.Ceiling(Math.Sqrt(2.0 * height / (gravity * dt * dt) + 0.25) - 0.5));
        @correction@
        return height / (frames * dt) + 0.5f * gravity * frames * dt@plus_correction@;
    }

    /// <summary>Height (m) of the highest frame after a launch: the step that this is for.</summary>
    public static float HighestFrame(float launch, float gravity = @g@, float dt = @dt@)
    {
        float a = -gravity;
        float x = 0.0f;
        float v = launch;
        @start@
        float top = 0.0f;
        while (true)
        {
            @step@
            if (!(@position@ > top)) return top;
            top = @position@;
        }
    }

    /// <summary>Whether both launches do what they promise, in float.</summary>
    public static bool SelfCheck(float gravity = @g@, float dt = @dt@)
    {
        foreach (float height in new[] { @heights@ })
        {
            float tolerance = @tolerance@ * (height + gravity * dt * dt);
            float between = 0.125f * gravity * dt * dt; // what may fall between two frames
            float top = HighestFrame(LaunchVelocity(height, gravity@dt_argument@), gravity, dt);
            if (!(top < height + tolerance && top > height - between - tolerance)) return false;
            top = HighestFrame(OnFrameLaunchVelocity(height, gravity, dt), gravity, dt);
            if (!(Math.Abs(top - height) < tolerance)) return false;
        }
        return true;
    }
}
)code";

constexpr std::string_view kCppJump = R"code(// @about@
#pragma once

#include <algorithm>
#include <cmath>

namespace jump {
@constants@

/// Upward launch velocity (m/s) of a jump to a height (m).
inline float launch_velocity(float height, float gravity = @g@@dt_parameter@) {
  @correction@
  return std::sqrt(2.0f * gravity * height)@plus_correction@;
}

/// The one that puts the top of the jump on a frame: the highest frame is at the height itself.
inline float on_frame_launch_velocity(float height, float gravity = @g@, float dt = @dt@) {
  const float frames = std::max(1.0f, std::ceil(std::sqrt(2.0f * height / (gravity * dt * dt) + 0.25f) - 0.5f));
  @correction@
  return height / (frames * dt) + 0.5f * gravity * frames * dt@plus_correction@;
}

/// Height (m) of the highest frame after a launch: the step that this is for.
inline float highest_frame(float launch, float gravity = @g@, float dt = @dt@) {
  const float a = -gravity;
  float x = 0.0f;
  float v = launch;
  @start@
  float top = 0.0f;
  while (true) {
    @step@
    if (!(@position@ > top)) return top;
    top = @position@;
  }
}

/// Whether both launches do what they promise, in float.
inline bool self_check(float gravity = @g@, float dt = @dt@) {
  for (const float height : {@heights@}) {
    const float tolerance = @tolerance@ * (height + gravity * dt * dt);
    const float between = 0.125f * gravity * dt * dt;  // what may fall between two frames
    float top = highest_frame(launch_velocity(height, gravity@dt_argument@), gravity, dt);
    if (!(top < height + tolerance && top > height - between - tolerance)) return false;
    top = highest_frame(on_frame_launch_velocity(height, gravity, dt), gravity, dt);
    if (!(std::abs(top - height) < tolerance)) return false;
  }
  return true;
}

}  // namespace jump
)code";

constexpr std::string_view kGdscriptJump = R"code(# @about@
class_name Jump
@constants@


## Upward launch velocity (m/s) of a jump to a height (m).
static func launch_velocity(height: float, gravity: float = @g@@dt_parameter@) -> float:
	@correction@
	return sqrt(2.0 * gravity * height)@plus_correction@


## The one that puts the top of the jump on a frame: the highest frame is at the height itself.
static func on_frame_launch_velocity(height: float, gravity: float = @g@, dt: float = @dt@) -> float:
	var frames: float = max(1.0, ceil(sqrt(2.0 * height / (gravity * dt * dt) + 0.25) - 0.5))
	@correction@
	return height / (frames * dt) + 0.5 * gravity * frames * dt@plus_correction@


## Height (m) of the highest frame after a launch: the step that this is for.
static func highest_frame(launch: float, gravity: float = @g@, dt: float = @dt@) -> float:
	var a := -gravity
	var x := 0.0
	var v := launch
	@start@
	var top := 0.0
	while true:
		@step@
		if not @position@ > top:
			break
		top = @position@
	return top


## Whether both launches do what they promise.
static func self_check(gravity: float = @g@, dt: float = @dt@) -> bool:
	for height in [@heights@]:
		var tolerance: float = @tolerance@ * (height + gravity * dt * dt)
		var between := 0.125 * gravity * dt * dt # what may fall between two frames
		var top := highest_frame(launch_velocity(height, gravity@dt_argument@), gravity, dt)
		if not (top < height + tolerance and top > height - between - tolerance):
			return false
		top = highest_frame(on_frame_launch_velocity(height, gravity, dt), gravity, dt)
		if not abs(top - height) < tolerance:
			return false
	return true
)code";

constexpr std::string_view kPythonJump = R"code(# @about@
from math import ceil@exp@, sqrt
@constants@


def launch_velocity(height, gravity=@g@@dt_parameter@):
    """Upward launch velocity (m/s) of a jump to a height (m)."""
    @correction@
    return sqrt(2 * gravity * height)@plus_correction@


def on_frame_launch_velocity(height, gravity=@g@, dt=@dt@):
    """The one that puts the top of the jump on a frame: the highest frame is at the height itself."""
    frames = max(1, ceil(sqrt(2 * height / (gravity * dt * dt) + 0.25) - 0.5))
    @correction@
    return height / (frames * dt) + 0.5 * gravity * frames * dt@plus_correction@


def highest_frame(launch, gravity=@g@, dt=@dt@):
    """Height (m) of the highest frame after a launch: the step that this is for."""
    a = -gravity
    x = 0.0
    v = launch
    @start@
    top = 0.0
    while True:
        @step@
        if not @position@ > top:
            return top
        top = @position@


def self_check(gravity=@g@, dt=@dt@):
    """Whether both launches do what they promise."""
    for height in (@heights@):
        tolerance = @tolerance@ * (height + gravity * dt * dt)
        between = 0.125 * gravity * dt * dt  # what may fall between two frames
        top = highest_frame(launch_velocity(height, gravity@dt_argument@), gravity, dt)
        if not height - between - tolerance < top < height + tolerance:
            return False
        top = highest_frame(on_frame_launch_velocity(height, gravity, dt), gravity, dt)
        if not abs(top - height) < tolerance:
            return False
    return True


if __name__ == "__main__":
    assert self_check()
)code";

constexpr std::string_view kRustJump = R"code(// @about@
@constants@

/// Upward launch velocity (m/s) of a jump to a height (m).
pub fn launch_velocity(height: f32, gravity: f32@dt_parameter@) -> f32 {
    @correction@
    (2.0 * gravity * height).sqrt()@plus_correction@
}

/// The one that puts the top of the jump on a frame: the highest frame is at the height itself.
pub fn on_frame_launch_velocity(height: f32, gravity: f32, dt: f32) -> f32 {
    let frames = ((2.0 * height / (gravity * dt * dt) + 0.25).sqrt() - 0.5).ceil().max(1.0);
    @correction@
    height / (frames * dt) + 0.5 * gravity * frames * dt@plus_correction@
}

/// Height (m) of the highest frame after a launch: the step that this is for.
pub fn highest_frame(launch: f32, gravity: f32, dt: f32) -> f32 {
    let a: f32 = -gravity;
    let mut x: f32 = 0.0;
    let @mut@v: f32 = launch;
    @start@
    let mut top: f32 = 0.0;
    loop {
        @step@
        if !(@position@ > top) {
            return top;
        }
        top = @position@;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_launches_do_what_they_promise() {
        let (gravity, dt): (f32, f32) = (@g@, @dt@);
        for height in [@heights@] {
            let height: f32 = height;
            let tolerance = @tolerance@ * (height + gravity * dt * dt);
            let between = 0.125 * gravity * dt * dt; // what may fall between two frames
            let top = highest_frame(launch_velocity(height, gravity@dt_argument@), gravity, dt);
            assert!(top < height + tolerance && top > height - between - tolerance);
            let top = highest_frame(on_frame_launch_velocity(height, gravity, dt), gravity, dt);
            assert!((top - height).abs() < tolerance);
        }
    }
}
)code";

constexpr std::string_view kJavascriptJump = R"code(// @about@
@constants@

/** Upward launch velocity (m/s) of a jump to a height (m). */
function launchVelocity(height, gravity = @g@@dt_parameter@) {
  @correction@
  return Math.sqrt(2 * gravity * height)@plus_correction@;
}

/** The one that puts the top of the jump on a frame: the highest frame is at the height itself. */
function onFrameLaunchVelocity(height, gravity = @g@, dt = @dt@) {
  const frames = Math.max(1, Math.ceil(Math.sqrt(2 * height / (gravity * dt * dt) + 0.25) - 0.5));
  @correction@
  return height / (frames * dt) + 0.5 * gravity * frames * dt@plus_correction@;
}

/** Height (m) of the highest frame after a launch: the step that this is for. */
function highestFrame(launch, gravity = @g@, dt = @dt@) {
  const a = -gravity;
  let x = 0;
  let v = launch;
  @start@
  let top = 0;
  while (true) {
    @step@
    if (!(@position@ > top)) return top;
    top = @position@;
  }
}

/** Whether both launches do what they promise. */
function selfCheck(gravity = @g@, dt = @dt@) {
  return [@heights@].every((height) => {
    const tolerance = @tolerance@ * (height + gravity * dt * dt);
    const between = 0.125 * gravity * dt * dt; // what may fall between two frames
    const top = highestFrame(launchVelocity(height, gravity@dt_argument@), gravity, dt);
    const onFrame = highestFrame(onFrameLaunchVelocity(height, gravity, dt), gravity, dt);
    return top < height + tolerance && top > height - between - tolerance && Math.abs(onFrame - height) < tolerance;
  });
}

if (typeof module !== "undefined") module.exports = { launchVelocity, onFrameLaunchVelocity, highestFrame, selfCheck };
)code";

}  // namespace

std::string_view jump_template(Language language) {
  switch (language) {
    case Language::csharp:
      return kCsharpJump;
    case Language::cpp:
      return kCppJump;
    case Language::gdscript:
      return kGdscriptJump;
    case Language::python:
      return kPythonJump;
    case Language::rust:
      return kRustJump;
    case Language::javascript:
      return kJavascriptJump;
  }
  return {};
}

}  // namespace shortfall
