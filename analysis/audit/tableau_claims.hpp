// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/audit/audit.hpp"
#include "analysis/audit/conditions.hpp"
#include "analysis/audit/tableau_numbers.hpp"

namespace shortfall {

/// What was found out about a tableau.
struct TableauFindings {
  std::vector<AuditClaim> claims;
  std::vector<std::string> facts;
  int order = 0;
  bool order_at_least = false;  ///< memory ended the search
  int embedded_order = 0;
  int digits = 0;
};

/// Proves or refutes every claim of a tableau, c = A 1 included.
TableauFindings findings(const AuditedTableau& t, const AuditLimits& limits);

/// The demands that a file's claims make of its entries.
Demands demands_of(const AuditedTableau& t);

/// Calls use(method) with the numbers in which claims are decided.
template <class Use>
decltype(auto) with_numbers(const AuditedTableau& t, Use&& use) {
  if (t.numbers == AuditedTableau::Numbers::rational) return use(t.rational);
  if (t.numbers == AuditedTableau::Numbers::roots) return use(t.roots);
  return use(t.digits);
}

/// A number of a tableau for a reader: exact, or rounded with a sign that says so.
std::string number_text(const AuditedTableau& t, const Rational& value);
std::string number_text(const AuditedTableau& t, const Fraction& value);
std::string number_text(const AuditedTableau& t, const KnownDigits& value);

}  // namespace shortfall
