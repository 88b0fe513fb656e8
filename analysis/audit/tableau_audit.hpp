// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/audit/audit.hpp"
#include "analysis/program/tableau_file.hpp"

namespace shortfall {

/// What a tableau file claims, decided; decimals that stand for known numbers; probable misprints.
Audit audit_tableau(const TableauFile& file, const AuditLimits& limits = {});

}  // namespace shortfall
