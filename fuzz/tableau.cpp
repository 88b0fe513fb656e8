// SPDX-License-Identifier: GPL-3.0-or-later
// Tableaus in JSON.
#include "analysis/algebra/error.hpp"
#include "analysis/program/tableau_file.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    parse_tableau(text_of(data, size), "fuzz");
  } catch (const Error&) {
  }
  return 0;
}
