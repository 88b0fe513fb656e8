// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access.hpp"
#include "native/refusals.hpp"
#include "tests/native/same_bits.hpp"

namespace shortfall::native {
namespace {

TEST_CASE("the whole catalogue is written as C++, or says why not") {
  std::size_t written = 0;
  visit_catalogue([&]<template <class, class, class> class Class>(const char*) { ++written; });
  for (const Refusal& r : kRefusals) MESSAGE(r.integrator << ": " << r.reason);
  CHECK(kRefusals.empty());
  CHECK(written + kRefusals.size() == catalogue().size());
}

TEST_CASE("native runs have the bits of the interpreter's in binary32") {
  CHECK(check_catalogue<float>([](const Rational& r) { return r.to_float(); }, 1, 300) > 600);
}

TEST_CASE("native runs have the bits of the interpreter's in binary64") {
  CHECK(check_catalogue<double>([](const Rational& r) { return r.to_double(); }, 2, 300) > 600);
}

TEST_CASE("native runs have the bits of the interpreter's in x87") {
  const BinaryFormat storage = float_format("x87").storage();
  const std::function<long double(long double, long)> scaled = [](long double value, long e) {
    return std::ldexp(value, static_cast<int>(e));
  };
  CHECK(check_catalogue<long double>(
            [&](const Rational& r) {
              return stored_as<long double>(r, storage, Rounding::nearest_even,
                                            std::numeric_limits<long double>::infinity(), scaled);
            },
            3, 200) > 600);
}

}  // namespace
}  // namespace shortfall::native
