// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "analysis/trade/scene.hpp"

namespace shortfall {

/// The forces of the library, each written down once for numbers of any kind: those that a step runs on, and
/// those that record a tape.
///
/// Add to a[i] the acceleration of coordinate i.
template <class S>
struct ForceTerm {
  SceneForce::Kind kind;
  int d;  ///< dimension
  std::vector<int> bodies;
  std::vector<S> p;       ///< the numbers of the force
  std::vector<S> masses;  ///< of all bodies
  S one, two;
  bool damped = false;    ///< a spring or link with a damper beside it
  bool has_rest = false;  ///< a spring of a natural length other than 0

  void add(const S* x, const S* v, const S& t, S* a) const {
    if (kind == SceneForce::Kind::n_body) return add_n_body(x, a);
    if (kind == SceneForce::Kind::link) return add_link(x, v, a);
    for (int b : bodies) add_one(x + b * d, v + b * d, t, a + b * d);
  }

  /// What this force adds to the energy, masses included; none when it has no potential.
  std::optional<S> potential(const S* x) const {
    using Kind = SceneForce::Kind;
    if (kind == Kind::n_body) return n_body_potential(x);
    if (kind == Kind::link) return link_potential(x);
    std::optional<S> sum;
    for (int b : bodies) {
      const std::optional<S> one_body = potential_of_one(x + b * d);
      if (!one_body) return std::nullopt;
      const S weighted = masses[b] * *one_body;
      sum = sum ? *sum + weighted : weighted;
    }
    return sum;
  }

 private:
  using Three = std::array<S, 3>;

  S squared_length(const S* u) const {
    S sum = u[0] * u[0];
    for (int i = 1; i < d; ++i) sum = sum + u[i] * u[i];
    return sum;
  }
  /// On a line |u|, whose sign is known where sqrt(u u) has none.
  S length(const S* u) const {
    using std::abs;
    using std::sqrt;
    return d == 1 ? S(abs(u[0])) : S(sqrt(squared_length(u)));
  }
  Three in_space(const S* u) const {
    const S zero = one - one;
    return {u[0], d > 1 ? u[1] : zero, d > 2 ? u[2] : zero};
  }
  static Three cross(const S* w, const Three& u) {
    return {w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
  }

  void add_one(const S* x, const S* v, const S& t, S* a) const {
    using std::sin;
    using Kind = SceneForce::Kind;
    std::array<S, 3> u{one, one, one};
    switch (kind) {
      case Kind::constant:
        for (int i = 0; i < d; ++i) a[i] = a[i] + p[i];
        break;
      case Kind::polynomial: {
        const int degree = static_cast<int>(p.size()) / d - 1;
        for (int i = 0; i < d; ++i) {
          S value = p[degree * d + i];
          for (int k = degree - 1; k >= 0; --k) value = value * t + p[k * d + i];
          a[i] = a[i] + value;
        }
        break;
      }
      case Kind::linear_drag:
        for (int i = 0; i < d; ++i) a[i] = a[i] - p[0] * (v[i] - p[1 + i]);
        break;
      case Kind::quadratic_drag: {
        for (int i = 0; i < d; ++i) u[i] = v[i] - p[1 + i];
        const S strength = p[0] * length(u.data());
        for (int i = 0; i < d; ++i) a[i] = a[i] - strength * u[i];
        break;
      }
      case Kind::spring:
        add_spring(x, v, a);
        break;
      case Kind::pendulum:
        a[0] = a[0] - p[0] * sin(x[0]);
        break;
      case Kind::kepler: {
        for (int i = 0; i < d; ++i) u[i] = x[i] - p[1 + i];
        const S r = length(u.data());
        const S pull = p[0] / (r * r * r);
        for (int i = 0; i < d; ++i) a[i] = a[i] - pull * u[i];
        break;
      }
      case Kind::height: {
        const S ratio = p[1] / (p[1] + x[d - 1]);
        a[d - 1] = a[d - 1] - p[0] * (ratio * ratio);
        break;
      }
      case Kind::lorentz: {
        const Three turn = cross(p.data() + d, in_space(v));  // B x v = -(v x B)
        for (int i = 0; i < d; ++i) a[i] = a[i] + (p[i] - turn[i]);
        break;
      }
      case Kind::coriolis: {
        const Three turn = cross(p.data(), in_space(v));
        const Three outward = cross(p.data(), cross(p.data(), in_space(x)));
        for (int i = 0; i < d; ++i) a[i] = a[i] - (two * turn[i] + p[3] * outward[i]);
        break;
      }
      default:
        break;
    }
  }

  std::optional<S> potential_of_one(const S* x) const {
    using std::cos;
    using Kind = SceneForce::Kind;
    const S half = one / two;
    std::array<S, 3> u{one, one, one};
    switch (kind) {
      case Kind::constant: {
        S work = p[0] * x[0];
        for (int i = 1; i < d; ++i) work = work + p[i] * x[i];
        return -work;
      }
      case Kind::spring: {
        if (damped) return std::nullopt;
        for (int i = 0; i < d; ++i) u[i] = x[i] - p[2 + i];
        if (!has_rest) return half * p[0] * squared_length(u.data());
        const S longer = length(u.data()) - p[2 + d];
        return half * p[0] * (longer * longer);
      }
      case Kind::pendulum:
        return -(p[0] * cos(x[0]));
      case Kind::kepler:
        for (int i = 0; i < d; ++i) u[i] = x[i] - p[1 + i];
        return -(p[0] / length(u.data()));
      case Kind::height:
        return -(p[0] * (p[1] * p[1]) / (p[1] + x[d - 1]));
      case Kind::lorentz: {  // the magnetic field does no work
        S work = p[0] * x[0];
        for (int i = 1; i < d; ++i) work = work + p[i] * x[i];
        return -work;
      }
      case Kind::coriolis: {
        const Three turned = cross(p.data(), in_space(x));
        return -(half * p[3] * (turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2]));
      }
      default:
        return std::nullopt;
    }
  }

