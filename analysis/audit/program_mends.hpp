// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/audit/audit.hpp"
#include "analysis/program/program.hpp"
#include "analysis/series/order.hpp"

namespace shortfall {

/// An order that a step is said to have, for a class of forces.
struct OrderDemand {
  int order = 0;
  const ForceClass* forces = nullptr;
};

/// What became of all claims of a program, in a fixed order; computed for the program as it is and for every
/// mended one.
using Decide = std::function<std::vector<AuditClaim>(const Program&)>;

/// Slips in the text of an integrator which, undone, let refuted claims hold; the most probable first.
///
/// A number that may be wrong is an unknown: the sums of kicks and of drifts give it, or else the lowest
/// condition of the order demanded that depends on it. Signs, names, times of the force, neighbouring lines,
/// kick and drift are tried.
std::vector<Mend> program_mends(const std::string& text, const Program& program,
                                const std::vector<AuditClaim>& claims,
                                const std::optional<OrderDemand>& demand, const Decide& decide,
                                const AuditLimits& limits);

/// Whether every condition up to an order holds; the order found at most that high. 0 for steps without
/// order.
int order_up_to(const Program& program, const OrderDemand& demand, double most_bytes);

}  // namespace shortfall
