// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/floating/double_double.hpp"
#include "analysis/trade/scene_model.hpp"
#include "analysis/trade/taylor_flow.hpp"

namespace shortfall {

/// What one motion shows of an observable.
template <class T>
struct SceneReading {
  bool found = false;
  std::string why{};  ///< "the ground is never reached", when it was not found
  /// One number (of a phase the time of its passing, then the period); the coordinates of a place; for a path
  /// all coordinates at all its times, one time after another.
  std::vector<T> value{};
};

/// Watches a motion frame by frame and reads the observables of a scene off it. T is DoubleDouble or Real.
///
/// Between two frames the motion is the true one through the first of them, followed with power series, so
/// that a reading between frames has no error but that of the frame before. An event is seen when a
/// coordinate is on different sides of its level at two frames that follow each other.
template <class T>
class SceneObserver {
 public:
  /// param  flow  the true motion
  ///        end   of the scene: its `until`, or the true time of the event that ends it
  SceneObserver(const Scene& scene, TaylorFlow<T>& flow, std::function<T(const Rational&)> number,
                const T& end);

  /// x and v have m coordinates each; times must grow.
  void frame(const T& t, const std::vector<T>& x, const std::vector<T>& v);
  /// Whether later frames cannot matter any more.
  bool is_done() const;
  /// The first passing of an event that ends the scene.
  const std::optional<T>& ending() const { return ending_; }
  std::vector<SceneReading<T>> readings() const;

 private:
  struct Passing {
    T time;
    std::vector<T> place;  ///< of the event's body
  };
  struct Watch {  ///< a coordinate and a level
    int coordinate;
    T level;
    int direction;
    int side = 0;  ///< at the last frame; 0 while it is on the level from the beginning
    std::vector<Passing> passings{};
    /// Which of them are looked at, by index; the others are only counted. Empty: all.
    std::vector<std::size_t> wanted{};
  };

  void look(Watch& watch, bool first);
  std::optional<T> root(const Watch& watch, const T& limit);
  std::vector<T> follow_to(const T& t);
  void at_times();
  void top(std::size_t observable, const T& height, const T& time);
  SceneReading<T> reading(std::size_t observable) const;
  SceneReading<T> passing_reading(const SceneObservable& o) const;

  const Scene& scene_;
  TaylorFlow<T>& flow_;
  std::function<T(const Rational&)> number_;
  T end_;
  int m_;
  T t_, before_;
  std::vector<T> x_, v_, x_before_, v_before_;
  bool started_ = false;
  std::vector<Watch> events_;
  std::vector<Watch> apexes_;  ///< one for each observable; of those that are no apex it watches nothing
  struct Top {
    bool any = false;
    T height, time;
  };
  std::vector<Top> tops_, last_;       ///< the highest so far, and the end, or the last frame before it
  std::vector<std::vector<T>> times_;  ///< at which each observable is read
  std::vector<std::size_t> next_time_;
  std::vector<std::vector<T>> values_;
  std::optional<TapeValues<double>> energy_;
  double first_energy_ = 0, energy_scale_ = 1, drift_ = 0;
  std::optional<T> ending_;
};

/// The largest |E - E0| of a scene is counted in this: |E0|, or the first kinetic energy where E0 is 0.
double energy_scale(double first_energy, double first_kinetic_energy);

}  // namespace shortfall
