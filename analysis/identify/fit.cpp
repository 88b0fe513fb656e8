// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/least_squares.hpp"

namespace shortfall {

namespace {

constexpr double kHopeless = 1e30;
constexpr double kPolished = 1e4;  // a residual above this is no question of bits

/// One candidate before one log: residuals as a function of damping and spring alone.
class Fitting {
 public:
  Fitting(const Candidate& candidate, const Observations& o, const FitQuestion& q)
      : candidate_(candidate), o_(o), q_(q), launch_(q.launch == Launch::impulse ? 4 : 3) {}

  std::size_t nonlinear() const { return (q_.damping ? 1U : 0U) + (q_.spring ? 1U : 0U); }
  std::size_t residuals() const {
    return o_.axes.size() *
           (o_.rows() * (o_.velocities ? 2 : 1) - (o_.velocities && !o_.first_velocity ? 1 : 0));
  }

  double c(const std::vector<double>& p) const { return q_.damping ? p[0] : 0; }
  double k(const std::vector<double>& p) const { return q_.spring ? p[q_.damping ? 1 : 0] : 0; }

  /// How the frames depend on launch and acceleration; false where the map explodes.
  bool respond(const std::vector<double>& p) {
    try {
      map_ = responses(frame_map(*candidate_.tape, candidate_.circumstances(o_.dt, c(p), k(p))), o_.frames());
    } catch (const Error&) {
      return false;
    }
    const auto& last = map_.position.back();
    return std::ranges::all_of(last, [](double x) { return std::isfinite(x) && std::fabs(x) < 1e15; });
  }

  /// The rows of one axis, in halves of a unit.
  LinearRows rows(std::size_t axis) const {
    LinearRows result;
    result.unknowns = launch_;
    result.matrix.reserve(2 * o_.rows() * launch_);
    result.right.reserve(2 * o_.rows());
    const auto put = [&](const Responses::Row& row, double value, double half) {
      for (std::size_t u = 0; u < launch_; ++u) result.matrix.push_back(row[u] / half);
      result.right.push_back(value / half);
    };
    for (std::size_t r = 0; r < o_.rows(); ++r) {
      put(map_.position[o_.frame[r]], o_.x[r][axis], o_.half_position(o_.x[r][axis]));
      if (o_.velocities && (r > 0 || o_.first_velocity))
        put(map_.velocity[o_.frame[r]], o_.v[r][axis], o_.half_velocity(o_.v[r][axis]));
    }
    return result;
  }

  /// All axes at once, for the best launch and acceleration under damping and spring.
  bool solve(const std::vector<double>& p, std::vector<double>& residual) {
    linear_.clear();
    residual.clear();
    if (!respond(p)) return false;
    for (const int axis : o_.axes) {
      const LeastSquares s = least_squares(rows(static_cast<std::size_t>(axis)));
      linear_.push_back(s.unknowns);
      residual.insert(residual.end(), s.residual.begin(), s.residual.end());
    }
    return std::ranges::all_of(residual, [](double r) { return std::isfinite(r); });
  }

