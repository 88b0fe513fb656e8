// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "analysis/trade/smooth_tape.hpp"

namespace shortfall {

/// The exact motion x'' = a(x, v, t) from where it is, as a power series in time of any order: the
/// coefficients of every operation on the tape follow one another, O(order^2) for each.
///
/// T is DoubleDouble or Real. A step is as long as the last two coefficients allow for the tolerance; where a
/// |u| of the force changes sign, the series ends.
///
/// Sources: Moore (1966), Interval Analysis, 11; Jorba & Zou (2005), A software package for the numerical
/// integration of ODEs by means of high-order Taylor methods, Experimental Mathematics 14.
template <class T>
class TaylorFlow {
 public:
  struct Settings {
    int order = 24;
    double tolerance = 1e-30;  ///< of a step, relative to the largest x (and v) so far
    double longest = 1;        ///< step
    std::function<T(const Rational&)> number;
  };

  /// param  tape  inputs x (m of them), v (m), t; outputs the m accelerations
  TaylorFlow(SmoothTape tape, Settings settings);

  int coordinates() const { return m_; }

  /// The series at a state.
  ///
  /// throws  Undefined  when a coefficient is no number: the force is singular there
  void expand(std::span<const T> x, std::span<const T> v, const T& t);
  /// How far the last series may be followed.
  double length() const { return length_; }
  /// The coefficient of time^k of coordinate i: of x for i < m, of v for the others; 0 <= k <= order.
  const T& coefficient(int i, int k) const {
    const auto row = static_cast<std::size_t>(i < m_ ? i : i - m_);
    return (i < m_ ? x_ : v_)[row * width_ + static_cast<std::size_t>(k)];
  }
  /// Coordinate i at a time after the state of the last series.
  T at(int i, const T& tau) const;
  int order() const { return settings_.order; }

 private:
  std::size_t index(int node, int k) const {
    return static_cast<std::size_t>(node) * width_ + static_cast<std::size_t>(k);
  }
  void coefficients(int k);
  void operation(std::size_t node, int k);
  void absolute(std::size_t node, int k);
  T product(int a, int b, int from, int to, int k) const;
  T weighted(int a, int b, int k) const;
  double step_length();
  double to_corner(double length) const;

  SmoothTape tape_;
  Settings settings_;
  int m_;
  std::size_t width_;
  std::vector<T> whole_;   ///< 0, 1, ..., order + 1
  std::vector<T> values_;  ///< a row of coefficients for each node
  std::vector<T> x_, v_;   ///< a row of coefficients for each coordinate
  std::vector<int> side_;  ///< of each |u|: the sign of u, 0 while unknown
  double largest_x_ = 0, largest_v_ = 0;
  double length_ = 0;
};

/// x and v after a time, by as many series as it takes.
///
/// throws  Undefined  when that are more than kMostSeriesOfFollow: where a run has exploded, series are short
/// without end
inline constexpr int kMostSeriesOfFollow = 500;
template <class T>
void follow(TaylorFlow<T>& flow, std::vector<T>& x, std::vector<T>& v, T& t, const T& duration);

}  // namespace shortfall
