// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/correction/geometric_flight.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// A frame of a flight and how high the body is when it ends.
struct Frame {
  Rational n;  ///< a whole number; frame 0 is the launch
  Surd height;
};

/// p0 + p1 n + p2 n^2.
template <class T>
T parabola_at(const std::array<T, 3>& p, const T& n) {
  return p[0] + n * (p[1] + n * p[2]);
}

/// How a body gets its launch velocity u: it is set; it is given as an impulse (over the mass), which some
/// engines treat differently; or as a force that is held over frames 1 to N (N = 1 unless said otherwise),
/// the acceleration u/(N dt) wherever the steps of these frames evaluate the force, and nowhere else.
enum class LaunchBy { velocity, impulse, force };

/// Where a body thrown straight up from the ground is at the end of every frame, exactly:
/// height(n) = launch * rise(n) - g * fall(n).
///
/// rise and fall are polynomials in n of degree 2 at most, so that frame one billion costs what frame one
/// does, or with damping sums with the powers of one number; where they have no such form, frames are stepped
/// exactly, up to a limit. No limit of the integrator acts and every `when` holds; what a function makes
/// irrational is rounded to 100 digits.
class Flight {
 public:
  /// Coefficients of 1, n, n^2.
  using Parabola = std::array<Rational, 3>;

  static constexpr int kStepped = 2000;      ///< how many frames are stepped where there is no closed form
  static constexpr int kForceFrames = 1000;  ///< the most frames over which a launching force is held

  /// param   dt  seconds a frame
  /// throws  BadInput  when dt is not positive, for a value of an unknown parameter, a wrong number of
  /// substeps, an impulse for a program that knows none, or force_frames out of 1..kForceFrames
  Flight(const Program& program, const Rational& dt, int substeps = 1, const Values& given = {},
         LaunchBy by = LaunchBy::velocity, int force_frames = 1);
  Flight(Flight&&) noexcept;
  Flight& operator=(Flight&&) noexcept;
  ~Flight();

  const Program& program() const { return program_; }  ///< substeps included
  const Rational& dt() const { return dt_; }
  int substeps() const { return substeps_; }
  const Values& parameters() const { return parameters_; }
  LaunchBy launch_by() const { return by_; }
  int force_frames() const { return force_frames_; }  ///< over how many frames a launching force is held
  /// What had to be rounded, "pow(9/10, 1/50)"; where there is something, nothing is exact.
  const std::vector<std::string>& rounded() const { return rounded_; }

  bool parabolic() const { return parabolic_; }
  const Parabola& rise() const { return rise_; }  ///< when parabolic, from frame settled() on
  const Parabola& fall() const { return fall_; }
  int settled() const { return settled_; }
  /// The sums of powers, when there is damping of one ratio.
  const std::optional<GeometricFlight>& geometric() const { return geometric_; }

  /// fall(n) with h and the parameters as letters, where the closed form was found in letters.
  const std::optional<Fraction>& fall_in_letters() const { return fall_in_letters_; }
  const std::vector<std::string>& letters() const { return letters_; }

  /// throws  Unable  past frame kStepped of a flight without a form
  Rational rise(const Rational& n) const;
  Rational fall(const Rational& n) const;
  Surd height(const Surd& launch, const Rational& g, const Rational& n) const;
  /// Coefficients of 1, n, n^2 of the height; when parabolic.
  std::array<Surd, 3> heights(const Surd& launch, const Rational& g) const;

  /// The highest frame until the body is back on the ground, the earliest when two are equally high.
  ///
  /// throws  Unable  when it is not back by frame kStepped of a flight without a form
  Frame highest(const Surd& launch, const Rational& g) const;

 private:
  struct Steps;
  bool adopt(const Tape& tape);
  bool fit();
  const std::pair<Rational, Rational>& stepped(const Rational& n) const;
  Frame highest_until(const Rational& last, const Surd& launch, const Rational& g) const;
  Frame highest_by_steps(const Surd& launch, const Rational& g) const;

  Program program_;
  Rational dt_;
  int substeps_;
  Values parameters_;
  LaunchBy by_;
  int force_frames_;
  std::vector<std::string> rounded_;
  std::optional<GeometricFlight> geometric_;
  bool parabolic_ = false;
  int settled_ = 0;
  Parabola rise_;
  Parabola fall_;
  std::optional<Fraction> fall_in_letters_;
  std::vector<std::string> letters_;
  std::unique_ptr<Steps> steps_;
};

}  // namespace shortfall
