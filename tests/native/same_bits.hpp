// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "native/index.hpp"

namespace shortfall::native {

/// Whether two numbers are one: zeros with their signs, and no number equals no number.
template <class T>
bool same(const T& a, const T& b) {
  if constexpr (std::is_floating_point_v<T>)
    if (std::signbit(a) != std::signbit(b)) return std::isnan(a) && std::isnan(b);
  const auto is_number = [](const T& x) { return x == x; };  // NOLINT(misc-redundant-expression): NaN is not
  return a == b || (!is_number(a) && !is_number(b));
}

/// A force by reference: one type for all forces, so that every class is compiled once a number type.
template <class T>
struct AnyForce {
  const std::function<T(const T&, const T&, const T&)>* force;
  T operator()(const T& x, const T& v, const T& t) const { return (*force)(x, v, t); }
};

struct Draw {
  std::mt19937_64 generator;
  /// In [low, high], a multiple of 1/997 so that it is no short binary number.
  Rational operator()(int low, int high) {
    return Rational(std::uniform_int_distribution<int>(997 * low, 997 * high)(generator)) / Rational(997);
  }
};

template <class T>
using Round = std::function<T(const Rational&)>;

template <class T>
std::vector<std::pair<std::string, std::function<T(const T&, const T&, const T&)>>> forces(
    const Round<T>& round, Draw& draw) {
  T a = round(draw(-10, 10));
  const T k = round(draw(1, 9)), c = round(draw(0, 1)), one = round(1);
  return {{"constant", [=](const T&, const T&, const T&) { return a; }},
          {"spring", [=](const T& x, const T&, const T&) { return -(k * x); }},
          {"drag", [=](const T&, const T& v, const T&) { return a - c * v; }},
          {"driven", [=](const T& x, const T& v, const T& t) { return a * t - k * x - c * v; }},
          {"not linear",
           [=](const T& x, const T& v, const T& t) { return -(k * x) / (one + x * x) - c * v * v + t; }}};
}

/// What is given to the parameters of an integrator: numbers near their defaults, so that assumptions hold;
/// but limits so low that they act.
inline Values drawn_parameters(const Program& program, Draw& draw) {
  Values values = parameter_values(program);
  for (const Parameter& p : program.parameters) {
    Rational& value = values[p.name];
    if (p.dimension == kVelocity || p.dimension == kLength) {
      value = draw(0, 2) + Rational(1, 10);
      continue;
    }
    if (const auto whole = literal_value(p.fallback);
        whole && whole->is_integer() && p.dimension == Dimension{})
      value = whole->is_zero() ? draw(0, 1) / Rational(20) : *whole + Rational(1);
    else
      value = value * draw(1, 2) + draw(0, 1) / Rational(50);
  }
  return values;
}

/// Runs the interpreter and the written class side by side; where they first differ, or "".
template <class T, template <class, class, class> class Class>
std::string difference(const std::string& name, const Values* given, const Round<T>& round, Draw& draw,
                       const std::function<T(const T&, const T&, const T&)>& force, int steps) {
  const Program program = find_integrator(name);
  const Tape tape = given ? lower(program, *given) : lower(program);
  Numbers<T> problem;
  problem.force = force;
  problem.round = round;
  const T h = round(draw(1, 2) / Rational(20));
  Run<Numbers<T>> run(tape, problem, h);
  using Native = Class<T, T, AnyForce<T>>;
  const auto number = [&](const char* text) { return round(Rational::parse(text)); };
  typename Native::Parameters parameters(number);
  if (given)
    for (const auto& [parameter, value] : *given) {
      std::int64_t whole = 0;
      value.fits_int64(whole);
      CHECK(parameters.set(parameter, round(value), static_cast<int>(whole)));
    }
  Native native(h, round(0), AnyForce<T>{&force}, number, parameters);
  const T x0 = round(draw(-3, 3)), v0 = round(draw(-3, 3)), t0 = round(draw(0, 1));
  run.begin(x0, v0, t0);
  native.begin(x0, v0, t0);
  if constexpr (Native::kReadsImpulse) {
    const T impulse = round(draw(-2, 2));
    run.give_impulse(impulse);
    native.give_impulse(impulse);
  }
  for (int done = 0; done < steps;) {
    const int more = 1 + static_cast<int>(draw.generator() % 40);
    for (int n = 0; n < more; ++n) run.step();
    native.run(more);
    done += more;
    const auto carried = native.carried();
    for (std::size_t s = 0; s < carried.size(); ++s)
      if (!same(carried[s], run.state(static_cast<int>(s))))
        return tape.states[s] + " differs after " + std::to_string(done) + " steps";
    const auto [x, v] = run.read_out();
    const auto [nx, nv] = native.read_out();
    if (!same(x, nx) || !same(v, nv)) return "the read-out differs after " + std::to_string(done) + " steps";
    if (!same(run.time(), native.time())) return "t differs after " + std::to_string(done) + " steps";
  }
  return {};
}

/// The whole catalogue, all forces, with parameters at their defaults and drawn; how many runs were compared.
template <class T>
int check_catalogue(const Round<T>& round, int seed, int steps) {
  int compared = 0;
  visit_catalogue([&]<template <class, class, class> class Class>(const char* name) {
    Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
    const Program program = find_integrator(name);
    for (const auto& [title, force] : forces<T>(round, draw)) {
      const auto& what = title;
      CAPTURE(name);
      CAPTURE(what);
      CHECK(difference<T, Class>(name, nullptr, round, draw, force, steps) == "");
      const Values drawn = drawn_parameters(program, draw);
      CHECK(difference<T, Class>(name, &drawn, round, draw, force, steps) == "");
      compared += 2;
    }
  });
  return compared;
}

}  // namespace shortfall::native