  std::optional<S> link_potential(const S* x) const {
    if (damped) return std::nullopt;
    std::array<S, 3> u{one, one, one};
    for (int i = 0; i < d; ++i) u[i] = x[bodies[1] * d + i] - x[bodies[0] * d + i];
    const S longer = (d == 1 ? u[0] : length(u.data())) - p[2];
    return one / two * p[0] * (longer * longer);
  }

  S n_body_potential(const S* x) const {
    const int count = static_cast<int>(masses.size());
    std::array<S, 3> u{one, one, one};
    S sum = one - one;
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j) {
        for (int c = 0; c < d; ++c) u[c] = x[j * d + c] - x[i * d + c];
        sum = sum - p[0] * masses[i] * masses[j] / length(u.data());
      }
    return sum;
  }

  void add_spring(const S* x, const S* v, S* a) const {
    const S *k = &p[0], *c = &p[1], *anchor = &p[2], *rest = &p[2 + d];
    std::array<S, 3> u{one, one, one};
    for (int i = 0; i < d; ++i) u[i] = x[i] - anchor[i];
    if (!has_rest) {
      for (int i = 0; i < d; ++i) a[i] = a[i] - (*k * u[i] + *c * v[i]);
      return;
    }
    const S r = length(u.data());
    S along = u[0] * v[0];
    for (int i = 1; i < d; ++i) along = along + u[i] * v[i];
    const S pull = (*k * (r - *rest) + *c * along / r) / r;
    for (int i = 0; i < d; ++i) a[i] = a[i] - pull * u[i];
  }

  void add_link(const S* x, const S* v, S* a) const {
    const int first = bodies[0], second = bodies[1];
    std::array<S, 3> u{one, one, one}, w{one, one, one};
    for (int i = 0; i < d; ++i) {
      u[i] = x[second * d + i] - x[first * d + i];
      w[i] = v[second * d + i] - v[first * d + i];
    }
    std::array<S, 3> force = u;
    if (d == 1) {  // along the line, with its sign: bodies do not change places
      force[0] = p[0] * (u[0] - p[2]) + p[1] * w[0];
    } else {
      const S r = length(u.data());
      S along = u[0] * w[0];
      for (int i = 1; i < d; ++i) along = along + u[i] * w[i];
      const S pull = (p[0] * (r - p[2]) + p[1] * along / r) / r;
      for (int i = 0; i < d; ++i) force[i] = pull * u[i];
    }
    for (int i = 0; i < d; ++i) {
      a[first * d + i] = a[first * d + i] + force[i] / masses[first];
      a[second * d + i] = a[second * d + i] - force[i] / masses[second];
    }
  }

  void add_n_body(const S* x, S* a) const {
    const int count = static_cast<int>(masses.size());
    std::array<S, 3> u{one, one, one};
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j) {
        for (int c = 0; c < d; ++c) u[c] = x[j * d + c] - x[i * d + c];
        const S r = length(u.data());
        const S pull = p[0] / (r * r * r);
        for (int c = 0; c < d; ++c) {
          const S f = pull * u[c];
          a[i * d + c] = a[i * d + c] + masses[j] * f;
          a[j * d + c] = a[j * d + c] - masses[i] * f;
        }
      }
  }
};

}  // namespace shortfall
