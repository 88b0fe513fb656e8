// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The body of one_step.hpp, which includes it.

#include <utility>
#include <vector>

#include "analysis/program/run.hpp"

namespace shortfall {
namespace one_step_detail {

template <class K>
using Matrix = std::vector<std::vector<K>>;

/// How start, step and finish act where there is no force: constant matrices, with h = 1.
template <class K>
struct FreeFlight {
  Matrix<K> start;   ///< states x 2
  Matrix<K> step;    ///< states x states
  Matrix<K> finish;  ///< 2 x states
};

/// The parts of a system for one step that hang from no force.
template <class K>
struct Chart {
  Matrix<K> states;   ///< states x 2: what the states are when (x, v) is reported
  Matrix<K> solver;   ///< (states + 2) x (states + 2): inverse of the system for one tree
  Matrix<K> reading;  ///< 2 x states: what a change of the states does to (x, v) in the long run
};

template <class K>
class Analysis {
 public:
  Analysis(const Tape& tape, SmoothForce<K>& problem, const TreeTable& table)
      : problem_(problem),
        table_(table),
        run_(tape, problem, problem.number(1)),
        count_(tape.states.size()),
        plain_(count_ == 2 && tape.start.empty() && tape.finish.empty()) {}

  OneStep<K> operator()() {
    result_.map.assign(table_.size(), K(0));
    result_.field.assign(table_.size(), K(0));
    result_.start.assign(table_.size(), K(0));
    result_.carries = !plain_;
    flight_ = free_flight();
    chart_ = chart();
    if (plain_)
      run_plain();
    else
      run_by_orders();
    return std::move(result_);
  }

 private:
  using Vector = Differentials<K>;

  static Vector unit(std::size_t entry) {
    Vector v;
    v.at(entry) = K(1);
    return v;
  }

  FreeFlight<K> free_flight() {
    problem_.set_free(count_);
    FreeFlight<K> f;
    run_.begin(unit(0), unit(1), problem_.number(0));
    for (std::size_t s = 0; s < count_; ++s) f.start.push_back({state(s)[0], state(s)[1]});
    for (std::size_t s = 0; s < count_; ++s) run_.set_state(static_cast<int>(s), unit(s));
    const auto [x, v] = run_.read_out();
    f.finish.resize(2);
    for (std::size_t s = 0; s < count_; ++s) {
      f.finish[0].push_back(x[s]);
      f.finish[1].push_back(v[s]);
    }
    run_.set_time(problem_.number(0));
    run_.step();
    for (std::size_t s = 0; s < count_; ++s) {
      f.step.emplace_back();
      for (std::size_t j = 0; j < count_; ++j) f.step.back().push_back(state(s)[j]);
    }
    return f;
  }

  const Vector& state(std::size_t s) const { return run_.state(static_cast<int>(s)); }

  /// Solves, with h = 1,  step Z = Z [1 1; 0 1],  finish Z = 1  for the states Z of a free body.
  Chart<K> chart() {
    const Undefined no_order(
        "a free body does not move along a line at its velocity (or the states that the step carries are not "
        "determined by x and v): the step has no order");
    const Matrix<K> shear{{K(1), K(1)}, {K(0), K(1)}};
    Chart<K> c;
    // The start of a consistent integrator puts the states of a free body where they belong.
    c.states = flight_.start;
    if (!(equal(product(flight_.step, c.states), product(c.states, shear)) &&
          equal(product(flight_.finish, c.states), Matrix<K>{{K(1), K(0)}, {K(0), K(1)}})))
      throw no_order;
    if (plain_) return c;
    try {
      Matrix<K> system(count_ + 2, std::vector<K>(count_ + 2, K(0)));
      for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t j = 0; j < count_; ++j) system[i][j] = flight_.step[i][j] - K(i == j ? 1 : 0);
        for (std::size_t j : {0, 1}) {
          system[i][count_ + j] = K(0) - c.states[i][j];
          system[count_ + j][i] = flight_.finish[j][i];
        }
      }
      c.solver = inverse_of(system);
      c.reading = long_run(c.states);
    } catch (const Undefined&) {
      throw no_order;
    }
    return c;
  }

