// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/tableau_audit.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/audit/exact_values.hpp"
#include "analysis/audit/tableau_mends.hpp"

namespace shortfall {

Audit audit_tableau(const TableauFile& file, const AuditLimits& limits) {
  const AuditedTableau t(file);
  Audit audit;
  audit.name = t.name;
  audit.file = t.program.file;
  audit.kind = t.nystroem ? "Nystroem tableau" : "Runge-Kutta tableau";
  TableauFindings found = findings(t, limits);
  try {
    audit.mends = tableau_mends(t, found, limits);
  } catch (const Unable& e) {
    audit.notes.push_back(std::string("misprints were not looked for: ") + e.what());
  }
  if (auto mend = exact_values(t, limits)) audit.mends.push_back(std::move(*mend));
  audit.claims = std::move(found.claims);
  audit.facts = std::move(found.facts);
  audit.digits = found.digits;
  return audit;
}

}  // namespace shortfall
