// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/bit_run.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/near_root.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

namespace {

/// One body in space under gravity, a constant force and a spring, in an engine's own arithmetic.
template <class S, class C>
struct EngineBody {
  using Scalar = S;
  using Vector = Components<S, C>;

  const EngineFlight& flight;
  int own_c;

  Scalar number(const Rational& value) const {
    if constexpr (std::is_same_v<S, float>)
      return value.to_float();
    else
      return value.to_double();
  }
  std::optional<Scalar> parameter(int index, bool) const {
    if (index == own_c) return static_cast<S>(flight.c);
    return std::nullopt;
  }
  Vector zero() const { return {}; }
  static Vector vector(const Log::Triple& values) {
    return Vector({static_cast<C>(values[0]), static_cast<C>(values[1]), static_cast<C>(values[2])});
  }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar&) const {
    typename Vector::Parts force{};
    for (std::size_t i = 0; i < 3; ++i) {
      // A user computes his forces in binary64 and hands them over.
      double f = flight.force[i];
      if (flight.k != 0) f -= flight.k * (x.parts()[i] - flight.rest[i]);
      if (own_c < 0 && flight.c != 0) f -= flight.c * v.parts()[i];
      force[i] = static_cast<C>(static_cast<S>(f));
    }
    return Vector(vector(flight.gravity).parts(), force, flight.adding);
  }
  Scalar function(Function f, Scalar a, Scalar b) const { return value_of(f, a, b); }
  Scalar root(const RealRoot& root, const std::string&) const {
    return number(root.is_rational() ? root.rational() : near(root, kRoundedRootDigits));
  }
  bool longer(const Vector& measured, Scalar size, bool) const { return norm(measured) > size; }
  Vector shortened(const Vector& v, const Vector& measured, Scalar size) const {
    return size / norm(measured) * v;
  }
  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    throw Unable("a frame of an engine solves no implicit stage");
  }
};

template <class Vector>
Log::Triple doubles(const Vector& v) {
  return {static_cast<double>(v.parts()[0]), static_cast<double>(v.parts()[1]),
          static_cast<double>(v.parts()[2])};
}

template <class S, class C, class See>
void fly_in(const Candidate& candidate, const std::vector<std::size_t>& frames, double dt,
            const EngineFlight& flight, See&& see) {
  EngineBody<S, C> body{flight, -1};
  if (candidate.own_damping)
    for (std::size_t i = 0; i < candidate.tape->parameters.size(); ++i)
      if (candidate.tape->parameters[i].name == "c") body.own_c = static_cast<int>(i);
  S h = static_cast<S>(dt);
  if (candidate.substeps > 1) h = h / static_cast<S>(candidate.substeps);
  Run<EngineBody<S, C>> run(*candidate.tape, body, h);
  run.begin(body.vector(flight.x0), body.vector(flight.v0), S(0));
  if (flight.launch == Launch::impulse) run.give_impulse(body.vector(flight.impulse));
  std::size_t frame = 0;
  for (std::size_t row = 0; row < frames.size(); ++row) {
    for (; frame < frames[row]; ++frame)
      for (int k = 0; k < candidate.substeps; ++k) run.step();
    const auto [x, v] = run.read_out();
    if (!see(row, doubles(x), doubles(v))) return;
  }
}

template <class See>
void fly_so(const Candidate& candidate, const std::vector<std::size_t>& frames, double dt,
            const EngineFlight& flight, See&& see) {
  switch (flight.arithmetic) {
    case Arithmetic::binary32:
      return fly_in<float, float>(candidate, frames, dt, flight, see);
    case Arithmetic::binary64:
      return fly_in<double, double>(candidate, frames, dt, flight, see);
    case Arithmetic::binary64_stored_32:
      return fly_in<double, float>(candidate, frames, dt, flight, see);
  }
}

}  // namespace

void fly(const Candidate& candidate, const std::vector<std::size_t>& frames, double dt,
         const EngineFlight& flight,
         const std::function<bool(std::size_t, const Log::Triple&, const Log::Triple&)>& see) {
  fly_so(candidate, frames, dt, flight, see);
}

Comparison compare(const Candidate& candidate, const Observations& o, const EngineFlight& flight, int only,
                   bool whole) {
  Comparison result;
  const double x_unit = 2 * o.half_position(o.largest_position());
  const double v_unit = o.velocities ? 2 * o.half_velocity(o.largest_velocity()) : 1;
  bool agrees = true;
  fly_so(candidate, o.frame, o.dt, flight, [&](std::size_t row, const Log::Triple& x, const Log::Triple& v) {
    for (const int axis : o.axes) {
      if (only >= 0 && axis != only) continue;
      const auto i = static_cast<std::size_t>(axis);
      const double dx = std::fabs(x[i] - o.x[row][i]);
      const bool reads_v = o.velocities && (row > 0 || o.first_velocity);
      const double dv = reads_v ? std::fabs(v[i] - o.v[row][i]) : 0;
      if (!(dx == 0 && dv == 0)) agrees = false;
      result.worst_position = std::isfinite(dx) ? std::max(result.worst_position, dx) : HUGE_VAL;
      result.worst_velocity = std::isfinite(dv) ? std::max(result.worst_velocity, dv) : HUGE_VAL;
    }
    result.same += agrees;
    return agrees || whole;
  });
  result.exact = agrees;
  result.ulp = std::max(result.worst_position / x_unit, result.worst_velocity / v_unit);
  return result;
}

}  // namespace shortfall
