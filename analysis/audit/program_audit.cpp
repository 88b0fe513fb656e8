// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/program_audit.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/free_flight.hpp"
#include "analysis/audit/method.hpp"
#include "analysis/audit/tableau_mends.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/program/print.hpp"
#include "analysis/series/separable_order.hpp"
#include "analysis/series/splitting_reading.hpp"
#include "analysis/stability/stability_claims.hpp"

namespace shortfall {

namespace {

using Verdict = AuditClaim::Verdict;

constexpr double kClaimCost = 7;  // a claim that is wrong, rather than the step
constexpr const char* kNoOrder = "no order: a free body does not move along a line at its velocity";

std::string rounded(const KnownDigits& k) {
  const Rational middle = k.ball().midpoint();
  if (k.ball().is_exact()) return middle.digits() <= 24 ? middle.str() : "≈ " + middle.significant(8);
  const Rational width = Rational(1) / Rational(10).pow(60),
                 simple = simplest_between(middle - width, middle + width);
  return k.digits() >= 60 && simple.digits() <= 12 ? simple.str() : "≈ " + middle.significant(8);
}

/// A series of order one exists, with exact numbers: then both sums are 1, which is more than many digits.
bool is_consistent(const Program& program) {
  if (program.approximate()) return false;
  try {
    OrderLimits limits;
    limits.highest = 1;
    return order_of_class(SeriesSource(program, {}), force_class("position_only"), limits).order == 1;
  } catch (const Error&) {
    return false;
  }
}

void add_sums(const Program& program, std::vector<AuditClaim>& claims) {
  const auto sums = step_sums(program);
  if (!sums) return;
  const bool proved = is_consistent(program);
  const auto add = [&](const std::string& what, const KnownDigits& sum) {
    const KnownDigits defect = sum - KnownDigits(1);
    AuditClaim c;
    c.claim = "the " + what + " add up to 1";
    c.verdict = is_nothing(defect) ? Verdict::holds : Verdict::refuted;
    c.found = "the " + what + " add up to " + (is_nothing(defect) ? "1" : rounded(sum));
    c.digits = is_nothing(defect) && !defect.is_zero() && !proved ? defect.digits() : 0;
    c.stated = false;
    claims.push_back(std::move(c));
  };
  add("drifts", sums->drift);
  add("kicks", sums->kick);
}

/// Each claim by itself: one that cannot be decided leaves the others alone.
void add_expected(const Program& program, std::vector<AuditClaim>& claims) {
  for (const Claim& claim : program.claims) {
    Program alone = program;
    alone.claims = {claim};
    AuditClaim c;
    c.claim = claim.str();
    c.place = claim.place;
    try {
      const ClaimVerdict v = all_claims(alone).at(0);
      c.claim = v.claim;
      c.verdict = v.holds ? Verdict::holds : Verdict::refuted;
      c.found = v.found;
      c.digits = v.digits;
      // Trees that were looked at contradict nothing: less than a proof.
      c.proved = c.verdict != Verdict::holds || v.trees_up_to == 0;
    } catch (const Undefined& e) {
      // A step without order has none of the properties that orders speak of.
      if (claim.word == "order" || claim.word == "embedded-order") c.verdict = Verdict::refuted;
      c.found = c.verdict == Verdict::refuted ? kNoOrder : e.what();
    } catch (const Error& e) {
      c.found = e.what();
    }
    claims.push_back(std::move(c));
  }
}

void add_order(const Program& program, const OrderDemand& demand, const AuditLimits& limits,
               std::vector<AuditClaim>& claims) {
  AuditClaim c;
  const std::string forces = " if " + demand.forces->force;
  c.claim = "order " + std::to_string(demand.order) + forces;
  c.digits = printed_digits(program);
  for (const AuditClaim& s : claims)
    if (!s.stated && s.verdict == Verdict::refuted) c.reasons.push_back(s.found);
  if (!c.reasons.empty()) {
    c.verdict = Verdict::refuted;
    c.found = "order 0" + forces;
    c.digits = 0;
    claims.push_back(std::move(c));
    return;
  }
  try {
    const SeriesSource source(program, {});
    OrderLimits order_limits;
    order_limits.highest = demand.order + 1;
    order_limits.most_bytes = limits.most_bytes;
    const OrderOfClass found = order_of_class(source, *demand.forces, order_limits);
    const bool unknown = found.at_least && found.order < demand.order;
    c.verdict = unknown                       ? Verdict::undecided
                : found.order == demand.order ? Verdict::holds
                                              : Verdict::refuted;
    c.found = unknown ? "the conditions up to order " + std::to_string(found.order) +
                            " hold; the trees of the next order need more than the memory allowed"
                      : "order " + std::to_string(found.order) + (found.at_least ? " or more" : "") + forces;
    if (found.order < demand.order && !unknown) {
      for (std::size_t k = 0; k < std::min(kMostReasons, found.errors.size()); ++k) {
        const ErrorTerm& e = found.errors[k];
        const std::string formula = print(source.formula(e.coefficient));
        const bool is_short = formula.size() <= 40 && source.digits() == 0;
        c.reasons.push_back("error of " + e.component + ": " +
                            (is_short ? formula : "≈ " + source.decimal(e.coefficient, 6)) + " h^" +
                            std::to_string(e.order) + " " + e.differential);
      }
      if (found.errors.size() > kMostReasons)
        c.reasons.push_back("and " + std::to_string(found.errors.size() - kMostReasons) +
                            " more of this order");
    }
  } catch (const Undefined&) {
    c.verdict = Verdict::refuted;
    c.found = kNoOrder;
  } catch (const Unable& e) {
    c.found = e.what();
  }
  claims.push_back(std::move(c));
}

template <class Field>
bool is_palindrome(const SplittingParts<Field>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& other = parts[parts.size() - 1 - i];
    if (parts[i].kick != other.kick || !is_nothing(parts[i].weight - other.weight)) return false;
  }
  return true;
}

void add_facts(const Program& program, const std::optional<OrderDemand>& demand, const AuditLimits& limits,
               Audit& audit) {
  const SplittingReading reading = splitting_reading(program);
  std::visit(
      [&](const auto& parts) {
        if constexpr (requires { parts.step; }) {
          audit.kind = "splitting";
          audit.facts.push_back(
              std::to_string(parts.step.size()) + " kicks and drifts" +
              (is_palindrome(parts.step) ? ", a palindrome: symmetric" : ", no palindrome"));
          if (!parts.time_follows_drifts)
            audit.facts.emplace_back("the force is not taken at the time that the drifts have reached");
        }
      },
      reading.parts);
  try {
    const SeriesSource source(program, {});
    OrderLimits order_limits;
    order_limits.highest = demand ? demand->order + 1 : 6;
    order_limits.most_bytes = limits.most_bytes / 4;
    for (const char* key : {"general", "velocity_independent", "autonomous", "position_only"}) {
      const OrderOfClass found = order_of_class(source, force_class(key), order_limits);
      audit.facts.push_back("order " + std::to_string(found.order) + (found.at_least ? " or more" : "") +
                            " for " + found.forces->force);
    }
    for (const std::string& note : source.notes()) audit.notes.push_back(note);
  } catch (const Error&) {
    audit.facts.emplace_back(kNoOrder);
  }
}

}  // namespace

