// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/readings.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/taylor_numbers.hpp"

namespace shortfall {

using Kind = SceneObservable::Kind;

namespace {

int side_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

bool is_top(Kind kind) { return kind == Kind::peak || kind == Kind::apex_time; }

}  // namespace

double energy_scale(double first_energy, double first_kinetic_energy) {
  if (first_energy != 0) return std::fabs(first_energy);
  return first_kinetic_energy > 0 ? first_kinetic_energy : 1;
}

template <class T>
SceneObserver<T>::SceneObserver(const Scene& scene, TaylorFlow<T>& flow,
                                std::function<T(const Rational&)> number, const T& end)
    : scene_(scene),
      flow_(flow),
      number_(std::move(number)),
      end_(end),
      m_(scene.coordinates()),
      tops_(scene.observables.size()),
      last_(scene.observables.size()),
      times_(scene.observables.size()),
      next_time_(scene.observables.size(), 0),
      values_(scene.observables.size()) {
  for (const SceneEvent& e : scene.events)
    events_.push_back(
        {(e.of_velocity ? m_ : 0) + e.body * scene.dimension + e.axis, number_(e.level), e.direction});
  // Of forty thousand swings of a clock the first and the last are looked at.
  for (Watch& w : events_) w.wanted = {0};
  for (const SceneObservable& o : scene.observables)
    if (o.event)
      events_[static_cast<std::size_t>(*o.event)].wanted.push_back(static_cast<std::size_t>(o.count) - 1);
  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    const SceneObservable& o = scene.observables[i];
    apexes_.push_back({m_ + o.body * scene.dimension + o.axis, number_(0), -1});
    if (o.kind == Kind::position || o.kind == Kind::velocity) times_[i].push_back(number_(o.at));
    if (o.kind == Kind::path)
      for (int k = 1; k <= o.count; ++k) times_[i].push_back(end * number_(Rational(k, o.count)));
    if (o.kind == Kind::energy_drift && !energy_) energy_.emplace(*energy_tape(scene));
  }
}

template <class T>
void SceneObserver<T>::frame(const T& t, const std::vector<T>& x, const std::vector<T>& v) {
  const bool first = !started_;
  started_ = true;
  before_ = t_;
  std::swap(x_before_, x_);
  std::swap(v_before_, v_);
  t_ = t;
  x_ = x;
  v_ = v;
  for (std::size_t i = 0; i < events_.size(); ++i) {
    look(events_[i], first);
    if (scene_.events[i].ends && !ending_ && !events_[i].passings.empty())
      ending_ = events_[i].passings[0].time;
  }
  for (std::size_t i = 0; i < apexes_.size(); ++i) {
    const SceneObservable& o = scene_.observables[i];
    if (!is_top(o.kind)) continue;
    const int c = apexes_[i].coordinate - m_;
    const bool within = !(rough(t_) > rough(end_));
    if (o.at_frames) {
      if (within) top(i, x_[static_cast<std::size_t>(c)], t_);
      continue;
    }
    // Between frames: where it turns, and where it begins and ends. Frames beside a turn are as high, to
    // rounding.
    const std::size_t known = apexes_[i].passings.size();
    look(apexes_[i], first);
    if (apexes_[i].passings.size() > known &&
        !(rough(apexes_[i].passings.back().time) > rough(end_) * (1 + 1e-13))) {
      const Passing& p = apexes_[i].passings.back();
      top(i, p.place[static_cast<std::size_t>(o.axis)], p.time);
    }
    if (first) top(i, x_[static_cast<std::size_t>(c)], t_);
    if (within)
      last_[i] = {true, x_[static_cast<std::size_t>(c)], t_};
    else if (rough(before_) < rough(end_))  // the end lies between two frames
      last_[i] = {true, follow_to(end_)[static_cast<std::size_t>(c)], end_};
  }
  if (!first) at_times();
  if (energy_ && !(rough(t_) > rough(end_) * (1 + 1e-12))) {
    std::vector<double> state;
    for (const T& value : x_) state.push_back(rough(value));
    for (const T& value : v_) state.push_back(rough(value));
    double e = 0;
    (*energy_)(state.data(), state.data() + m_, rough(t_), m_, &e);
    if (first) {
      double kinetic = 0;
      for (int i = 0; i < m_; ++i) {
        const double mass = scene_.bodies[static_cast<std::size_t>(i / scene_.dimension)].mass.to_double();
        kinetic +=
            mass / 2 * state[static_cast<std::size_t>(m_ + i)] * state[static_cast<std::size_t>(m_ + i)];
      }
      first_energy_ = e;
      energy_scale_ = energy_scale(e, kinetic);
    }
    const double off = std::fabs(e - first_energy_) / energy_scale_;
    if (!(off <= drift_)) drift_ = off;
  }
}

