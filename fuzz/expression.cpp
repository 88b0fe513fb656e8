// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas as they are typed after --x.
#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/source.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Names names;
  names.declare("x0", {Sort::vector, kLength});
  names.declare("v0", {Sort::vector, kVelocity});
  names.declare("t", {Sort::scalar, kTime});
  names.declare("h", {Sort::scalar, kTime});
  names.declare("n", {});
  names.force = false;
  names.functions = Functions::all;
  names.symbolic_powers = true;
  std::string printed;
  try {
    printed = print(parse_formula(text_of(data, size), "--x", names, {Sort::vector, kLength}));
  } catch (const Error&) {
    return 0;
  }
  if (printed.size() > Source::kLongestLine)
    return 0;  // 1e775 is printed with all its digits, and a line has a limit
  try {
    const Expr again = parse_formula(printed, "printed", names, {Sort::vector, kLength});
    require(print(again) == printed, "a formula prints to another one");
  } catch (const Error& e) {
    require(false, e.what());
  }
  return 0;
}
