// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers, alone and with units: what is read prints to the same number.
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/trade/physical_quantity.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  std::optional<Rational> value;
  try {
    value = Rational::parse(text);
  } catch (const Error&) {
  }
  if (value) try {
      require(Rational::parse(value->str()) == *value, "a number prints to another one");
      require(*value - *value == Rational(0), "a number is not itself");
    } catch (const Error& e) {
      require(false, e.what());
    }
  try {
    physical_quantity(text);
  } catch (const Error&) {
  }
  return 0;
}
