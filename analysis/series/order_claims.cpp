// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/order_claims.hpp"

#include <algorithm>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"
#include "analysis/series/order.hpp"
#include "analysis/series/separable_order.hpp"
#include "analysis/series/structure.hpp"

namespace shortfall {

namespace {

std::string condition(const Claim& claim) { return claim.forces.empty() ? "" : " if " + claim.forces; }

ClaimVerdict order_verdict(const SeriesSource& source, const Claim& claim) {
  std::int64_t claimed = 0;
  claim.value->value.fits_int64(claimed);
  OrderLimits limits;
  limits.highest = static_cast<int>(claimed) + 1;  // a higher order than claimed is a wrong claim, too
  ClaimVerdict verdict{claim.str(), false, {}, source.digits()};
  OrderOfClass found;
  if (claim.forces == separable_forces().force) {
    const SeparableOrder separable = separable_order(source, limits);
    if (!separable.order) {
      verdict.found = separable.why_not;
      return verdict;
    }
    found = *separable.order;
  } else {
    found = order_of_class(source, force_class(claim.forces.empty() ? "general" : claim.forces), limits);
  }
  if (found.at_least && found.order < claimed)
    throw Unable("'" + claim.str() + "' is not decided: " + found.too_many);
  verdict.holds = !found.at_least && found.order == claimed;
  verdict.found =
      "order " + std::to_string(found.order) + (found.at_least ? " or more" : "") + condition(claim);
  return verdict;
}

ClaimVerdict embedded_verdict(const SeriesSource& source, const Claim& claim) {
  std::int64_t claimed = 0;
  claim.value->value.fits_int64(claimed);
  const int found = embedded_order(source, static_cast<int>(claimed) + 1);
  return {claim.str(), found == claimed,
          claim.word + " " + std::to_string(found) + (found > claimed ? " or more" : ""), source.digits()};
}

ClaimVerdict property_verdict(const SeriesSource& source, const Claim& claim, const Property& p) {
  std::string found = p.how;
  if (p.verdict == Property::Verdict::refuted) found = "not " + claim.word + ": " + p.how;
  if (p.verdict == Property::Verdict::not_contradicted && p.up_to > 0)
    found = claim.word + " as far as trees up to order " + std::to_string(p.up_to) + " tell";
  return {claim.str(), p.holds(), found, source.digits(),
          p.verdict == Property::Verdict::not_contradicted ? p.up_to : 0};
}

}  // namespace

bool about_series(const Claim& claim) {
  return claim.word == "order" || claim.word == "embedded-order" || claim.word == "symplectic" ||
         claim.word == "symmetric";
}

std::vector<ClaimVerdict> order_claims(const Program& program) {
  std::vector<ClaimVerdict> verdicts;
  if (std::ranges::none_of(program.claims, about_series)) return verdicts;
  const SeriesSource source(program, {});
  std::optional<Structure> found;
  for (const Claim& claim : program.claims) {
    if (!about_series(claim)) continue;
    if (claim.word == "order") {
      verdicts.push_back(order_verdict(source, claim));
    } else if (claim.word == "embedded-order") {
      verdicts.push_back(embedded_verdict(source, claim));
    } else {
      if (!found) found = structure(source);
      verdicts.push_back(
          property_verdict(source, claim, claim.word == "symplectic" ? found->symplectic : found->symmetric));
    }
  }
  return verdicts;
}

}  // namespace shortfall
