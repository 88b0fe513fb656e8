// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/program.hpp"

namespace shortfall {

/// The integrator that takes `count` steps of h / count for each step of its own; its h is the frame.
///
/// throws  BadInput  when count is not from 1 to 10000
Program substepped(const Program& program, int count);

}  // namespace shortfall
