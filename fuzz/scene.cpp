// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in TOML, with their units, numbers and expressions.
#include "analysis/trade/scene.hpp"
#include "analysis/algebra/error.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    scene_of(text_of(data, size), "fuzz");
  } catch (const Error&) {
  }
  return 0;
}
