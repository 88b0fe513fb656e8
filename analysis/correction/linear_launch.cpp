// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/linear_launch.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/motion/linear_flow.hpp"

namespace shortfall {

namespace {

Fraction factorial_quotient(int above, int below) { return factorial(above) / factorial(below); }

Fraction evaluated(const std::vector<Fraction>& p, const Fraction& t) {
  Fraction value;
  for (std::size_t j = p.size(); j-- > 0;) value = value * t + p[j];
  return value;
}

std::vector<Fraction> slope(const std::vector<Fraction>& p) {
  std::vector<Fraction> result;
  for (std::size_t j = 1; j < p.size(); ++j) result.push_back(p[j] * Fraction(static_cast<int>(j)));
  return result;
}

/// The coefficient of n^power in a polynomial in n.
Fraction of_power(const Fraction& p, int power) {
  return {p.numerator().coefficient(kCount, power), p.denominator()};
}

class Solver {
 public:
  explicit Solver(const LaunchProblem& p) : p_(p), size_(p.step.states()), degree_(p.step.map.force.degree) {
    for (const auto& row : p.step.matrix) {
      m_.emplace_back();
      for (const Fraction& f : row) m_.back().push_back(put(f));
    }
    for (int s = 0; s < size_; ++s) {
      x_.push_back(put(p.step.map.position[s]));
      v_.push_back(put(p.step.map.velocity[s]));
    }
    for (int d = 0; d <= degree_; ++d) {
      position_.push_back(put(p.step.position(d)));
      velocity_.push_back(put(p.step.velocity(d)));
      truth_.push_back(particular_polynomial(d, p.k, p.c));
    }
  }

  LinearLaunch solved() {
    if (!find_plane() || !match_force()) return result_;
    find_start();
    find_read_out();
    return result_;
  }

 private:
  Fraction put(const Fraction& f) const { return p_.put(f); }

  bool refuse(const std::string& why) {
    result_ = {};
    result_.obstruction = why;
    return false;
  }

  /// The states that (M^2 - T M + D) takes to 0, by their first two positions.
  bool find_plane() {
    Matrix p = m_ * m_;
    for (int i = 0; i < size_; ++i) {
      for (int j = 0; j < size_; ++j) p[i][j] -= p_.trace * m_[i][j];
      p[i][i] += p_.determinant;
    }
    Matrix equations = p;
    equations.push_back(x_);
    equations.emplace_back(size_);
    for (int j = 0; j < size_; ++j)
      for (int i = 0; i < size_; ++i) equations.back()[j] += x_[i] * m_[i][j];
    for (int which : {0, 1}) {
      std::vector<Fraction> right(equations.size());
      right[size_ + which] = 1;
      auto found = solve_linear(equations, right);
      if (!found.solution)
        return refuse(
            "the two eigenvalues match, but the step cannot take every pair of first positions along: its "
            "Jordan form, "
            "or what it reports, is not that of the exact flow");
      plane_[which] = *found.solution;
    }
    return true;
  }

  /// The force f~ = sum of gamma_j f^(j) whose motion, polynomial in time, is the true one for f.
  bool match_force() {
    const int lift = p_.k.is_zero() ? 1 : 0;  // a shift is free there
    const Fraction t = Fraction::letter(kCount) * Fraction::letter(kStepLetter);
    std::vector<Fraction>& gamma = result_.force;
    for (int j = 0; j <= degree_; ++j) {
      Fraction rest = of_power(evaluated(truth_[degree_], t), degree_ - j + lift);
      for (int i = 0; i < j; ++i)
        rest -= gamma[i] * factorial_quotient(degree_, degree_ - i) *
                of_power(position_[degree_ - i], degree_ - j + lift);
      const Fraction leading =
          factorial_quotient(degree_, degree_ - j) * of_power(position_[degree_ - j], degree_ - j + lift);
      if (leading.is_zero()) return refuse("the integrator does not feel a force that depends on time alone");
      gamma.push_back(rest / leading);
    }
    for (int d = 0; d <= degree_; ++d) {
      Fraction difference = -evaluated(truth_[d], t);
      for (int j = 0; j <= d; ++j) difference += gamma[j] * factorial_quotient(d, d - j) * position_[d - j];
      if (lift == 1) difference -= difference.substitute(kCount, Fraction(0));
      if (!difference.is_zero())
        return refuse("the integrator answers the same force differently at different times");
    }
    return true;
  }

  /// The coefficient of t^m in f~, as a combination of the derivatives of f at t = 0 (column F_i at place i).
  Fraction given(int m, int derivative) const {
    if (derivative < m) return {};
    return result_.force[derivative - m] / Fraction(factorial(m));
  }

