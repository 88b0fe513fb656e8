// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only the files that are compiled for a family each include this: it takes seconds.

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_table.hpp"
#include "analysis/native/vectors.hpp"

namespace shortfall::native {

template <class S>
S nearest(const Rational& value) {
  if constexpr (std::is_same_v<S, float>)
    return value.to_float();
  else
    return value.to_double();
}

/// A force that is called by reference and counted. It gets copies, so that what is stepped can stay in
/// registers.
template <class S, class V>
struct CountedForce {
  ForceReference<S> force;
  std::int64_t* count;

  V operator()(const V& x, const V& v, const S& t) const {
    ++*count;
    if constexpr (std::is_same_v<V, S>) {
      const S position = x, velocity = v;
      S a{};
      force(std::span<const S>(&position, 1), std::span<const S>(&velocity, 1), t, std::span<S>(&a, 1));
      return a;
    } else {
      V a = ComponentsOf<V>::made(x.size());
      force(std::span<const S>(x.data(), x.size()), std::span<const S>(v.data(), v.size()), t,
            std::span<S>(a.data(), a.size()));
      return a;
    }
  }
};

template <template <class, class, class> class Class, class S, class V>
class NativeRunOf : public NativeRun<S> {
 public:
  explicit NativeRunOf(const NativeSetup<S>& setup)
      : dimension_(setup.dimension),
        stepper_(
            setup.h, zero(), Force{setup.force, &evaluations_},
            [](const char* text) { return nearest<S>(Rational::parse(text)); },
            parameters(setup.parameters)) {}
  NativeRunOf(const NativeRunOf&) = delete;
  NativeRunOf& operator=(const NativeRunOf&) = delete;

  void begin(std::span<const S> x0, std::span<const S> v0, S t0) override {
    stepper_.begin(vector(x0), vector(v0), t0);
  }
  void run(std::int64_t steps) override { stepper_.run(steps); }
  void read_out(std::span<S> x, std::span<S> v) const override {
    const auto [position, velocity] = stepper_.read_out();
    copy(position, x);
    copy(velocity, v);
  }
  S time() const override { return stepper_.time(); }
  void give_impulse(std::span<const S> impulse) override {
    if constexpr (Stepper::kReadsImpulse)
      stepper_.give_impulse(vector(impulse));
    else
      throw BadInput("this integrator knows no impulse");
  }
  std::int64_t force_evaluations() const override { return evaluations_; }
  std::size_t dimension() const override { return dimension_; }

 private:
  using Force = CountedForce<S, V>;
  using Stepper = Class<S, V, Force>;

  static typename Stepper::Parameters parameters(const Values& values) {
    typename Stepper::Parameters p([](const char* text) { return nearest<S>(Rational::parse(text)); });
    for (const auto& [name, value] : values) {
      std::int64_t whole = 0;
      value.fits_int64(whole);
      p.set(name, nearest<S>(value), static_cast<int>(whole));
    }
    return p;
  }

  V zero() const {
    if constexpr (std::is_same_v<V, S>)
      return S();
    else
      return V(dimension_);
  }

  void check(std::size_t size) const {
    if (size != dimension_)
      throw Error("a run in " + std::to_string(dimension_) + " dimensions was given a vector of " +
                  std::to_string(size));
  }
  V vector(std::span<const S> values) const {
    check(values.size());
    if constexpr (std::is_same_v<V, S>) {
      return values[0];
    } else {
      V result(dimension_);
      std::copy(values.begin(), values.end(), result.data());
      return result;
    }
  }
  void copy(const V& from, std::span<S> to) const {
    check(to.size());
    if constexpr (std::is_same_v<V, S>)
      to[0] = from;
    else
      std::copy_n(from.data(), dimension_, to.data());
  }

  std::size_t dimension_;
  mutable std::int64_t evaluations_ = 0;
  Stepper stepper_;
};

template <template <class, class, class> class Class, class S>
std::unique_ptr<NativeRun<S>> made(const NativeSetup<S>& setup) {
  if (setup.dimension == 1) return std::make_unique<NativeRunOf<Class, S, S>>(setup);
  // binary32 does without, for the time that it takes to compile.
  if constexpr (std::is_same_v<S, double>) {
    if (setup.dimension == 2) return std::make_unique<NativeRunOf<Class, S, FixedVector<S, 2>>>(setup);
    if (setup.dimension == 3) return std::make_unique<NativeRunOf<Class, S, FixedVector<S, 3>>>(setup);
  }
  return std::make_unique<NativeRunOf<Class, S, BoundedVector<S, kMostNativeComponents>>>(setup);
}

}  // namespace shortfall::native
