// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/dimension.hpp"

namespace shortfall {

namespace {

std::string power(const char* base, int exponent) {
  return exponent == 1 ? base : base + ("^" + std::to_string(exponent));
}

}  // namespace

std::string Dimension::str() const {
  std::string top;
  std::string bottom;
  for (auto [base, exponent] : {std::pair{"L", length}, std::pair{"T", time}}) {
    if (exponent > 0) top += (top.empty() ? "" : "*") + power(base, exponent);
    if (exponent < 0) bottom += "/" + power(base, -exponent);
  }
  return (top.empty() ? "1" : top) + bottom;
}

std::string Dimension::bracketed() const {
  std::string text;
  for (auto [base, exponent] : {std::pair{"L", length}, std::pair{"T", time}})
    if (exponent != 0) text += (text.empty() ? "" : " ") + power(base, exponent);
  return "[" + (text.empty() ? "1" : text) + "]";
}

std::string Type::str() const {
  return (sort == Sort::vector ? "vector " : "scalar ") + dimension.bracketed();
}

}  // namespace shortfall
