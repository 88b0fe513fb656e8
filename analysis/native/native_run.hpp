// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "analysis/program/tape.hpp"

namespace shortfall {

/// An acceleration a(x, v, t) by reference: what it refers to has to live as long as it is called.
///
/// One call through a pointer an evaluation. The function writes the acceleration into its last argument,
/// which has as many components as x and v, and overlaps neither.
template <class S>
class ForceReference {
 public:
  using Function = void (*)(std::span<const S> x, std::span<const S> v, S t, std::span<S> a);

  ForceReference(Function f)  // NOLINT: converts on purpose
      : object_(reinterpret_cast<void*>(f)),
        call_([](void* object, std::span<const S> x, std::span<const S> v, S t, std::span<S> a) {
          reinterpret_cast<Function>(object)(x, v, t, a);
        }) {}

  template <class F>
  requires(std::is_class_v<F> && !std::is_same_v<std::remove_cv_t<F>, ForceReference>)
      ForceReference(F& f)  // NOLINT: converts on purpose
      : object_(const_cast<void*>(static_cast<const void*>(&f))),
        call_([](void* object, std::span<const S> x, std::span<const S> v, S t, std::span<S> a) {
          (*static_cast<F*>(object))(x, v, t, a);
        }) {}

  void operator()(std::span<const S> x, std::span<const S> v, S t, std::span<S> a) const {
    call_(object_, x, v, t, a);
  }

 private:
  void* object_;
  void (*call_)(void*, std::span<const S>, std::span<const S>, S, std::span<S>);
};

/// A trajectory by compiled code, with the bits of the interpreter's: in one dimension those of
/// `Run<Numbers<S>>`.
template <class S>
class NativeRun {
 public:
  virtual ~NativeRun() = default;
  /// throws  Error  when x0 or v0 have another number of components than the run
  virtual void begin(std::span<const S> x0, std::span<const S> v0, S t0) = 0;
  /// So many steps; the loop over them is inside.
  ///
  /// throws  Undefined  when a stage is singular
  virtual void run(std::int64_t steps) = 0;
  /// Position and velocity as they are reported.
  virtual void read_out(std::span<S> x, std::span<S> v) const = 0;
  virtual S time() const = 0;
  /// An impulse over the mass, which acts in the next step only.
  ///
  /// throws  BadInput  when the integrator reads none
  virtual void give_impulse(std::span<const S> impulse) = 0;
  /// How often the force has been evaluated since the run was made.
  virtual std::int64_t force_evaluations() const = 0;
  virtual std::size_t dimension() const = 0;
};

/// The most components that positions may have in a native run.
inline constexpr std::size_t kMostNativeComponents = 64;

/// Why an integrator has no native code: it is no integrator of the catalogue, or it cannot be written as
/// C++; nothing when it has.
std::optional<std::string> why_not_native(const Program& program);

/// An integrator of the catalogue under a force, compiled. One dimension has code of its own, in
/// binary64 two and three as well.
///
/// param   S           float or double
/// param   parameters  given values; the others have their defaults, each rounded once
/// param   h           the step
/// throws  Unable      when it has no native code, or the dimension is not from 1 to kMostNativeComponents;
///                     BadInput as `lower`
template <class S>
std::unique_ptr<NativeRun<S>> native_run(const Program& program, const Values& parameters, S h,
                                         std::size_t dimension, ForceReference<S> force);

}  // namespace shortfall
