// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_format.hpp"
#include "analysis/floating/small_float.hpp"
#include "tests/native/same_bits.hpp"

namespace shortfall::native {
namespace {

template <class T>
Round<T> stored(const char* format) {
  return [storage = float_format(format).storage()](const Rational& value) {
    const auto r = rounded(value, storage);
    return T(r ? r->to_double() : value.sign() < 0 ? -HUGE_VAL : HUGE_VAL);
  };
}

TEST_CASE("native runs have the bits of the interpreter's in binary16") {
  CHECK(check_catalogue<Binary16>(stored<Binary16>("f16"), 4, 100) > 600);
}

TEST_CASE("native runs have the bits of the interpreter's in bfloat16") {
  CHECK(check_catalogue<BFloat16>(stored<BFloat16>("bf16"), 5, 100) > 600);
}

}  // namespace
}  // namespace shortfall::native
