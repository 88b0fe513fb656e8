// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers, alone and with units: what is read prints to the same number.
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/trade/physical_quantity.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  try {
    const Rational value = Rational::parse(text);
    require(Rational::parse(value.str()) == value, "a number prints to another one");
    require(value - value == Rational(0), "a number is not itself");
  } catch (const Error&) {
  }
  try {
    physical_quantity(text);
  } catch (const Error&) {
  }
  return 0;
}
