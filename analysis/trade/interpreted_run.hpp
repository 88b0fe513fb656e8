// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "analysis/native/native_run.hpp"

namespace shortfall {

/// An integrator that has no compiled code (a file of the user's), or numbers that have none (DoubleDouble),
/// run by the interpreter behind the same door; in float and double with the same bits, and several times
/// slower.
template <class S>
std::unique_ptr<NativeRun<S>> interpreted_run(const Program& program, const Values& parameters,
                                              const Rational& h, std::size_t dimension,
                                              ForceReference<S> force);

}  // namespace shortfall
