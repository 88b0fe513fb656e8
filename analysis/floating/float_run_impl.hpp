// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One arithmetic a file: each instantiates this with its number type, because that takes seconds to compile.

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/floating/float_run.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/tape_source.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

/// How a number type is made from exact numbers and read again.
template <class T>
struct FloatAccess {
  std::function<T(const Rational&)> rounded;
  std::function<FloatNumber(const T&)> exact;
  std::function<double(const T&)> rough;
  /// Around every step, where there is something to do: a rounding direction of the processor.
  std::function<void(const std::function<void()>&)> within;
};

/// A body on a line under a linear force: - k x - c v + f0 + t (f1 + t (...)), in the order that
/// FloatQuestion says.
template <class T>
struct LinearForceNumbers : Numbers<T> {
  std::vector<T> push;
  std::optional<T> k, c;
  T none{};
  bool time = false;  ///< whether anybody reads t

  bool reads_time() const { return time; }

  void accelerate(T& a, const T& x, const T& v, const T& t) {
    if constexpr (requires { set_sum(a, a, a); }) {
      accelerate_in_place(a, x, v, t);
    } else {
      a = value(x, v, t);
    }
  }

 private:
  T value(const T& x, const T& v, const T& t) const {
    T a = push.empty() ? none : push.back();
    for (std::size_t d = push.size(); d-- > 1;) a = push[d - 1] + t * a;
    bool begun = !push.empty();
    if (k) {
      a = begun ? a - *k * x : -(*k * x);
      begun = true;
    }
    if (c) a = begun ? a - *c * v : -(*c * v);
    return a;
  }

  /// The same operations; `a` may be one of the operands.
  void accelerate_in_place(T& a, const T& x, const T& v, const T& t) {
    if (k && !c && push.empty()) {  // nothing is read after it is written
      set_product(a, *k, x);
      set_negative(a, a);
      return;
    }
    sum_ = push.empty() ? none : push.back();
    for (std::size_t d = push.size(); d-- > 1;) {
      set_product(product_, t, sum_);
      set_sum(sum_, push[d - 1], product_);
    }
    bool begun = !push.empty();
    for (const auto& [factor, y] : {std::pair{&k, &x}, std::pair{&c, &v}}) {
      if (!*factor) continue;
      set_product(product_, **factor, *y);
      if (begun)
        set_difference(sum_, sum_, product_);
      else
        set_negative(sum_, product_);
      begun = true;
    }
    a = sum_;
  }

  T sum_{}, product_{};
};

/// Whether a step's own text reads t, apart from giving it to the force.
bool reads_time(const Tape& tape);

template <class T>
class TypedFloatRun : public FloatRun {
 public:
  TypedFloatRun(const FloatQuestion& q, FloatAccess<T> access)
      : access_(std::move(access)),
        tape_(lower_with_source(q.substeps > 1 ? substepped(q.program, q.substeps) : q.program,
                                parameter_values(q.program, q.parameters))) {
    within([&] {
      h_ = access_.rounded(q.kept_h.value_or(q.h));
      x0_ = access_.rounded(q.x0);
      v0_ = access_.rounded(q.v0);
      problem_.none = access_.rounded(0);
      for (int d = 0; d <= q.force.degree; ++d) {
        const auto f = q.force.push.find(d);
        problem_.push.push_back(access_.rounded(f == q.force.push.end() ? Rational() : f->second));
      }
      if (q.force.spring) problem_.k = access_.rounded(*q.force.k);
      if (q.force.damper) problem_.c = access_.rounded(*q.force.c);
      problem_.round = access_.rounded;
      problem_.time = q.force.degree > 0 || reads_time(tape_.first);
      run_ = std::make_unique<Run<LinearForceNumbers<T>>>(tape_.first, problem_, h_);
    });
    begin();
  }

  void begin() override {
    within([&] { run_->begin(x0_, v0_, problem_.none); });
  }
  void step() override {
    within([&] { run_->step(); });
  }
  std::pair<FloatNumber, FloatNumber> state() override {
    const std::pair<T, T> s = reported();
    return {access_.exact(s.first), access_.exact(s.second)};
  }
  std::pair<double, double> rough() override {
    const std::pair<T, T> s = reported();
    return {access_.rough(s.first), access_.rough(s.second)};
  }
  void carried(std::vector<double>& state) override {
    state.resize(tape_.first.states.size());
    for (std::size_t s = 0; s < state.size(); ++s) state[s] = access_.rough(run_->state(static_cast<int>(s)));
  }

  void begin(const Seen& seen) override {
    within([&] { run_->begin(x0_, v0_, problem_.none, watch(seen)); });
  }
  void step(const Seen& seen) override {
    within([&] { run_->step(watch(seen)); });
  }
  std::pair<FloatNumber, FloatNumber> state(const Seen& seen) override {
    std::pair<T, T> s;
    within([&] { s = run_->read_out(watch(seen)); });
    return {access_.exact(s.first), access_.exact(s.second)};
  }

  std::optional<std::pair<double, double>> rounding() override {
    if constexpr (requires(const T& x) { rounding_of(x); }) {
      const std::pair<T, T> s = reported();
      return std::pair{static_cast<double>(rounding_of(s.first)), static_cast<double>(rounding_of(s.second))};
    } else {
      return std::nullopt;
    }
  }

 private:
  template <class Work>
  void within(const Work& work) {
    if (access_.within)
      access_.within(work);
    else
      work();
  }
  std::pair<T, T> reported() {
    std::pair<T, T> s;
    within([&] { s = run_->read_out(); });
    return s;
  }
  auto watch(const Seen& seen) const {
    return [this, &seen](const Instruction& i, const T& value) {
      seen(tape_.second.statement_of(i), access_.exact(value));
    };
  }

  FloatAccess<T> access_;
  std::pair<Tape, TapeSource> tape_;
  LinearForceNumbers<T> problem_;
  std::unique_ptr<Run<LinearForceNumbers<T>>> run_;
  T h_{}, x0_{}, v0_{};
};

/// Numbers wrapped in something that has value(): Fused, Compensated, Tracked.
template <class Wrapped, class T>
FloatAccess<Wrapped> wrapped(const FloatAccess<T>& access) {
  FloatAccess<Wrapped> result;
  result.rounded = [r = access.rounded](const Rational& value) { return Wrapped(r(value)); };
  result.exact = [e = access.exact](const Wrapped& w) { return e(w.value()); };
  result.rough = [r = access.rough](const Wrapped& w) { return r(w.value()); };
  result.within = access.within;
  return result;
}

}  // namespace shortfall
