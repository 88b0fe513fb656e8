// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/program/tape.hpp"

namespace shortfall {

/// A vector as a combination of what it was made of, in binary64.
struct Combination {
  static constexpr std::size_t kMost = 20;
  std::array<double, kMost> part{};

  static Combination unit(std::size_t i) {
    Combination c;
    c.part.at(i) = 1;
    return c;
  }
  Combination operator-() const {
    return each([](double a) { return -a; });
  }
  friend Combination operator*(double s, const Combination& a) {
    return a.each([s](double x) { return s * x; });
  }
  friend Combination operator/(const Combination& a, double s) {
    return a.each([s](double x) { return x / s; });
  }
  friend Combination operator+(Combination a, const Combination& b) {
    for (std::size_t i = 0; i < kMost; ++i) a.part[i] += b.part[i];
    return a;
  }
  friend Combination operator-(Combination a, const Combination& b) {
    for (std::size_t i = 0; i < kMost; ++i) a.part[i] -= b.part[i];
    return a;
  }

 private:
  template <class F>
  Combination each(F f) const {
    Combination result;
    for (std::size_t i = 0; i < kMost; ++i) result.part[i] = f(part[i]);
    return result;
  }
};

/// What acts on the body besides the integrator: x'' = A - k x - c v, and the number that the integrator's
/// own parameter c has.
struct Circumstances {
  double dt = 0.02;
  double k = 0;
  double own_c = 0;  ///< given to the parameter c; read only when `has_own_c`
  bool has_own_c = false;
  double drag = 0;   ///< as a force
  int substeps = 1;  ///< steps of dt/substeps in one frame
};

/// One frame of an integrator as a map, from one run of its program: where no limit acts, it is affine in
/// what it carries and in the constant part A of the acceleration.
///
/// Columns: the carried vectors, then A, then an impulse (divided by the mass) that acts in the first frame.
struct FrameMap {
  int states = 2;
  std::vector<Combination> start;  ///< the carried vectors of x0, v0 (columns 0, 1) and A
  std::vector<Combination> first;  ///< the first frame, where an impulse acts
  std::vector<Combination> step;   ///< every other one
  Combination position, velocity;  ///< what is read out

  std::size_t constant() const { return static_cast<std::size_t>(states); }
  std::size_t impulse() const { return static_cast<std::size_t>(states) + 1; }
};

/// throws  Undefined  when a stage is singular;  Unable  when it carries or solves for too much
FrameMap frame_map(const Tape& tape, const Circumstances& circumstances);

/// How position and velocity at each frame depend on x0, v0, A and an impulse j: x = row . (x0, v0, A, j).
struct Responses {
  using Row = std::array<double, 4>;
  std::vector<Row> position, velocity;  ///< of frames 0, 1, ...
};

Responses responses(const FrameMap& map, std::size_t frames);

}  // namespace shortfall
