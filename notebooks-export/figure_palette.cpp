// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_palette.hpp"

#include <algorithm>
#include <cmath>

namespace shortfall {

namespace {

using Ink = Figure::Ink;

constexpr double kSmallLetters = 4.5;

double linear(int part) {
  const double c = part / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const Colour& c) {
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

}  // namespace

Colour colour(Ink ink) {
  switch (ink) {
    case Ink::black:
      return {0x22, 0x22, 0x22};
    case Ink::grey:
      return {0x8a, 0x8a, 0x8a};
    case Ink::dark:
      return {0x5a, 0x5a, 0x5a};
    case Ink::blue:
      return {0x00, 0x72, 0xb2};
    case Ink::sky:
      return {0x56, 0xb4, 0xe9};
    case Ink::green:
      return {0x00, 0x9e, 0x73};
    case Ink::orange:
      return {0xe6, 0x9f, 0x00};
    case Ink::vermillion:
      return {0xd5, 0x5e, 0x00};
    case Ink::purple:
      return {0xcc, 0x79, 0xa7};
  }
  return {};
}

Colour text_colour(Ink ink) {
  constexpr int kSteps = 100;
  const Colour full = colour(ink);
  for (int step = kSteps; step > 0; --step) {
    const auto part = [&](int value) { return value * step / kSteps; };
    const Colour darker{part(full.red), part(full.green), part(full.blue)};
    if (contrast(darker, {255, 255, 255}) >= kSmallLetters) return darker;
  }
  return {};
}

double contrast(const Colour& a, const Colour& b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace shortfall
