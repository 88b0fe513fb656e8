// SPDX-License-Identifier: GPL-3.0-or-later
// The .integrator language: what is read prints to a text that reads the same.
#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tape.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string printed;
  try {
    const Program program = parse(text_of(data, size), "fuzz");
    printed = print(program);
    lower(program, {});
  } catch (const Error&) {
    if (printed.empty()) return 0;
  }
  try {
    require(print(parse(printed, "printed")) == printed, "an integrator prints to another one");
  } catch (const Error& e) {
    require(false, e.what());
  }
  return 0;
}
