// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/correction/kit_numbers.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// A derivation under a linear force as a person reads it: answer, reasons, corrections, conserved energy,
/// proofs.
///
/// param   full  long rational functions are written out where they stand, see named_formulas.hpp
std::string as_text(const LinearDerivation& derivation, const LinearKit& kit, Style style, bool full = false);

/// The kit alone.
std::string as_text(const LinearKit& kit, Style style, bool full = false);

/// The kit in numbers, for one step length.
std::string as_text(const KitNumbers& numbers, const LinearKit& kit, const Rational& h);
nlohmann::ordered_json as_json(const KitNumbers& numbers);

/// amsmath.
std::string as_latex(const LinearDerivation& derivation, const LinearKit& kit, bool full = false);

/// Schema shortfall.derive/1.
nlohmann::ordered_json as_json(const LinearDerivation& derivation, const LinearKit& kit);

/// Schema shortfall.correct/1.
nlohmann::ordered_json as_json(const LinearKit& kit, const LinearDerivation& derivation);

}  // namespace shortfall