  /// The 2 x states matrix P with P step = [1 1; 0 1] P and P Z = 1: rows of left eigenvectors.
  Matrix<K> long_run(const Matrix<K>& states) const {
    // p1 (step - 1) = p2, p2 (step - 1) = 0, p1 Z = (1, 0), p2 Z = (0, 1). Transposed, p1 solves
    // a system that the solver's transpose has: rows (step - 1)^T | Z^T.
    const auto row = [&](const std::vector<K>& right, const K& zx, const K& zv) {
      Matrix<K> system(count_ + 2, std::vector<K>(count_ + 2, K(0)));
      std::vector<K> rhs = right;
      for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t j = 0; j < count_; ++j) system[i][j] = flight_.step[j][i] - K(i == j ? 1 : 0);
        for (std::size_t j : {0, 1}) {
          system[i][count_ + j] = flight_.finish[j][i];
          system[count_ + j][i] = states[i][j];
        }
      }
      rhs.push_back(zx);
      rhs.push_back(zv);
      const Matrix<K> inverse = inverse_of(system);
      std::vector<K> p(count_, K(0));
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < count_ + 2; ++j) p[i] += inverse[i][j] * rhs[j];
      return p;
    };
    const std::vector<K> p2 = row(std::vector<K>(count_, K(0)), K(0), K(1));
    return {row(p2, K(1), K(0)), p2};
  }

  static Matrix<K> product(const Matrix<K>& a, const Matrix<K>& b) {
    Matrix<K> result(a.size(), std::vector<K>(b[0].size(), K(0)));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b[0].size(); ++j)
        for (std::size_t k = 0; k < b.size(); ++k) result[i][j] += a[i][k] * b[k][j];
    return result;
  }
  bool equal(const Matrix<K>& a, const Matrix<K>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < a[i].size(); ++j)
        if (!negligible(a[i][j] - b[i][j])) return false;
    return true;
  }
  bool negligible(const K& k) const {
    if (vanishes(k)) return true;
    if constexpr (std::is_same_v<K, Rational>)
      return k.abs() < problem_.tolerance;
    else if constexpr (requires { k.is_constant(); })
      return k.is_constant() && k.constant().abs() < problem_.tolerance;
    else
      return false;
  }

  void run_plain() {
    problem_.set_order(table_.order());
    run_.begin(unit(0), unit(1), problem_.number(0));
    run_.step();
    for (int n = 1; n <= table_.order(); ++n) put_order(n, state(0), state(1));
    result_.field = logarithm(table_, result_.map);
  }

  /// The trees of order n with the drift and the clock at the root, then those with the force there.
  void put_order(int n, const Vector& x, const Vector& v) {
    for (TreeId t = table_.begin(n); t < table_.end(n); ++t) {
      const int f = table_.function(t);
      if (f == 0)
        result_.map[t] = symmetry(t) * v[entry(t)];
      else
        result_.map[t] = table_.is_node(t) ? K(1) : symmetry(table_.right(t)) * x[entry(table_.right(t))];
    }
  }
  std::size_t entry(TreeId t) const { return 2 + problem_.rank(t); }
  K symmetry(TreeId t) const { return problem_.number(table_.symmetry(t)); }

  void run_by_orders() {
    LieIteration<K> flow(table_);
    std::vector<LieIteration<K>> carried(count_, LieIteration<K>(table_));
    std::vector<TreeSeries<K>> z(count_, TreeSeries<K>(table_.size(), K(0)));
    std::vector<Vector> states(count_);
    for (std::size_t s = 0; s < count_; ++s) states[s].c = chart_.states[s];
    Vector x = unit(0), v = unit(1);
    x.at(1) = K(1);
    for (int n = 1; n <= table_.order(); ++n) {
      // Drift trees of this order follow from the force's trees of the last one.
      put_order(n, x, v);
      problem_.set_order(n);
      for (std::size_t s = 0; s < count_; ++s) run_.set_state(static_cast<int>(s), states[s]);
      run_.set_time(problem_.number(0));
      const auto read = run_.read_out();
      run_.step();
      for (TreeId t = table_.begin(n); t < table_.end(n); ++t) {
        if (table_.function(t) == 0) {
          const K sigma = symmetry(t);
          std::vector<K> right;
          for (std::size_t s = 0; s < count_; ++s)
            right.push_back(carried[s].transport(t, result_.field) / sigma - state(s)[entry(t)]);
          right.push_back(K(0) - read.first[entry(t)]);
          right.push_back(K(0) - read.second[entry(t)]);
          const std::vector<K> solution = solved(right);
          for (std::size_t s = 0; s < count_; ++s) {
            if (!vanishes(solution[s])) states[s].at(entry(t)) = solution[s];
            z[s][t] = sigma * solution[s];
            carried[s].settle(t, z[s][t]);
          }
          x.at(entry(t)) = solution[count_];
          v.at(entry(t)) = solution[count_ + 1];
          result_.map[t] = sigma * solution[count_ + 1];
        } else {
          for (LieIteration<K>& c : carried) c.transport(t, result_.field);
        }
        result_.field[t] = result_.map[t] - flow.flow(t, result_.field);
        flow.settle(t, result_.field[t]);
      }
    }
    deviation(states);
  }

  std::vector<K> solved(const std::vector<K>& right) const {
    std::vector<K> result(right.size(), K(0));
    for (std::size_t i = 0; i < right.size(); ++i)
      for (std::size_t j = 0; j < right.size(); ++j)
        if (!vanishes(right[j])) result[i] += chart_.solver[i][j] * right[j];
    return result;
  }

  /// What the start puts, less what belongs there.
  void deviation(const std::vector<Vector>& states) {
    problem_.set_order(table_.order());
    run_.begin(unit(0), unit(1), problem_.number(0));
    Vector x, v;
    for (std::size_t s = 0; s < count_; ++s) {
      const Vector wrong = state(s) - states[s];
      x += chart_.reading[0][s] * wrong;
      v += chart_.reading[1][s] * wrong;
    }
    for (TreeId t = 0; t < table_.size(); ++t) {
      if (table_.function(t) == 0)
        result_.start[t] = symmetry(t) * v[entry(t)];
      else if (!table_.is_node(t))
        result_.start[t] = symmetry(table_.right(t)) * x[entry(table_.right(t))];
    }
  }

  SmoothForce<K>& problem_;
  const TreeTable& table_;
  Run<SmoothForce<K>> run_;
  std::size_t count_;
  bool plain_;
  FreeFlight<K> flight_;
  Chart<K> chart_;
  OneStep<K> result_;
};

}  // namespace one_step_detail

template <class K>
OneStep<K> one_step(const Tape& tape, SmoothForce<K>& problem, const TreeTable& table) {
  return one_step_detail::Analysis<K>(tape, problem, table)();
}

}  // namespace shortfall
