// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shortfall {

namespace {

/// Normal equations with columns scaled to length 1, factored by Cholesky; columns that depend on those
/// before them are left out.
class Normal {
 public:
  Normal(const LinearRows& rows, const std::vector<double>& weights)
      : n_(rows.unknowns), scale_(n_, 0), lower_(n_ * n_, 0), left_out_(n_, false) {
    for (std::size_t r = 0; r < rows.rows(); ++r) {
      const double w = weights.empty() ? 1 : weights[r];
      const double* const row = &rows.matrix[r * n_];
      for (std::size_t i = 0; i < n_; ++i)
        if (row[i] != 0)
          for (std::size_t j = 0; j <= i; ++j) lower_[i * n_ + j] += w * row[i] * row[j];
    }
    for (std::size_t i = 0; i < n_; ++i)
      scale_[i] = lower_[i * n_ + i] > 0 ? 1 / std::sqrt(lower_[i * n_ + i]) : 0;
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j <= i; ++j) lower_[i * n_ + j] *= scale_[i] * scale_[j];
    for (std::size_t i = 0; i < n_; ++i) factor(i);
  }

  std::vector<double> solved(std::vector<double> b) const {
    for (std::size_t i = 0; i < n_; ++i) b[i] *= scale_[i];
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < i; ++j) b[i] -= lower_[i * n_ + j] * b[j];
      b[i] = left_out_[i] ? 0 : b[i] / lower_[i * n_ + i];
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) b[i] -= lower_[j * n_ + i] * b[j];
      b[i] = left_out_[i] ? 0 : b[i] / lower_[i * n_ + i];
    }
    for (std::size_t i = 0; i < n_; ++i) b[i] *= scale_[i];
    return b;
  }

  double variance(std::size_t i) const {
    if (left_out_[i]) return std::numeric_limits<double>::infinity();
    std::vector<double> unit(n_, 0);
    unit[i] = 1;
    return solved(unit)[i];
  }

 private:
  void factor(std::size_t i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = lower_[i * n_ + j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower_[i * n_ + k] * lower_[j * n_ + k];
      if (j < i)
        lower_[i * n_ + j] = left_out_[j] ? 0 : sum / lower_[j * n_ + j];
      else if (left_out_[i] = !(sum > 1e-13); !left_out_[i])
        lower_[i * n_ + i] = std::sqrt(sum);
    }
    if (left_out_[i])
      for (std::size_t j = 0; j <= i; ++j) lower_[i * n_ + j] = 0;
  }

  std::size_t n_;
  std::vector<double> scale_, lower_;
  std::vector<bool> left_out_;
};

std::vector<double> residuals(const LinearRows& rows, const std::vector<double>& unknowns) {
  std::vector<double> result(rows.rows());
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    double sum = rows.right[r];
    for (std::size_t i = 0; i < rows.unknowns; ++i) sum -= rows.matrix[r * rows.unknowns + i] * unknowns[i];
    result[r] = sum;
  }
  return result;
}

}  // namespace

void LinearRows::add(const std::vector<double>& row, double value) {
  matrix.insert(matrix.end(), row.begin(), row.end());
  right.push_back(value);
}

LeastSquares least_squares(const LinearRows& rows, const std::vector<double>& weights) {
  const std::size_t n = rows.unknowns;
  const Normal normal(rows, weights);
  LeastSquares s{std::vector<double>(n, 0), {}, rows.right};
  // Each further round makes good what the normal equations lost.
  for (int round = 0; round < 3; ++round) {
    std::vector<double> b(n, 0);
    for (std::size_t r = 0; r < rows.rows(); ++r) {
      const double w = (weights.empty() ? 1 : weights[r]) * s.residual[r];
      for (std::size_t i = 0; i < n; ++i) b[i] += w * rows.matrix[r * n + i];
    }
    const std::vector<double> more = normal.solved(std::move(b));
    for (std::size_t i = 0; i < n; ++i) s.unknowns[i] += more[i];
    s.residual = residuals(rows, s.unknowns);
  }
  for (std::size_t i = 0; i < n; ++i) s.variance.push_back(normal.variance(i));
  return s;
}

LeastSquares least_maximum(const LinearRows& rows, int rounds) {
  std::vector<double> weights(rows.rows(), 1);
  LeastSquares best = least_squares(rows);
  const auto largest = [](const LeastSquares& s) {
    double most = 0;
    for (const double r : s.residual) most = std::max(most, std::fabs(r));
    return most;
  };
  double least = largest(best);
  LeastSquares last = best;
  for (int round = 0; round < rounds && least > 1; ++round) {
    const double most = largest(last);
    if (!(most > 0)) break;
    double sum = 0;
    for (std::size_t r = 0; r < weights.size(); ++r) sum += weights[r] *= std::fabs(last.residual[r]) / most;
    if (!(sum > 0)) break;
    for (double& w : weights) w = w / sum + 1e-12;
    last = least_squares(rows, weights);
    if (const double now = largest(last); now < least) {
      least = now;
      std::vector<double> variance = std::move(best.variance);
      best = last;
      best.variance = std::move(variance);
    }
  }
  return best;
}

}  // namespace shortfall
