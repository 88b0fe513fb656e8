// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of figures: how far apart they are for every colour vision, and how well letters stand out.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "notebooks-export/figure_palette.hpp"

namespace shortfall {
namespace {

using Ink = Figure::Ink;
using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

/// What is left of linear RGB without one kind of cones.
///
/// source  Machado, Oliveira & Fernandes (2009), severity 1
constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritanopia{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

Triple times(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::clamp(m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2], 0.0, 1.0);
  return result;
}

double linear(int part) {
  const double c = part / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* (1976) under D65.
Triple lab(const Triple& rgb) {
  const double x = (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505;
  const double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const double z = (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089;
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

double distance(Ink a, Ink b, const Matrix& vision) {
  const auto seen = [&](Ink ink) {
    const Colour c = colour(ink);
    return lab(times(vision, {linear(c.red), linear(c.green), linear(c.blue)}));
  };
  const Triple p = seen(a), q = seen(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Those that tell curves of one figure apart.
const std::vector<Ink> kCurves{Ink::blue, Ink::green, Ink::orange, Ink::vermillion, Ink::purple, Ink::black};
const std::vector<Ink> kAll{Ink::black, Ink::dark,   Ink::grey,       Ink::blue,  Ink::sky,
                            Ink::green, Ink::orange, Ink::vermillion, Ink::purple};

TEST_CASE("curves are told apart by every colour vision: never nearer than 15 in CIE 1976") {
  double worst = 1000;
  for (const Matrix& vision : {kNormal, kProtanopia, kDeuteranopia, kTritanopia})
    for (const Ink a : kCurves)
      for (const Ink b : kCurves)
        if (a != b) worst = std::min(worst, distance(a, b, vision));
  CAPTURE(worst);
  CHECK(worst > 15);    // 2.3 is just noticeable
  CHECK(worst < 17.1);  // blue and green without the short cones: the palette's weakest pair
}

TEST_CASE("letters stand out from white as small letters have to, lines at least 2 to 1") {
  for (const Ink ink : kAll) {
    CHECK(contrast(text_colour(ink), {255, 255, 255}) >= 4.5);
    CHECK(contrast(colour(ink), {255, 255, 255}) > 2.2);  // orange is the weakest; its name stands beside it
  }
  CHECK(text_colour(Ink::black) == colour(Ink::black));
  CHECK(contrast({0, 0, 0}, {255, 255, 255}) == doctest::Approx(21));
  CHECK(contrast({119, 119, 119}, {255, 255, 255}) ==
        doctest::Approx(4.48).epsilon(0.001));  // published example
}

}  // namespace
}  // namespace shortfall
