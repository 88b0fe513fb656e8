// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// The highest degree of a force polynomial for which a notebook is written.
inline constexpr int kHighestNotebookDegree = 30;

/// A derivation as a lecture: a Jupyter notebook whose text is followed, claim by claim, by cells that assert
/// it.
///
/// The cells need Python 3 and nothing else; they compute with fractions. The same question gives the same
/// bytes.
///
/// param   program       what was derived, without the substeps of the derivation
/// param   derivation    with its steps
/// param   jump_picture  a PNG that a reader sees without running the cells: the jump to 40 cm, under a
/// constant
///                       force; or empty
/// throws  Unable  for a degree above kHighestNotebookDegree
std::string notebook(const Program& program, const Values& given, const Derivation& derivation,
                     const CorrectionKit& kit, const std::string& jump_picture = {});

}  // namespace shortfall
