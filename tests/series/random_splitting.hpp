// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/series/splitting_parts.hpp"
#include "tests/algebra/random.hpp"

namespace shortfall {

inline void showValue(const SplittingPart<Rational>& part, std::ostream& out) {
  out << (part.kick ? "kick " : "drift ") << part.weight.str();
}

namespace random {

/// Up to so many kicks and drifts, alternating.
inline rc::Gen<SplittingParts<Rational>> splitting(int most) {
  return rc::gen::map(rc::gen::pair(list(most, small_rational()), rc::gen::arbitrary<bool>()),
                      [](const std::pair<std::vector<Rational>, bool>& p) {
                        SplittingParts<Rational> parts;
                        bool kick = p.second;
                        for (const Rational& weight : p.first) {
                          parts.push_back({kick, weight});
                          kick = !kick;
                        }
                        return parts;
                      });
}

/// The same, with its kicks and its drifts making one step in the sum.
inline rc::Gen<SplittingParts<Rational>> consistent_splitting(int most) {
  return rc::gen::map(splitting(most), [](SplittingParts<Rational> parts) {
    Rational kicks, drifts;
    for (const auto& p : parts) (p.kick ? kicks : drifts) += p.weight;
    parts.push_back({true, Rational(1) - kicks});
    parts.push_back({false, Rational(1) - drifts});
    return parts;
  });
}

}  // namespace random
}  // namespace shortfall
