// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/ball.hpp"

namespace shortfall {

/// The circle's constant.
Ball pi(int bits);

}  // namespace shortfall
