// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Real numbers with so many digits that an error of h^10 or so is not drowned by rounding.

#include "analysis/algebra/real.hpp"

namespace shortfall::testing {

inline constexpr int kDigits = 60;

inline Real sixty_digits(const Rational& r) { return real(r, kDigits); }

}  // namespace shortfall::testing
