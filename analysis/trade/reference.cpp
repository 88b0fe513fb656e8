// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/taylor_numbers.hpp"

namespace shortfall {

using Kind = SceneObservable::Kind;

namespace {

constexpr int kFramesOfPiece = 12;  ///< looked at within one power series, so that no passing is missed
constexpr int kMostSeries = 2'000'000;

DoubleDouble narrowed(const DoubleDouble& a) { return a; }
DoubleDouble narrowed(const Real& a) {
  const double high = a.convert_to<double>();
  return {high, Real(a - high).convert_to<double>()};
}

/// One computation of the true motion.
template <class T>
class Computation {
 public:
  Computation(const Scene& scene, const ForceChoice& chosen, int order, double tolerance,
              std::function<T(const Rational&)> number)
      : scene_(scene), number_(std::move(number)) {
    // The truth has no frames: its top is where it turns.
    for (SceneObservable& o : scene_.observables) o.at_frames = false;
    settings_.order = order;
    settings_.tolerance = tolerance;
    settings_.longest = (scene.until / Rational(2)).to_double();
    settings_.number = number_;
    tape_ = acceleration_tape(scene, chosen);
    for (int f = 1; f <= kFramesOfPiece; ++f) shares_.push_back(number_(Rational(f, kFramesOfPiece)));
  }

  /// The observables up to a time; stops earlier where `ends` and an event ends the scene.
  SceneObserver<T> observe(const T& end, bool ends, const Progress& progress) {
    TaylorFlow<T> path(tape_, settings_);
    flow_.emplace(tape_, settings_);  // the observer's own
    SceneObserver<T> observer(scene_, *flow_, number_, end);
    std::vector<T> x, v;
    for (const SceneBody& b : scene_.bodies) {
      for (const Rational& c : b.position) x.push_back(number_(c));
      for (const Rational& c : b.velocity) v.push_back(number_(c));
    }
    const int m = path.coordinates();
    T t = number_(0);
    observer.frame(t, x, v);
    steps = 0;
    while (!observer.is_done() && !(ends && observer.ending())) {
      path.expand(x, v, t);
      // A last piece that ends at the end of the scene.
      const T left = end - t;
      const bool is_last = rough(left) > 0 && rough(left) <= path.length();
      const T length = is_last ? left : T(path.length());
      if (!(rough(length) > 1e-300) || ++steps > kMostSeries)
        throw Unable("the true motion of the scene '" + scene_.name +
                     "' cannot be followed beyond t = " + std::to_string(rough(t)) + " " + scene_.units.time);
      std::vector<T> to_x = x, to_v = v;
      for (int f = 1; f <= kFramesOfPiece; ++f) {
        const T tau = f == kFramesOfPiece ? length : T(length * shares_[static_cast<std::size_t>(f) - 1]);
        for (int i = 0; i < m; ++i) {
          to_x[static_cast<std::size_t>(i)] = path.at(i, tau);
          to_v[static_cast<std::size_t>(i)] = path.at(m + i, tau);
        }
        observer.frame(f == kFramesOfPiece && is_last ? end : T(t + tau), to_x, to_v);
        if (ends && observer.ending()) return observer;
      }
      t = is_last ? end : T(t + length);
      x = to_x;
      v = to_v;
      if (progress && steps % 16 == 0)
        progress("following the true motion", static_cast<int>(1000 * rough(t) / rough(end)), 1000);
    }
    return observer;
  }

  int steps = 0;