namespace {

/// Of the orders that are claimed the highest one refuted: what a mend has to restore. Where none is, the
/// highest one: what it has to keep, which is cheaper to see than most other claims.
std::optional<OrderDemand> demanded(const Program& program, const std::vector<AuditClaim>& claims) {
  std::optional<OrderDemand> result;
  bool of_refuted = false;
  for (const Claim& claim : program.claims) {
    // A mend is looked for in trees of x' = v.
    if (claim.word != "order" || claim.forces == separable_forces().force) continue;
    const bool refuted = std::ranges::any_of(
        claims, [&](const AuditClaim& c) { return c.claim == claim.str() && c.verdict == Verdict::refuted; });
    std::int64_t order = 0;
    if (!claim.value->value.fits_int64(order) || order < 1 || (of_refuted && !refuted)) continue;
    if (result && of_refuted == refuted && result->order >= order) continue;
    of_refuted = refuted;
    result =
        OrderDemand{static_cast<int>(order), &force_class(claim.forces.empty() ? "general" : claim.forces)};
  }
  return result;
}

/// Without any order claimed: that the drifts and kicks add up to 1 where they do not.
std::optional<OrderDemand> consistency(const std::vector<AuditClaim>& claims) {
  const bool fails = std::ranges::any_of(
      claims, [](const AuditClaim& c) { return !c.stated && c.verdict == Verdict::refuted; });
  if (!fails) return std::nullopt;
  return OrderDemand{1, &force_class("position_only")};
}

/// The claims of a program about its tableau.
TableauClaims tableau_claims(const Program& program, const std::optional<OrderDemand>& demand) {
  TableauClaims result;
  for (const Claim& claim : program.claims) {
    std::int64_t order = 0;
    const bool number = claim.value && claim.value->value.fits_int64(order);
    if (claim.word == "order" && claim.forces.empty() && number)
      result.order = {static_cast<int>(order), claim.place};
    if (claim.word == "embedded-order" && number)
      result.embedded_order = {static_cast<int>(order), claim.place};
    if (claim.word == "symplectic") result.symplectic = {true, claim.place};
    if (claim.word == "symmetric") result.symmetric = {true, claim.place};
  }
  if (demand) result.order = {demand->order, {}};
  return result;
}

/// c = A 1, and misprints among the entries.
void add_tableau(const Program& program, const std::optional<OrderDemand>& demand, const AuditLimits& limits,
                 Audit& audit) {
  AuditedTableau t(program);
  t.claims = tableau_claims(program, demand);
  const TableauFindings found = findings(t, limits);
  for (const AuditClaim& c : found.claims)
    if (!c.stated) audit.claims.insert(audit.claims.begin(), c);
  audit.kind = "Runge-Kutta tableau";
  for (Mend& mend : tableau_mends(t, found, limits)) {
    if (mend.kind == Mend::Kind::claim) continue;
    if (mend.restores == kEveryClaim)
      mend.restores = "every claim about the tableau";  // no other was decided anew
    audit.mends.push_back(std::move(mend));
  }
}

}  // namespace