  /// Residuals are affine in all unknowns near a solution: the rows for small changes of them.
  LinearRows all_rows(const std::vector<double>& p, const std::vector<double>& residual) {
    LinearRows result;
    const std::size_t count = nonlinear();
    result.unknowns = count + launch_ * o_.axes.size();
    std::vector<std::vector<double>> slopes(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<double> moved = p;
      const double width = 1e-6 * std::max(std::fabs(p[i]), 1e-3);
      moved[i] += width;
      if (!respond(moved)) continue;
      for (std::size_t axis = 0; axis < o_.axes.size(); ++axis) {
        const LinearRows there = rows(static_cast<std::size_t>(o_.axes[axis]));
        for (std::size_t r = 0; r < there.rows(); ++r) {
          double value = 0;
          for (std::size_t u = 0; u < launch_; ++u) value += there.matrix[r * launch_ + u] * linear_[axis][u];
          slopes[i].push_back(value);
        }
      }
      respond(p);
      std::size_t at = 0;
      for (std::size_t axis = 0; axis < o_.axes.size(); ++axis) {
        const LinearRows here = rows(static_cast<std::size_t>(o_.axes[axis]));
        for (std::size_t r = 0; r < here.rows(); ++r, ++at) {
          double value = 0;
          for (std::size_t u = 0; u < launch_; ++u) value += here.matrix[r * launch_ + u] * linear_[axis][u];
          slopes[i][at] = (slopes[i][at] - value) / width;
        }
      }
    }
    respond(p);
    std::size_t at = 0;
    for (std::size_t axis = 0; axis < o_.axes.size(); ++axis) {
      const LinearRows here = rows(static_cast<std::size_t>(o_.axes[axis]));
      for (std::size_t r = 0; r < here.rows(); ++r, ++at) {
        std::vector<double> row(result.unknowns, 0);
        for (std::size_t i = 0; i < count; ++i) row[i] = at < slopes[i].size() ? slopes[i][at] : 0;
        for (std::size_t u = 0; u < launch_; ++u)
          row[count + axis * launch_ + u] = here.matrix[r * launch_ + u];
        result.add(row, residual[at]);
      }
    }
    return result;
  }

  std::vector<std::vector<double>>& linear() { return linear_; }
  std::size_t launch_unknowns() const { return launch_; }

  /// Damping and spring under which a frame has the wanted trace and determinant, by Newton's iteration from
  /// a guess; the guess where that leads nowhere, or where the integrator carries more than x and v.
  std::vector<double> invariant_match(const std::vector<double>& guess) const {
    if (candidate_.tape->states.size() != 2 || !q_.invariants) return guess;
    const auto off = [&](const std::vector<double>& p, std::array<double, 2>& f) {
      try {
        const FrameMap m = frame_map(*candidate_.tape, candidate_.circumstances(o_.dt, c(p), k(p)));
        f = {m.step[0].part[0] * m.step[1].part[1] - m.step[0].part[1] * m.step[1].part[0] - q_.determinant,
             m.step[0].part[0] + m.step[1].part[1] - q_.trace};
        return std::isfinite(f[0]) && std::isfinite(f[1]);
      } catch (const Error&) {
        return false;
      }
    };
    std::vector<double> p = guess;
    std::array<double, 2> f{};
    for (int round = 0; round < 20; ++round) {
      if (!off(p, f)) return guess;
      std::array<std::array<double, 2>, 2> slope{};
      for (std::size_t i = 0; i < p.size(); ++i) {
        std::vector<double> moved = p;
        const double width = 1e-6 * std::max(std::fabs(p[i]), 1e-2);
        moved[i] += width;
        if (!off(moved, slope[i])) return guess;
        for (std::size_t e = 0; e < 2; ++e) slope[i][e] = (slope[i][e] - f[e]) / width;
      }
      double most = 0;
      if (p.size() == 1) {
        // A damping shows in the determinant, a spring in the trace.
        const std::size_t e = q_.damping ? 0 : 1;
        const double move = f[e] / slope[0][e];
        p[0] -= move;
        most = std::fabs(move) / std::max(std::fabs(p[0]), 1e-9);
      } else {
        const double d = slope[0][0] * slope[1][1] - slope[1][0] * slope[0][1];
        const double dc = (f[0] * slope[1][1] - f[1] * slope[1][0]) / d;
        const double dk = (slope[0][0] * f[1] - slope[0][1] * f[0]) / d;
        p[0] -= dc;
        p[1] -= dk;
        most = std::max(std::fabs(dc) / std::max(std::fabs(p[0]), 1e-9),
                        std::fabs(dk) / std::max(std::fabs(p[1]), 1e-9));
      }
      if (!std::isfinite(most)) return guess;
      if (most < 1e-10) return p;
    }
    return guess;
  }

