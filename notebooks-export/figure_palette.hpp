// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "notebooks-export/figure.hpp"

namespace shortfall {

/// A colour of a screen, sRGB, each part from 0 to 255.
struct Colour {
  int red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};

/// What an ink looks like in regions, curves and marks.
///
/// source  Okabe & Ito (2008), Color Universal Design
Colour colour(Figure::Ink ink);

/// The same for letters: darkened until it stands out from white as small letters have to, 4.5 to 1.
Colour text_colour(Figure::Ink ink);

/// How much a colour stands out from another: 1 for the same, 21 for black and white.
///
/// source  WCAG 2.1, contrast ratio
double contrast(const Colour& a, const Colour& b);

}  // namespace shortfall