 private:
  Scene scene_;
  std::function<T(const Rational&)> number_;
  typename TaylorFlow<T>::Settings settings_;
  SmoothTape tape_;
  std::optional<TaylorFlow<T>> flow_;
  std::vector<T> shares_;  ///< 1/kFramesOfPiece, ..., 1
};

struct Found {
  DoubleDouble end;
  std::vector<SceneReading<DoubleDouble>> readings;
  int steps = 0;
};

template <class T>
Found compute(const Scene& scene, const ForceChoice& chosen, int order, double tolerance,
              const std::function<T(const Rational&)>& number, const Progress& progress,
              const std::optional<DoubleDouble>& given_end) {
  Computation<T> computation(scene, chosen, order, tolerance, number);
  T end = given_end ? T(given_end->high()) + T(given_end->low()) : number(scene.until);
  const bool ends =
      !given_end && std::ranges::any_of(scene.events, [](const SceneEvent& e) { return e.ends; });
  if (ends) {
    const auto first = computation.observe(end, true, progress);
    if (first.ending() && rough(*first.ending()) < rough(end)) end = *first.ending();
  }
  const auto observer = computation.observe(end, false, progress);
  Found result{narrowed(end), {}, computation.steps};
  for (const auto& r : observer.readings()) {
    SceneReading<DoubleDouble> reading{r.found, r.why, {}};
    for (const T& value : r.value) reading.value.push_back(narrowed(value));
    result.readings.push_back(std::move(reading));
  }
  return result;
}

double distance(const DoubleDouble* a, const DoubleDouble* b, int d) {
  double sum = 0;
  for (int i = 0; i < d; ++i) {
    const double off = rough(a[i] - b[i]);
    sum += off * off;
  }
  return std::sqrt(sum);
}

}  // namespace

double reading_error(const Scene& scene, std::size_t observable, const SceneReading<DoubleDouble>& exact,
                     const SceneReading<DoubleDouble>& computed) {
  const SceneObservable& o = scene.observables[observable];
  const int d = scene.dimension;
  switch (o.kind) {
    case Kind::position:
    case Kind::velocity:
    case Kind::event_place:
      return distance(exact.value.data(), computed.value.data(), d);
    case Kind::path: {
      double largest = 0;
      for (std::size_t i = 0; i + static_cast<std::size_t>(d) <= exact.value.size();
           i += static_cast<std::size_t>(d)) {
        const double off = distance(&exact.value[i], &computed.value[i], d);
        if (!(off <= largest)) largest = off;
      }
      return largest;
    }
    case Kind::energy_drift:
      return rough(computed.value[0]);
    case Kind::phase:
      return 2 * std::numbers::pi * rough((exact.value[0] - computed.value[0]) / exact.value[1]);
    default:
      return rough(exact.value[0] - computed.value[0]);
  }
}

SceneReference scene_reference(const Scene& scene, int digits, const ForceChoice& chosen,
                               const Progress& progress, const std::optional<DoubleDouble>& end) {
  for (const SceneObservable& o : scene.observables) {
    std::string why;
    if (o.kind == Kind::energy_drift && !energy_tape(scene, chosen, &why))
      throw Unable("energy-drift: the force '" + why + "' has no energy that could be kept");
  }
  SceneReference result;
  Found first, second;
  if (digits <= 30) {
    const std::function<DoubleDouble(const Rational&)> number = double_double;
    first = compute<DoubleDouble>(scene, chosen, 22, 1e-31, number, progress, end);
    second = compute<DoubleDouble>(scene, chosen, 28, 1e-33, number, progress, end);
    result.how = "power series of order 22 and 28";
  } else {
    if (digits > 250) throw BadInput("a reference has at most 250 digits");
    const int kept = digits + 12;
    const Precision precision(kept);
    const std::function<Real(const Rational&)> number = [kept](const Rational& r) { return real(r, kept); };
    const int order = static_cast<int>(digits * 0.9) + 8;
    first = compute<Real>(scene, chosen, order, std::pow(10.0, -digits - 2), number, progress, end);
    second =
        compute<Real>(scene, chosen, order + order / 4, std::pow(10.0, -digits - 6), number, progress, end);
    result.how =
        "power series of order " + std::to_string(order) + " and " + std::to_string(order + order / 4);
  }
  result.digits = digits;
  result.end = second.end;
  result.steps = std::max(first.steps, second.steps);
  result.readings = second.readings;
  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    const SceneObservable& o = scene.observables[i];
    if (!second.readings[i].found || !first.readings[i].found)
      throw Unable("the observable '" + o.name + "' has no true value: " + second.readings[i].why);
    const double off = o.kind == Kind::energy_drift
                           ? 0
                           : std::fabs(reading_error(scene, i, second.readings[i], first.readings[i]));
    if (!(off <= o.tolerance.to_double() / 1000))
      throw Unable("the true value of '" + o.name + "' is known only to " +
                   Rational::from_double(off).significant(2) + " " + o.unit + ", and the tolerance is " +
                   o.tolerance.significant(3) + " " + o.unit + ": look earlier, or allow more");
    result.uncertain.push_back(off);
    if (o.kind == Kind::energy_drift) result.readings[i].value = {DoubleDouble(0)};
  }
  return result;
}

}  // namespace shortfall