Audit audit_program(const Program& program, const std::string& text, const std::optional<OrderDemand>& demand,
                    const AuditLimits& limits) {
  Audit audit;
  audit.name = program.name;
  audit.file = program.file;
  audit.kind = "integrator";
  audit.digits = printed_digits(program);
  const Decide decide = [&](const Program& p) {
    std::vector<AuditClaim> claims;
    add_sums(p, claims);
    add_expected(p, claims);
    if (demand) add_order(p, *demand, limits, claims);
    return claims;
  };
  audit.claims = decide(program);
  add_facts(program, demand, limits, audit);
  if (program.tableau) {
    add_tableau(program, demand, limits, audit);
  } else if (!text.empty()) {
    std::optional<OrderDemand> wanted = demand ? demand : demanded(program, audit.claims);
    if (!wanted) wanted = consistency(audit.claims);
    audit.mends = program_mends(text, program, audit.claims, wanted, decide, limits);
  }
  const bool explained = !audit.mends.empty() && audit.mends.front().restores.starts_with(kEveryClaim);
  for (const AuditClaim& c : audit.claims)
    if (c.verdict == Verdict::refuted && c.stated && !explained)
      audit.mends.push_back({Mend::Kind::claim,
                             {{c.claim, c.claim, c.found}},
                             "the claim is wrong",
                             "this claim",
                             0,
                             c.digits,
                             kClaimCost});
  return audit;
}

}  // namespace shortfall
