// SPDX-License-Identifier: GPL-3.0-or-later
// An integrator as a class of each language. What varies stands between @; nothing is computed here.
#include "notebooks-export/code_class_template.hpp"

namespace shortfall {

namespace {

constexpr std::string_view kCsharpClass = R"code(// @about@
using System;

public sealed class @class@
{
    @constants@
    /// <summary>Position, velocity, time; the length of a step is not to be changed on the way.</summary>
    public float @members@;
    private readonly Func<float, float, float, float> acceleration;

    /// <summary>acceleration(x, v, t) is the force divided by the mass.</summary>
    public @class@(Func<float, float, float, float> acceleration, float x, float v, float dt, float t = 0.0f)
    {
        this.acceleration = acceleration;
        this.x = x;
        this.v = v;
        this.dt = dt;
        this.t = t;
        Begin();
    }

    private void Begin()
    {
        @start@
    }

    /// <summary>One step.</summary>
    public void Step()
    {
        @step@
        t = t + dt;
    }

    /// <summary>Position and velocity to be shown.</summary>
    public void ReadOut(out float position, out float velocity)
    {
        @finish@
        position = @position@;
        velocity = @velocity@;
    }

    /// <summary>Whether three steps do what they did in shortfall.</summary>
    public static bool SelfCheck()
    {
        var body = new @class@((x, v, t) => t - 2.0f * x - 0.25f * v, 0.5f, -0.75f, 0.1f);
        for (int k = 0; k < 3; ++k) body.Step();
        body.ReadOut(out float position, out float velocity);
        return Math.Abs(position - @x3@) <= 2e-6f && Math.Abs(velocity - @v3@) <= 2e-6f;
    }
}
)code";

constexpr std::string_view kCppClass = R"code(// @about@
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

/// acceleration(x, v, t) is the force divided by the mass.
template <class Acceleration>
class @class@ {
 public:
  @class@(Acceleration force, float x0, float v0, float step_length, float t0 = 0.0f)
      : x(x0), v(v0), dt(step_length), t(t0), acceleration(std::move(force)) {
    @start@
  }

  /// One step.
  void step() {
    @step@
    t = t + dt;
  }

  /// Position and velocity to be shown.
  std::pair<float, float> read_out() {
    @finish@
    return {@position@, @velocity@};
  }

  float x, v;      ///< what the steps go on from
  const float dt;  ///< the length of a step
  float t;
  @states@

 private:
  @constants@
  Acceleration acceleration;
};

/// Whether three steps do what they did in shortfall.
inline bool @function@_self_check() {
  const auto force = [](float x, float v, float t) { return t - 2.0f * x - 0.25f * v; };
  @class@<decltype(force)> body(force, 0.5f, -0.75f, 0.1f);
  for (int k = 0; k < 3; ++k) body.step();
  const auto [position, velocity] = body.read_out();
  return std::abs(position - @x3@) <= 2e-6f && std::abs(velocity - @v3@) <= 2e-6f;
}
)code";

constexpr std::string_view kGdscriptClass = R"code(# @about@
class_name @class@
@constants@

@members@
var dt: float # the length of a step, not to be changed on the way
var t: float


## The force divided by the mass: extend this class and write your own.
func acceleration(_x: float, _v: float, _t: float) -> float:
	return 0.0


## Puts the body where it begins.
func begin(x0: float, v0: float, step_length: float, t0: float = 0.0) -> void:
	x = x0
	v = v0
	dt = step_length
	t = t0
	@start@


## One step.
func step() -> void:
	@step@
	t = t + dt


## Position and velocity to be shown.
func read_out() -> Array:
	@finish@
	return [@position@, @velocity@]


## Whether three steps do what they did in shortfall, when acceleration is t - 2.0 * x - 0.25 * v.
func self_check() -> bool:
	begin(0.5, -0.75, 0.1)
	for _k in range(3):
		step()
	var shown := read_out()
	return abs(shown[0] - @x3@) <= 2e-6 and abs(shown[1] - @v3@) <= 2e-6
)code";

constexpr std::string_view kPythonClass = R"code(# @about@
from math import exp, isclose, sqrt
@constants@


