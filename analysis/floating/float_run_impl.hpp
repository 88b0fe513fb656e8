// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One arithmetic a file: each instantiates this with its number type, because that takes seconds to compile.

#include <memory>
#include <utility>
#include <vector>

#include "analysis/floating/float_run.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

/// How a number type is made from exact numbers and read again.
template <class T>
struct FloatAccess {
  std::function<T(const Rational&)> rounded;
  std::function<FloatNumber(const T&)> exact;
  std::function<double(const T&)> rough;
  /// Around every step; for a rounding direction of the processor.
  std::function<void(const std::function<void()>&)> within = [](const std::function<void()>& work) {
    work();
  };
};

template <class T>
class TypedFloatRun : public FloatRun {
 public:
  TypedFloatRun(const FloatQuestion& q, FloatAccess<T> access)
      : access_(std::move(access)),
        tape_(lower(q.substeps > 1 ? substepped(q.program, q.substeps) : q.program,
                    parameter_values(q.program, q.parameters))) {
    access_.within([&] {
      h_ = access_.rounded(q.kept_h.value_or(q.h));
      x0_ = access_.rounded(q.x0);
      v0_ = access_.rounded(q.v0);
      zero_ = access_.rounded(0);
      for (int d = 0; d <= q.force.degree; ++d) {
        const auto f = q.force.push.find(d);
        push_.push_back(access_.rounded(f == q.force.push.end() ? Rational() : f->second));
      }
      if (q.force.spring) k_ = access_.rounded(*q.force.k);
      if (q.force.damper) c_ = access_.rounded(*q.force.c);
      problem_.round = access_.rounded;
      problem_.force = [this](const T& x, const T& v, const T& t) { return acceleration(x, v, t); };
      run_ = std::make_unique<Run<Numbers<T>>>(tape_, problem_, h_);
    });
    begin();
  }

  void begin() override {
    access_.within([&] { run_->begin(x0_, v0_, zero_); });
  }
  void step() override {
    access_.within([&] { run_->step(); });
  }
  std::pair<FloatNumber, FloatNumber> state() override {
    std::pair<T, T> s;
    access_.within([&] { s = run_->read_out(); });
    return {access_.exact(s.first), access_.exact(s.second)};
  }
  std::pair<double, double> rough() override {
    std::pair<T, T> s;
    access_.within([&] { s = run_->read_out(); });
    return {access_.rough(s.first), access_.rough(s.second)};
  }
  void carried(std::vector<double>& state) override {
    state.resize(tape_.states.size());
    for (std::size_t s = 0; s < state.size(); ++s) state[s] = access_.rough(run_->state(static_cast<int>(s)));
  }

 private:
  T acceleration(const T& x, const T& v, const T& t) const {
    T a = push_.empty() ? zero_ : push_.back();
    for (std::size_t d = push_.size(); d-- > 1;) a = push_[d - 1] + t * a;
    bool begun = !push_.empty();
    if (k_) {
      a = begun ? a - *k_ * x : -(*k_ * x);
      begun = true;
    }
    if (c_) a = begun ? a - *c_ * v : -(*c_ * v);
    return a;
  }

  FloatAccess<T> access_;
  Tape tape_;
  Numbers<T> problem_;
  std::unique_ptr<Run<Numbers<T>>> run_;
  T h_{}, x0_{}, v0_{}, zero_{};
  std::vector<T> push_;
  std::optional<T> k_, c_;
};

/// Numbers wrapped in something that has value(): Fused, Compensated.
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