template <class T>
void SceneObserver<T>::top(std::size_t observable, const T& height, const T& time) {
  Top& best = tops_[observable];
  if (best.any && !(best.height < height)) return;
  best = {true, height, time};
}

template <class T>
void SceneObserver<T>::look(Watch& watch, bool first) {
  const auto c = static_cast<std::size_t>(watch.coordinate % m_);
  const T& now = watch.coordinate < m_ ? x_[c] : v_[c];
  const int side = side_of(rough(T(now - watch.level)));
  if (side == 0) return;
  const int before = watch.side;
  watch.side = side;
  if (first || before == 0 || before == side) return;
  if (watch.direction != 0 && watch.direction != side) return;
  if (!watch.wanted.empty() && std::ranges::find(watch.wanted, watch.passings.size()) == watch.wanted.end()) {
    watch.passings.push_back({before_, {}});
    return;
  }
  const T frame = t_ - before_;
  const T tau = root(watch, frame * T(3.0)).value_or(frame * T(0.5));
  const T time = before_ + tau;
  const std::vector<T> state = follow_to(time);
  const int body = static_cast<int>(c) / scene_.dimension;
  const auto place = state.begin() + body * scene_.dimension;
  watch.passings.push_back({time, std::vector<T>(place, place + scene_.dimension)});
}

/// How long after the frame before a coordinate of the true motion passes the level.
template <class T>
std::optional<T> SceneObserver<T>::root(const Watch& watch, const T& limit) {
  constexpr int kSamples = 8;
  std::vector<T> x = x_before_, v = v_before_;
  T t = before_, offset = T(0.0);
  const int from = -watch.side;
  for (int series = 0; rough(offset) < rough(limit) && series < kMostSeriesOfFollow; ++series) {
    flow_.expand(x, v, t);
    const double length = std::min(flow_.length(), rough(T(limit - offset)));
    const auto g = [&](const T& tau) { return T(flow_.at(watch.coordinate, tau) - watch.level); };
    for (int s = 1; s <= kSamples; ++s) {
      double high = length * s / kSamples, low = length * (s - 1) / kSamples;
      if (side_of(rough(g(T(high)))) == from) continue;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        (side_of(rough(g(T(middle)))) == from ? low : high) = middle;
      }
      // The last digits by Newton's iteration.
      T tau = T(high);
      for (int round = 0; round < 4; ++round) {
        T slope = T(0.0);
        for (int k = flow_.order(); k >= 1; --k)
          slope = slope * tau + T(static_cast<double>(k)) * flow_.coefficient(watch.coordinate, k);
        if (rough(slope) == 0) break;
        const T move = g(tau) / slope;
        if (std::fabs(rough(move)) > length) break;
        tau = tau - move;
      }
      return offset + tau;
    }
    const T step = T(length);
    std::vector<T> next_x = x, next_v = v;
    for (int i = 0; i < m_; ++i) {
      next_x[static_cast<std::size_t>(i)] = flow_.at(i, step);
      next_v[static_cast<std::size_t>(i)] = flow_.at(m_ + i, step);
    }
    x = next_x;
    v = next_v;
    t = t + step;
    offset = offset + step;
  }
  return std::nullopt;
}

/// The state at a time after the frame before: x, then v.
template <class T>
std::vector<T> SceneObserver<T>::follow_to(const T& time) {
  std::vector<T> x = x_before_, v = v_before_;
  T t = before_;
  follow(flow_, x, v, t, T(time - before_));
  x.insert(x.end(), v.begin(), v.end());
  return x;
}