class @class@:
    """acceleration(x, v, t) is the force divided by the mass; x and v are numbers or vectors."""

    def __init__(self, acceleration, x, v, dt, t=0.0):
        @start@
        self.acceleration, self.dt, self.t = acceleration, dt, t
        @pack@

    def step(self):
        """One step."""
        acceleration, dt, t = self.acceleration, self.dt, self.t
        @unpack@
        @step@
        @pack@
        self.t = t + dt

    def read_out(self):
        """Position and velocity to be shown."""
        acceleration, dt, t = self.acceleration, self.dt, self.t
        @unpack@
        @finish@
        return @position@, @velocity@


def self_check():
    """Whether three steps do what they did in shortfall."""
    body = @class@(lambda x, v, t: t - 2.0 * x - 0.25 * v, 0.5, -0.75, 0.1)
    for _ in range(3):
        body.step()
    position, velocity = body.read_out()
    return isclose(position, @x3@, abs_tol=1e-14) and isclose(velocity, @v3@, abs_tol=1e-14)


if __name__ == "__main__":
    assert self_check()
)code";

constexpr std::string_view kRustClass = R"code(// @about@
@constants@

/// acceleration(x, v, t) is the force divided by the mass.
pub struct @class@<A: Fn(f32, f32, f32) -> f32> {
    acceleration: A,
    pub x: f32,
    pub v: f32,
    dt: f32,
    pub t: f32,
    @states@
}

#[allow(unused_variables, unused_mut)]
impl<A: Fn(f32, f32, f32) -> f32> @class@<A> {
    pub fn new(acceleration: A, x: f32, v: f32, dt: f32) -> Self {
        let (mut x, mut v, t): (f32, f32, f32) = (x, v, 0.0);
        @start@
        Self { @fields@ }
    }

    /// One step.
    pub fn step(&mut self) {
        let acceleration = &self.acceleration;
        let (dt, t) = (self.dt, self.t);
        @unpack@
        @step@
        @pack@
        self.t = t + dt;
    }

    /// Position and velocity to be shown.
    pub fn read_out(&self) -> (f32, f32) {
        let acceleration = &self.acceleration;
        let (dt, t) = (self.dt, self.t);
        @unpack@
        @finish@
        (@position@, @velocity@)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_steps_do_what_they_did_in_shortfall() {
        let mut body = @class@::new(|x, v, t| t - 2.0 * x - 0.25 * v, 0.5, -0.75, 0.1);
        for _ in 0..3 {
            body.step();
        }
        let (position, velocity) = body.read_out();
        assert!((position - (@x3@)).abs() <= 2e-6 && (velocity - (@v3@)).abs() <= 2e-6);
    }
}
)code";

constexpr std::string_view kJavascriptClass = R"code(// @about@
@constants@

/** acceleration(x, v, t) is the force divided by the mass. */
class @class@ {
  constructor(acceleration, x, v, dt, t = 0) {
    @start@
    Object.assign(this, { acceleration, dt, t, @fields@ });
  }

  /** One step. */
  step() {
    let { acceleration, dt, t, @fields@ } = this;
    @step@
    Object.assign(this, { t: t + dt, @fields@ });
  }

  /** Position and velocity to be shown. */
  readOut() {
    const { acceleration, dt, t, @fields@ } = this;
    @finish@
    return [@position@, @velocity@];
  }
}

/** Whether three steps do what they did in shortfall. */
@class@.selfCheck = () => {
  const body = new @class@((x, v, t) => t - 2 * x - 0.25 * v, 0.5, -0.75, 0.1);
  for (let k = 0; k < 3; ++k) body.step();
  const [position, velocity] = body.readOut();
  return Math.abs(position - @x3@) <= 1e-14 && Math.abs(velocity - @v3@) <= 1e-14;
};

if (typeof module !== "undefined") module.exports = { @class@ };
)code";

}  // namespace

std::string_view class_template(Language language) {
  switch (language) {
    case Language::csharp:
      return kCsharpClass;
    case Language::cpp:
      return kCppClass;
    case Language::gdscript:
      return kGdscriptClass;
    case Language::python:
      return kPythonClass;
    case Language::rust:
      return kRustClass;
    case Language::javascript:
      return kJavascriptClass;
  }
  return {};
}

}  // namespace shortfall
