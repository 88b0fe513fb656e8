// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/geometric_flight.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr int kRecurrence = 3;  // of the recurrence of 1, n, ratio^n

using Samples = std::vector<Rational>;

/// The sum through the first three values, once its ratio is known.
GeometricSum fitted(const Samples& v, const Rational& ratio) {
  const Rational less = ratio - 1;
  GeometricSum sum;
  sum.gain = (v[2] - v[1] - (v[1] - v[0])) / (less * less);
  sum.slope = v[1] - v[0] - sum.gain * less;
  sum.constant = v[0] - sum.gain;
  return sum;
}

/// How the second differences change, where they are not 0.
std::optional<Rational> ratio_of(const Samples& v) {
  const Rational first = v[2] - v[1] - (v[1] - v[0]), second = v[3] - v[2] - (v[2] - v[1]);
  if (first.is_zero()) return std::nullopt;
  return second / first;
}

bool fits(const GeometricSum& sum, const Rational& ratio, const Samples& values) {
  Rational power = 1;
  for (std::size_t k = 0; k < values.size(); ++k, power *= ratio)
    if (sum.constant + sum.slope * k + sum.gain * power != values[k]) return false;
  return true;
}

}  // namespace

Rational GeometricFlight::at(const GeometricSum& sum, const Rational& n) const {
  const Rational after = n - from;
  std::int64_t count = 0;
  if (sum.gain.is_zero()) return sum.constant + sum.slope * after;
  if (!after.fits_int64(count) || count < 0 || count > kDigits / static_cast<std::int64_t>(ratio.digits()))
    throw Unable("frame " + n.str() + " of a damped flight is a fraction of more than " +
                 std::to_string(kDigits) + " digits");
  return sum.constant + sum.slope * after + sum.gain * ratio.pow(static_cast<int>(count));
}

std::optional<Rational> GeometricFlight::top(const Surd& launch, const Rational& g) const {
  if (ratio.sign() <= 0 || ratio >= 1) return std::nullopt;
  const Surd steady = launch * Surd(rise.slope) - Surd(g * fall.slope);
  const Surd fading = (launch * Surd(rise.gain) - Surd(g * fall.gain)) * Surd(ratio - 1);
  if (steady.sign() >= 0 || fading.sign() <= 0) return std::nullopt;
  const double estimate = std::log((-steady / fading).to_double()) / std::log1p((ratio - 1).to_double());
  const auto most = static_cast<double>(kDigits) / static_cast<double>(ratio.digits());
  if (!(std::abs(estimate) < most))
    throw Unable("the top of the flight is beyond frame " + std::to_string(static_cast<std::int64_t>(most)) +
                 ", where exact fractions have more than " + std::to_string(kDigits) + " digits");
  const auto rises = [&](int k) { return (steady + fading * Surd(ratio.pow(k))).sign() > 0; };
  int k = std::max(0, static_cast<int>(std::ceil(estimate)));
  while (rises(k)) ++k;
  while (k > 0 && !rises(k - 1)) --k;
  return from + Rational(k);
}

namespace {

/// Rise and fall of as many frames as prove a form.
std::pair<Samples, Samples> compared(const FrameOf& frame, int from, int order) {
  std::pair<Samples, Samples> values;
  for (int k = 0; k < order + kRecurrence + 2; ++k) {
    const auto [up, down] = frame(static_cast<std::size_t>(from + k));
    values.first.push_back(up);
    values.second.push_back(down);
  }
  return values;
}

/// The parabola through all values, the first of which is that of n = from.
std::optional<std::array<Rational, 3>> parabola_through(const Samples& v, int from) {
  const Rational half = (v[2] - v[1] - (v[1] - v[0])) / 2;
  const Rational slope = v[1] - v[0] - half;
  for (std::size_t k = 0; k < v.size(); ++k)
    if (v[0] + slope * k + half * k * k != v[k]) return std::nullopt;
  return std::array<Rational, 3>{v[0] - slope * from + half * from * from, slope - 2 * half * from, half};
}

}  // namespace

std::optional<ParabolicFlight> parabolic_flight(const FrameOf& frame, int order, int first) {
  for (int from = first; from <= first + order; ++from) {
    const auto [rises, falls] = compared(frame, from, order);
    const auto rise = parabola_through(rises, from);
    const auto fall = parabola_through(falls, from);
    if (rise && fall) return ParabolicFlight{from, *rise, *fall};
  }
  return std::nullopt;
}

std::optional<GeometricFlight> geometric_flight(const FrameOf& frame, int order, int first) {
  for (int from = first; from <= first + order; ++from) {
    const auto [rise, fall] = compared(frame, from, order);
    std::optional<Rational> ratio = ratio_of(fall);
    if (!ratio || ratio->is_one()) ratio = ratio_of(rise);
    if (!ratio || ratio->is_one()) continue;
    GeometricFlight flight{from, *ratio, fitted(rise, *ratio), fitted(fall, *ratio)};
    if (fits(flight.rise, *ratio, rise) && fits(flight.fall, *ratio, fall)) return flight;
  }
  return std::nullopt;
}

}  // namespace shortfall
