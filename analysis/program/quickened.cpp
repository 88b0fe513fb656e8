// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/quickened.hpp"

#include <optional>

namespace shortfall {
namespace {

using Kind = Instruction::Kind;

/// What a product is called that the next instruction reads; none where it is not read, or read twice.
std::optional<Kind> pair_with(const Instruction& product, const Instruction& next) {
  const bool left = next.a == product.out, right = next.b == product.out;
  if (left == right) return std::nullopt;
  if (next.kind == Kind::vector_add) return right ? Kind::scale_then_add : Kind::scale_then_added;
  if (next.kind == Kind::vector_subtract && right) return Kind::scale_then_subtract;
  return std::nullopt;
}

}  // namespace

Block quickened(Block block) {
  for (std::size_t i = 0; i + 1 < block.size(); ++i) {
    if (block[i].kind != Kind::scale) continue;
    if (const std::optional<Kind> both = pair_with(block[i], block[i + 1])) block[i++].kind = *both;
  }
  return block;
}

}  // namespace shortfall