  /// Whether a residual is so large that no small change of the parameters can help.
  bool hopeless(const std::vector<double>& residual) const {
    if (candidate_.tape->states.size() != 2 || !q_.invariants) return false;
    const double position = o_.half_position(o_.largest_position());
    double most = 0;
    for (const double r : residual) most = std::max(most, std::fabs(r));
    return most > std::max(300.0, 3e-3 * o_.largest_position() / position);
  }

  /// A damping number under which the velocity decays at this rate, by bisection.
  double damping_number(double rate) const {
    if (!(rate > 0)) return 1e-6;
    const double wanted = std::exp(-rate * o_.dt);
    const auto kept = [&](double c) {
      try {
        const double m = frame_map(*candidate_.tape, candidate_.circumstances(o_.dt, c, 0)).step[1].part[1];
        return std::isfinite(m) ? m : -1;
      } catch (const Error&) {
        return -1.0;
      }
    };
    double low = 0, high = 1e-4;
    while (kept(high) > wanted && high < 1e6) high *= 2;
    for (int i = 0; i < 40; ++i) (kept((low + high) / 2) > wanted ? low : high) = (low + high) / 2;
    return (low + high) / 2;
  }

 private:
  const Candidate& candidate_;
  const Observations& o_;
  const FitQuestion& q_;
  std::size_t launch_;
  Responses map_;
  std::vector<std::vector<double>> linear_;
};

int residual_function(const gsl_vector* p, void* fitting, gsl_vector* f) {
  auto& what = *static_cast<Fitting*>(fitting);
  std::vector<double> parameters(p->size), residual;
  for (std::size_t i = 0; i < p->size; ++i) parameters[i] = gsl_vector_get(p, i);
  const bool fine = what.solve(parameters, residual) && residual.size() == f->size;
  for (std::size_t i = 0; i < f->size; ++i) gsl_vector_set(f, i, fine ? residual[i] : kHopeless);
  return GSL_SUCCESS;
}

/// Levenberg and Marquardt's way from a guess.
std::vector<double> minimised(Fitting& fitting, const std::vector<double>& guess) {
  gsl_set_error_handler_off();
  gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
  options.h_df = 1e-7;
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residual_function;
  problem.n = fitting.residuals();
  problem.p = guess.size();
  problem.params = &fitting;
  std::vector<double> result = guess;
  gsl_multifit_nlinear_workspace* const work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, problem.n, problem.p);
  gsl_vector_const_view start = gsl_vector_const_view_array(guess.data(), guess.size());
  gsl_multifit_nlinear_init(&start.vector, &problem, work);
  int info = 0;
  gsl_multifit_nlinear_driver(12, 1e-10, 1e-10, 0, nullptr, nullptr, &info, work);
  const gsl_vector* const found = gsl_multifit_nlinear_position(work);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = gsl_vector_get(found, i);
  gsl_multifit_nlinear_free(work);
  return result;
}

double normal_distribution(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

/// The chance that a number with this residual, in halves of a unit, was rounded to what stands there, when
/// the arithmetic had an error of a tenth of that besides.
double log_chance(double residual) {
  constexpr double kNoise = 0.1;
  const double chance =
      normal_distribution((residual + 1) / kNoise) - normal_distribution((residual - 1) / kNoise);
  const double outside = std::max(0.0, std::fabs(residual) - 1) / kNoise;
  return chance > 1e-200 ? std::log(chance) : -460 - outside;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::fabs(v));
  return most;
}

/// Newton's steps on damping and spring, as long as they make the largest residual smaller: what Levenberg
/// and Marquardt leave is more than the last bits of a log.
void polish(Fitting& fitting, std::vector<double>& p, std::vector<double>& residual) {
  constexpr int kMostSteps = 4;
  for (int i = 0; i < kMostSteps; ++i) {
    const LeastSquares change = least_squares(fitting.all_rows(p, residual));
    std::vector<double> moved = p, there;
    for (std::size_t k = 0; k < p.size(); ++k) moved[k] += change.unknowns[k];
    if (!fitting.solve(moved, there) || !(largest(there) < largest(residual))) break;
    p = moved;
    residual = there;
  }
  fitting.solve(p, residual);
}

}  // namespace

