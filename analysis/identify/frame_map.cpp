// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/frame_map.hpp"

#include <cmath>
#include <optional>

#include "analysis/algebra/near_root.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/problems/stage_solver.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

namespace {

/// x'' = A - k x - c v, in combinations: one run of a step gives its affine map.
struct CombinedForce {
  using Scalar = double;
  using Vector = Combination;

  Circumstances what;
  std::size_t states;
  int own_c = -1;  ///< place of the parameter c

  Scalar number(const Rational& value) const { return value.to_double(); }
  std::optional<Scalar> parameter(int index, bool) const {
    if (index == own_c && what.has_own_c) return what.own_c;
    return std::nullopt;
  }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar&) const {
    Vector a = Combination::unit(states);
    if (what.k != 0) a = a - what.k * x;
    if (what.drag != 0) a = a - what.drag * v;
    return a;
  }
  Scalar function(Function f, Scalar a, Scalar b) const { return value_of(f, a, b); }
  Scalar root(const RealRoot& root, const std::string&) const {
    return root.is_rational() ? root.rational().to_double() : near(root, kRoundedRootDigits).to_double();
  }
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }

  /// The unknowns get columns of their own and are eliminated.
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    const std::size_t first = states + 2, count = unknowns.size();
    if (first + count > Combination::kMost) throw Unable("the stage has too many unknowns");
    for (std::size_t u = 0; u < count; ++u) unknowns[u] = Combination::unit(first + u);
    std::vector<Vector> values = f(unknowns);
    StageParts<double>::Matrix matrix(count, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) {
        matrix[i][j] = (i == j ? 1 : 0) - values[i].part[first + j];
        values[i].part[first + j] = 0;
      }
    for (std::size_t column = 0; column < first; ++column) {
      std::vector<double> right;
      for (const Vector& value : values) right.push_back(value.part[column]);
      auto copy = matrix;
      const std::vector<double> solved = StageParts<double>::solved(copy, right, 0);
      for (std::size_t i = 0; i < count; ++i) {
        if (column == 0) unknowns[i] = {};
        unknowns[i].part[column] = solved[i];
      }
    }
  }
};

std::vector<Combination> carried(const Run<CombinedForce>& run, std::size_t states) {
  std::vector<Combination> result;
  for (std::size_t i = 0; i < states; ++i) result.push_back(run.state(static_cast<int>(i)));
  return result;
}

double dot(const Combination& row, const std::vector<double>& state, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += row.part[i] * state[i];
  return sum;
}

}  // namespace

FrameMap frame_map(const Tape& tape, const Circumstances& what) {
  const std::size_t states = tape.states.size();
  if (states + 2 > Combination::kMost) throw Unable("the integrator carries too many vectors");
  CombinedForce force{what, states};
  for (std::size_t i = 0; i < tape.parameters.size(); ++i)
    if (tape.parameters[i].name == "c") force.own_c = static_cast<int>(i);
  Run<CombinedForce> run(tape, force, what.dt / what.substeps);
  FrameMap map;
  map.states = static_cast<int>(states);
  run.begin(Combination::unit(0), Combination::unit(1), 0);
  map.start = carried(run, states);
  const auto frame = [&](bool impulsive) {
    for (std::size_t i = 0; i < states; ++i) run.set_state(static_cast<int>(i), Combination::unit(i));
    if (impulsive && tape.impulse >= 0) run.give_impulse(Combination::unit(states + 1));
    run.set_time(0);
    for (int n = 0; n < what.substeps; ++n) run.step();
    return carried(run, states);
  };
  map.step = frame(false);
  map.first = tape.impulse >= 0 ? frame(true) : map.step;
  for (std::size_t i = 0; i < states; ++i) run.set_state(static_cast<int>(i), Combination::unit(i));
  std::tie(map.position, map.velocity) = run.read_out();
  return map;
}

Responses responses(const FrameMap& map, std::size_t frames) {
  const auto states = static_cast<std::size_t>(map.states);
  Responses result;
  result.position.resize(frames);
  result.velocity.resize(frames);
  for (std::size_t basis = 0; basis < 4; ++basis) {
    // The state, then A, then the impulse.
    std::vector<double> state(states + 2), next(states + 2);
    for (std::size_t i = 0; i < states; ++i)
      state[i] = basis < 2 ? map.start[i].part[basis] : basis == 2 ? map.start[i].part[states] : 0;
    state[states] = next[states] = basis == 2 ? 1 : 0;
    state[states + 1] = next[states + 1] = basis == 3 ? 1 : 0;
    for (std::size_t n = 0; n < frames; ++n) {
      if (n > 0) {
        const auto& rows = n == 1 ? map.first : map.step;
        for (std::size_t i = 0; i < states; ++i) next[i] = dot(rows[i], state, states + 2);
        std::swap(state, next);
      }
      result.position[n][basis] = dot(map.position, state, states + 1);
      result.velocity[n][basis] = dot(map.velocity, state, states + 1);
    }
  }
  return result;
}

}  // namespace shortfall
