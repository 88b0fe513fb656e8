// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/audit/program_mends.hpp"

namespace shortfall {

/// What an integrator's file claims, decided: its `expect` claims, and the order that it is said to have.
/// That the drifts of a step add up to 1, and its kicks too, goes without saying.
///
/// param   text  of the file, in which misprints are looked for; empty: none are
Audit audit_program(const Program& program, const std::string& text, const std::optional<OrderDemand>& demand,
                    const AuditLimits& limits = {});

}  // namespace shortfall
