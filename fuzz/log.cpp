// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of positions: CSV, TSV, JSON lines.
#include "analysis/identify/log.hpp"
#include "analysis/algebra/error.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Log log = parse_log(text_of(data, size), "fuzz");
    require(log.rows.size() <= kMostRows, "a log with more rows than are kept");
  } catch (const Error&) {
  }
  return 0;
}