  void find_start() {
    const Fraction h = Fraction::letter(kStepLetter);
    const int columns = 2 + degree_ + 1;  // x0, v0, F_0, F_1, ...
    // First two positions without the polynomial motion.
    std::vector<Fraction> e[2];
    e[0].resize(columns);
    e[1].resize(columns);
    e[0][0] = 1;
    e[1][0] = p_.cosine;
    e[1][1] = p_.sine;
    for (int i = 0; i <= degree_; ++i) {
      const std::vector<Fraction>& p = truth_[i];
      const std::vector<Fraction> rate = slope(p);
      const Fraction none;
      const Fraction& first = p.empty() ? none : p[0];
      e[1][2 + i] = (evaluated(p, h) - p_.cosine * first - p_.sine * (rate.empty() ? none : rate[0])) /
                    Fraction(factorial(i));
      for (int m = 0; m <= i; ++m)
        for (int n : {0, 1}) e[n][2 + i] -= position_[m].substitute(kCount, Fraction(n)) * given(m, i);
    }
    // The state from which on every frame is right ...
    Matrix state(size_, std::vector<Fraction>(columns));
    for (int s = 0; s < size_; ++s)
      for (int c = 0; c < columns; ++c) {
        state[s][c] = plane_[0][s] * e[0][c] + plane_[1][s] * e[1][c];
        for (int m = 0; c >= 2 && m <= c - 2; ++m)
          state[s][c] += put(p_.step.state(s, m).substitute(kCount, Fraction(0))) * given(m, c - 2);
      }
    // ... made by the integrator's own start, where that can be.
    Matrix start(size_, std::vector<Fraction>(2));
    for (int s = 0; s < size_; ++s)
      for (int c : {0, 1}) start[s][c] = put(p_.step.start(s, c));
    std::vector<Fraction> launch[2];
    for (int c = 0; c < columns; ++c) {
      std::vector<Fraction> right;
      for (int s = 0; s < size_; ++s) {
        right.push_back(state[s][c]);
        for (int m = 0; c >= 2 && m <= c - 2; ++m)
          right.back() -= put(p_.step.start(s, 2 + m)) * given(m, c - 2);
      }
      const auto found = solve_linear(start, right);
      if (!found.solution) {
        result_.by_states = true;
        break;
      }
      for (int i : {0, 1}) launch[i].push_back((*found.solution)[i]);
    }
    const auto add = [&](const std::string& target, const std::vector<Fraction>& row) {
      result_.start.emplace_back(target, ForceForm{row[0], row[1], {row.begin() + 2, row.end()}});
    };
    if (result_.by_states)
      for (int s = 0; s < size_; ++s) add(p_.step.map.states[s], state[s]);
    else
      for (int i : {0, 1}) add(i == 0 ? "x0" : "v0", launch[i]);
  }

  void find_read_out() {
    Fraction u[2];  // the reported velocity of the free motion, from two positions that follow each other
    for (int which : {0, 1})
      for (int s = 0; s < size_; ++s) u[which] += v_[s] * plane_[which][s];
    if (u[1].is_zero()) return;
    ForceForm out;
    out.v = Fraction(1) / (u[1] * p_.sine);
    out.x = -(u[0] / u[1] + p_.cosine) / p_.sine;
    if (degree_ >= 0) {
      const Fraction t = Fraction::letter(kCount) * Fraction::letter(kStepLetter);
      // For the force t^degree; the derivatives follow, because a shift in time changes nothing.
      Fraction rest = evaluated(slope(truth_[degree_]), t);
      for (int m = 0; m <= degree_; ++m) {
        const Fraction weight = result_.force[degree_ - m] * factorial_quotient(degree_, m);
        rest -= (out.v * velocity_[m] + out.x * position_[m]) * weight;
      }
      for (int j = 0; j <= degree_; ++j)
        out.f.push_back(of_power(rest, degree_ - j) / (factorial_quotient(degree_, degree_ - j) *
                                                       Fraction::letter(kStepLetter).pow(degree_ - j)));
    }
    result_.read_out = out;
  }

  const LaunchProblem& p_;
  int size_;
  int degree_;
  Matrix m_;
  std::vector<Fraction> x_, v_;                // rows: what is reported of a state
  std::vector<Fraction> position_, velocity_;  // under t^d, polynomials in n
  std::vector<std::vector<Fraction>> truth_;   // the same of the true motion, in t
  std::vector<Fraction> plane_[2];
  LinearLaunch result_;
};

}  // namespace

LinearLaunch linear_launch(const LaunchProblem& problem) { return Solver(problem).solved(); }

std::size_t term_count(const LinearLaunch& launch) {
  std::size_t terms = 0;
  const auto count = [&](const Fraction& f) {
    terms += f.numerator().terms().size() + f.denominator().terms().size();
  };
  const auto count_form = [&](const ForceForm& form) {
    count(form.x);
    count(form.v);
    for (const Fraction& f : form.f) count(f);
  };
  for (const Fraction& f : launch.force) count(f);
  for (const auto& [target, form] : launch.start) count_form(form);
  if (launch.read_out) count_form(*launch.read_out);
  return terms;
}

}  // namespace shortfall
