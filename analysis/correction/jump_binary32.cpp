// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/jump_binary32.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

namespace {

constexpr int kNeighbours = 4;  ///< looked at on each side of the bracket
constexpr int kLaunches = 40;   ///< a usual search, in whole flights: what a search must be able to afford

/// Positive floats in order: bits are whole numbers that count them.
std::int32_t place(float value) { return std::bit_cast<std::int32_t>(value); }
float float_at(std::int32_t place) { return std::bit_cast<float>(place); }

/// Gravity in binary32. A stage is settled by repetition, which under a constant force ends after a few
/// rounds.
struct Gravity {
  using Scalar = float;
  using Vector = float;

  float g;
  float push = 0;  ///< of a force that launches

  float number(const Rational& value) const { return value.to_float(); }
  std::optional<float> parameter(int, bool) const { return std::nullopt; }
  float zero() const { return 0; }
  float acceleration(float, float, float) const { return push - g; }
  float function(Function f, float a, float b) const { return value_of(f, a, b); }
  float root(const RealRoot& root, const std::string&) const { return near(root, 60).to_float(); }
  bool longer(float measured, float size, bool) const { return size < std::abs(measured); }
  float shortened(float v, float measured, float size) const { return size / std::abs(measured) * v; }

  template <class F>
  void solve(std::vector<float>& unknowns, F&& f) const {
    constexpr int kRounds = 100;
    for (int round = 0; round < kRounds; ++round) {
      std::vector<float> next = f(unknowns);
      std::swap(unknowns, next);
      if (unknowns == next) return;
    }
    throw Unable("an implicit stage does not settle in binary32 within " + std::to_string(kRounds) +
                 " rounds");
  }
};

/// Flights in binary32, counted.
class Flights {
 public:
  struct Top {
    float height = 0;
    std::int64_t n = 0;
  };

  Flights(const Flight& flight, float dt, float g, std::int64_t frame)
      : tape_(lower(flight.program(), flight.parameters())),
        problem_{.g = g},
        run_(tape_, problem_, dt),
        dt_(dt),
        by_(flight.launch_by()),
        force_frames_(flight.force_frames()),
        frame_(frame) {}

  /// The highest frame. Past the exact one it ends when the body falls, at the latest after twice the time.
  Top top(float launch) {
    problem_.push = 0;
    run_.begin(0, by_ == LaunchBy::velocity ? launch : 0, 0);
    if (by_ == LaunchBy::impulse) run_.give_impulse(launch);
    if (by_ == LaunchBy::force) problem_.push = launch / (static_cast<float>(force_frames_) * dt_);
    Top best;
    for (std::int64_t n = 1; n <= 2 * frame_ + 4; ++n) {
      run_.step();
      if (n >= force_frames_) problem_.push = 0;
      ++frames_;
      const float here = tape_.finish.empty() ? run_.state(0) : run_.read_out().first;
      if (here > best.height)
        best = {here, n};
      else if (n > frame_ && !(here >= best.height))
        break;
    }
    return best;
  }

  std::int64_t frames() const { return frames_; }

 private:
  Tape tape_;
  Gravity problem_;
  Run<Gravity> run_;
  float dt_;
  LaunchBy by_;
  int force_frames_;
  std::int64_t frame_;
  std::int64_t frames_ = 0;
};

class Search {
 public:
  Search(Flights& flights, float target, std::int64_t most)
      : flights_(flights), target_(target), most_(most) {}

  void run(float from) {
    const std::int32_t first = place(from);
    const int side = sign(first);
    std::int32_t near = first, far = first;
    for (std::int32_t stride = 1; side != 0 && affordable(); stride *= 2) {
      if (stride > place(from) / 4) return;
      near = far;
      far = first - side * stride;
      if (sign(far) != side) break;
    }
    while (std::abs(far - near) > 1 && best_miss_ != 0 && affordable()) {
      const std::int32_t middle = near + (far - near) / 2;
      (sign(middle) == side ? near : far) = middle;
    }
    for (int k = 1; k <= kNeighbours && best_miss_ != 0 && affordable(); ++k) {
      sign(std::min(near, far) - k);
      sign(std::max(near, far) + k);
    }
  }

  bool affordable() const { return flights_.frames() < most_; }
  float launch() const { return float_at(best_place_); }
  const Flights::Top& best() const { return best_; }
  int launches() const { return launches_; }

 private:
  /// Of top - target, for the launch at a place; remembers the best.
  int sign(std::int32_t at) {
    if (at <= 0) return -1;
    const Flights::Top top = flights_.top(float_at(at));
    ++launches_;
    const double miss = std::abs(static_cast<double>(top.height) - static_cast<double>(target_));
    if (launches_ == 1 || miss < best_miss_) {
      best_miss_ = miss;
      best_ = top;
      best_place_ = at;
    }
    return (top.height > target_) - (top.height < target_);
  }

  Flights& flights_;
  float target_;
  std::int64_t most_;
  int launches_ = 0;
  double best_miss_ = std::numeric_limits<double>::infinity();
  std::int32_t best_place_ = 0;
  Flights::Top best_;
};

}  // namespace

Binary32Search binary32_launch(const Flight& flight, const Rational& height, const Rational& g,
                               const Rational& launch, const Rational& frame, std::int64_t most) {
  Binary32Launch result;
  result.target = height.to_float();
  result.dt = flight.dt().to_float();
  result.g = g.to_float();
  const float from = launch.to_float();
  for (const auto& [what, value] : {std::pair{"the height", result.target},
                                    {"the time step", result.dt},
                                    {"gravity", result.g},
                                    {"the launch", from}})
    if (!std::isnormal(value)) return {{}, std::string(what) + " is out of the range of binary32"};

  if ((frame + 2) * flight.substeps() * kLaunches > most) {
    const Rational wanted = (frame + 2) * flight.substeps() * kLaunches;
    return {{},
            "the search would step about " + wanted.significant(2) + " frames in binary32; the limit is " +
                std::to_string(most)};
  }
  std::int64_t count = 0;
  frame.fits_int64(count);
  Flights flights(flight, result.dt, result.g, count);
  Search search(flights, result.target, most / flight.substeps());
  search.run(from);
  result.launch = search.launch();
  result.top = search.best().height;
  result.n = search.best().n;
  result.launches = search.launches();
  result.frames = flights.frames();
  if (!std::isfinite(result.top)) return {{}, "the flight leaves the range of binary32"};
  const float next = std::nextafter(result.target, std::numeric_limits<float>::infinity());
  const Rational target = Rational::from_double(result.target);
  const Rational top = Rational::from_double(result.top);
  result.miss = (top - target) / (Rational::from_double(next) - target);
  result.shortfall = height - top;
  return {result, {}};
}

}  // namespace shortfall
