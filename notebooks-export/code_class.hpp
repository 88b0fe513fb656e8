// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// An integrator as a class of a language (VelocityVerlet), with a comment that says what it gets wrong under
/// gravity and what repairs that, and a check of itself against shortfall's own run. One operation of the
/// file is one of the code, in binary32 in C#, C++ and Rust and in binary64 elsewhere.
///
/// throws  Unable  when a stage stays implicit, or the language cannot say something
std::string integrator_code(const Program& program, const Values& given, int substeps, Language language);

}  // namespace shortfall