template <class T>
void SceneObserver<T>::at_times() {
  for (std::size_t i = 0; i < times_.size(); ++i)
    for (; next_time_[i] < times_[i].size(); ++next_time_[i]) {
      const T& wanted = times_[i][next_time_[i]];
      if (rough(T(t_ - wanted)) < 0) break;
      // Followed from the nearer of the two frames: a frame that is meant to be at that time is read itself.
      const SceneObservable& o = scene_.observables[i];
      const bool is_frame = std::fabs(rough(T(t_ - wanted))) <= 1e-12 * std::fabs(rough(T(t_ - before_)));
      std::vector<T> state;
      if (is_frame) {
        state = x_;
        state.insert(state.end(), v_.begin(), v_.end());
      } else {
        state = follow_to(wanted);
      }
      if (o.kind == Kind::path) {
        const auto from = state.begin() + (o.of_body ? o.body * scene_.dimension : 0);
        values_[i].insert(values_[i].end(), from, from + (o.of_body ? scene_.dimension : m_));
      } else {
        const auto place = state.begin() + (o.kind == Kind::velocity ? m_ : 0) + o.body * scene_.dimension;
        values_[i].assign(place, place + scene_.dimension);
      }
    }
}

template <class T>
bool SceneObserver<T>::is_done() const {
  if (rough(t_) < rough(end_) * (1 - 1e-13)) return false;
  if (rough(t_) > 2 * rough(end_)) return true;
  for (std::size_t i = 0; i < scene_.observables.size(); ++i) {
    const SceneObservable& o = scene_.observables[i];
    if (o.event &&
        events_[static_cast<std::size_t>(*o.event)].passings.size() < static_cast<std::size_t>(o.count))
      return false;
    if (next_time_[i] < times_[i].size()) return false;
  }
  return true;
}

template <class T>
SceneReading<T> SceneObserver<T>::passing_reading(const SceneObservable& o) const {
  const SceneEvent& event = scene_.events[static_cast<std::size_t>(*o.event)];
  const std::vector<Passing>& passings = events_[static_cast<std::size_t>(*o.event)].passings;
  const auto count = static_cast<std::size_t>(o.count);
  if (passings.size() < count)
    return {false, "'" + event.name + "' is passed " +
                       (passings.empty() ? "never" : std::to_string(passings.size()) + " times") + ", not " +
                       std::to_string(count) + (count == 1 ? " time" : " times")};
  const Passing& last = passings[count - 1];
  switch (o.kind) {
    case Kind::event_place:
      return {true, {}, last.place};
    case Kind::period:
    case Kind::phase: {
      // Passings in both directions are half a period apart.
      const Rational share(event.direction == 0 ? 2 : 1, o.count - 1);
      const T period = (last.time - passings[0].time) * number_(share);
      if (o.kind == Kind::period) return {true, {}, {period}};
      return {true, {}, {last.time, period}};
    }
    default:
      return {true, {}, {last.time}};
  }
}

template <class T>
SceneReading<T> SceneObserver<T>::reading(std::size_t i) const {
  const SceneObservable& o = scene_.observables[i];
  switch (o.kind) {
    case Kind::peak:
    case Kind::apex_time: {
      if (!tops_[i].any) return {false, "there is no frame"};
      const Top& best = last_[i].any && tops_[i].height < last_[i].height ? last_[i] : tops_[i];
      return {true, {}, {o.kind == Kind::peak ? best.height : best.time}};
    }
    case Kind::energy_drift:
      if (!std::isfinite(drift_)) return {false, "the energy is not finite"};
      return {true, {}, {T(drift_)}};
    case Kind::position:
    case Kind::velocity:
    case Kind::path:
      if (next_time_[i] < times_[i].size()) return {false, "the run ends before"};
      return {true, {}, values_[i]};
    default:
      return passing_reading(o);
  }
}

template <class T>
std::vector<SceneReading<T>> SceneObserver<T>::readings() const {
  std::vector<SceneReading<T>> result;
  for (std::size_t i = 0; i < scene_.observables.size(); ++i) result.push_back(reading(i));
  return result;
}

template class SceneObserver<DoubleDouble>;
template class SceneObserver<Real>;

}  // namespace shortfall
