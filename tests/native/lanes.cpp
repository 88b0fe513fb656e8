// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/native/lanes.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_many.hpp"
#include "tests/native/same_bits.hpp"

namespace shortfall::native {
namespace {

/// Bends, drives, and divides: every lane has another value.
template <class S>
struct Bent {
  S k, c;
  template <class V>
  V operator()(const V& x, const V& v, const S& t) const {
    return -(k * x) / (S(1) + x * x) - c * v + t / S(8) * x / (S(1) + x * x);
  }
};

/// The written class on packs of the registers that every processor has, lane by lane beside itself.
template <class S, template <class, class, class> class Class>
void check_class(const char* name) {
  constexpr std::size_t kLanes = 64 / sizeof(S);
  using V = Lanes<S, kLanes, Sse2>;
  CAPTURE(name);
  const auto number = [](const char* text) {
    const Rational value = Rational::parse(text);
    return static_cast<S>(std::is_same_v<S, float> ? value.to_float() : value.to_double());
  };
  Draw draw{std::mt19937_64(21)};
  const Values drawn = drawn_parameters(find_integrator(name), draw);
  typename Class<S, V, Bent<S>>::Parameters parameters(number);
  typename Class<S, S, Bent<S>>::Parameters alone_parameters(number);
  for (const auto& [parameter, value] : drawn) {
    std::int64_t whole = 0;
    value.fits_int64(whole);
    const S stored = number(value.str().c_str());
    parameters.set(parameter, stored, static_cast<int>(whole));
    alone_parameters.set(parameter, stored, static_cast<int>(whole));
  }
  const Bent<S> force{number("2.3"), number("0.07")};
  const S h = number("0.031");
  Class<S, V, Bent<S>> together(h, V(S()), force, number, parameters);
  Class<S, S, Bent<S>> alone(h, S(), force, number, alone_parameters);
  V x0(S{}), v0(S{});
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    x0[lane] = number(draw(-2, 2).str().c_str());
    v0[lane] = number(draw(-3, 3).str().c_str());
  }
  together.begin(x0, v0, S());
  together.run(120);
  const auto [x, v] = together.read_out();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    alone.begin(x0[lane], v0[lane], S());
    alone.run(120);
    const auto [ax, av] = alone.read_out();
    CAPTURE(lane);
    CHECK(same(x[lane], ax));
    CHECK(same(v[lane], av));
  }
}

template <class S>
void bend(std::span<const S> x, std::span<const S> v, S t, std::span<S> a) {
  const Bent<S> force{S(2.3), S(0.07)};
  for (std::size_t i = 0; i < x.size(); ++i) a[i] = force(x[i], v[i], t);
}

/// 45 trajectories: whole registers, and some left over.
template <class S>
void check_many() {
  constexpr std::size_t kCount = 45;
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    Draw draw{std::mt19937_64(22)};
    const Values parameters = drawn_parameters(program, draw);
    std::vector<S> x, v;
    for (std::size_t i = 0; i < kCount; ++i) {
      x.push_back(static_cast<S>(draw(-2, 2).to_double()));
      v.push_back(static_cast<S>(draw(-3, 3).to_double()));
    }
    std::vector<S> ax = x, av = v;
    native_many<S>(program, parameters, S(0.03), bend<S>, x, v, S(0.5), 100);
    native_many<S>(program, parameters, S(0.03), bend<S>, ax, av, S(0.5), 100, NativeLanes::never);
    for (std::size_t i = 0; i < kCount; ++i) {
      CHECK(same(x[i], ax[i]));
      CHECK(same(v[i], av[i]));
    }
  }
}

TEST_CASE("each of many trajectories has the bits that it has alone, for every class") {
  visit_catalogue(
      []<template <class, class, class> class Class>(const char* name) { check_class<double, Class>(name); });
}

TEST_CASE("each of many trajectories has the bits that it has alone, in the registers of this processor") {
  if (!has_lanes(find_integrator("rk4")))
    MESSAGE("this processor has no AVX2: one by one is compared with itself");
  check_many<double>();
  check_many<float>();
}

TEST_CASE("starts that are no pairs, and integrators without code, are refused") {
  std::vector<double> x(3), v(2);
  CHECK_THROWS_AS(native_many<double>(find_integrator("rk4"), {}, 0.1, bend<double>, x, v, 0, 1), Error);
  std::vector<double> none;
  native_many<double>(find_integrator("rk4"), {}, 0.1, bend<double>, none, none, 0, 1);
  CHECK(none.empty());
}

}  // namespace
}  // namespace shortfall::native