std::optional<Fit> fit(const Candidate& candidate, const Observations& o, const FitQuestion& q) {
  if (q.launch == Launch::impulse && !candidate.program->impulse) return std::nullopt;
  Fitting fitting(candidate, o, q);
  std::vector<double> p;
  if (q.damping) p.push_back(fitting.damping_number(q.rate));
  if (q.spring) p.push_back(q.stiffness);
  std::vector<double> residual;
  if (!p.empty()) {
    p = fitting.invariant_match(p);
    const bool solved = fitting.solve(p, residual);
    if (!solved || !fitting.hopeless(residual)) p = minimised(fitting, p);
  }
  if (!fitting.solve(p, residual)) return std::nullopt;
  if (!p.empty() && largest(residual) < kPolished) polish(fitting, p, residual);
  const LinearRows rows = fitting.all_rows(p, residual);
  LeastSquares change = least_squares(rows);
  if (const double now = largest(residual); !o.exact() && now > 1 && now < 3)
    change = least_maximum(rows, 100);
  std::vector<double> unknowns = p;
  for (const auto& axis : fitting.linear()) unknowns.insert(unknowns.end(), axis.begin(), axis.end());
  if (largest(change.residual) < largest(residual)) {
    for (std::size_t i = 0; i < unknowns.size(); ++i) unknowns[i] += change.unknowns[i];
    residual = change.residual;
  }
  Fit result;
  result.launch = q.launch;
  result.free = static_cast<int>(unknowns.size());
  result.worst = largest(residual);
  for (const double r : residual) result.log_likelihood += log_chance(r);
  const double size = std::max(result.worst, 1.0);
  std::size_t at = 0;
  const auto take = [&](Fitted& number) {
    number = {unknowns[at], size * std::sqrt(change.variance[at])};
    ++at;
  };
  if (q.damping) take(result.c);
  if (q.spring) take(result.k);
  std::size_t row = 0;
  for (const int axis : o.axes) {
    const auto i = static_cast<std::size_t>(axis);
    take(result.x0[i]);
    take(result.v0[i]);
    take(result.a[i]);
    if (q.launch == Launch::impulse) take(result.j[i]);
    for (std::size_t r = 0; r < o.rows(); ++r) {
      const double x = residual[row++] * o.half_position(o.x[r][i]);
      result.worst_position = std::max(result.worst_position, std::fabs(x));
      if (!o.velocities || (r == 0 && !o.first_velocity)) continue;
      const double v = residual[row++] * o.half_velocity(o.v[r][i]);
      result.worst_velocity = std::max(result.worst_velocity, std::fabs(v));
    }
  }
  return result;
}

RateGuess rate_guess(const Observations& o, std::size_t stride, bool spring) {
  LinearRows rows;
  rows.unknowns = 2 + o.axes.size();
  if (o.rows() < 2 * stride + 3) return {};
  for (std::size_t axis = 0; axis < o.axes.size(); ++axis)
    for (std::size_t r = stride; r + stride < o.rows(); ++r) {
      if (o.frame[r + stride] - o.frame[r] != o.frame[r] - o.frame[r - stride]) continue;
      const auto i = static_cast<std::size_t>(o.axes[axis]);
      const double h = o.dt * static_cast<double>(o.frame[r] - o.frame[r - stride]);
      const double x = o.x[r][i], before = o.x[r - stride][i], after = o.x[r + stride][i];
      std::vector<double> row(rows.unknowns, 0);
      row[0] = -(after - before) / (2 * h);
      row[1] = spring ? -x : 0;
      row[2 + axis] = 1;
      rows.add(row, (after - 2 * x + before) / (h * h));
    }
  const LeastSquares s = least_squares(rows);
  return {s.unknowns[0], spring ? s.unknowns[1] : 0};
}

}  // namespace shortfall
