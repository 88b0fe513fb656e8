// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/traced_value.hpp"

namespace shortfall {

/// What a step carries besides x and v, and its parameters.
class Carried {
 public:
  /// A vector that was declared as a state; the step may assign to it.
  ///
  /// throws  BadInput  for one that was not declared
  TracedVector& vector(const std::string& name);
  /// A parameter.
  TracedScalar number(const std::string& name) const;

 private:
  friend class Tracing;
  std::vector<std::pair<std::string, TracedVector>> vectors_;
  std::vector<std::pair<std::string, TracedScalar>> numbers_;
};

/// From a function of C++ to an integrator: it is called with values that write down what is done to them.
///
/// A step is a function (auto& x, auto& v, auto t, auto h, auto a) that changes x and v, or one that takes
/// `auto& carried` besides. It may do what the .integrator language can say, in loops over plain numbers too;
/// one operation of C++ is one of the integrator's. What would make it depend on values does not compile.
class Tracing {
 public:
  explicit Tracing(std::string name) : name_(std::move(name)) {}

  /// A vector carried from step to step, with its dimension: "L/T^2". `start` gives it a value.
  Tracing& state(const std::string& name, const std::string& dimension);
  Tracing& parameter(const std::string& name, const Rational& value, const std::string& dimension = "1");
  Tracing& assume(const std::string& text);  ///< "1 - c*h > 0"
  Tracing& solves(const std::string& text);  ///< "a(x, v, t) - c*v"

  template <class F>
  Tracing& start(F f) {
    start_ = erased(std::move(f));
    return *this;
  }
  template <class F>
  Tracing& finish(F f) {
    finish_ = erased(std::move(f));
    return *this;
  }

  /// throws  BadInput  for a step that is not the same at every call, or computes with rounded numbers
  /// throws  SyntaxError  as for a file: dimensions that do not fit, with the line as it was traced
  template <class F>
  Program step(F f) const {
    return program(erased(std::move(f)));
  }

 private:
  using Step = std::function<void(TracedVector& x, TracedVector& v, const TracedScalar& t,
                                  const TracedScalar& h, const TracedForce& a, Carried& carried)>;
  struct Declaration {
    std::string name, line;
  };

  template <class F>
  static Step erased(F f) {
    return [f = std::move(f)](TracedVector& x, TracedVector& v, const TracedScalar& t, const TracedScalar& h,
                              const TracedForce& a, Carried& carried) mutable {
      if constexpr (std::is_invocable_v<F&, TracedVector&, TracedVector&, TracedScalar, TracedScalar,
                                        TracedForce, Carried&>)
        f(x, v, t, h, a, carried);
      else
        f(x, v, t, h, a);
    };
  }

  Program program(const Step& step) const;
  std::vector<Statement> block(const Step& f, const std::string& word) const;

  std::string name_;
  std::vector<Declaration> states_, parameters_;
  std::string head_;
  Step start_, finish_;
};

/// The integrator that a step is:
///
///     const Program mine = traced("my-loop", [](auto& x, auto& v, auto t, auto h, auto a) {
///       v += h * a(x, v, t);
///       x += h * v;
///     });
template <class F>
Program traced(const std::string& name, F step) {
  return Tracing(name).step(std::move(step));
}

}  // namespace shortfall
