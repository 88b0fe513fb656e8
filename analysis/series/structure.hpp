// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/series/step_series.hpp"

namespace shortfall {

/// Whether a step has a property: proved, refuted, or not contradicted up to an order.
struct Property {
  enum class Verdict { proved, refuted, not_contradicted };
  Verdict verdict = Verdict::not_contradicted;
  int up_to = 0;    ///< trees that were looked at, when not proved; where it fails, when refuted
  std::string how;  ///< a clause: "the step is a palindrome of kicks and drifts"

  bool holds() const { return verdict != Verdict::refuted; }
};

/// What follows from the structure of a step rather than from its accuracy.
///
/// Sources: Hairer, Lubich & Wanner (2006), II.3 (adjoint), V.2 (symmetric methods), VI.4, VI.7
/// (symplecticity: Lasagni, Sanz-Serna, Suris 1988), IX.9 (per tree).
struct Structure {
  /// The step with -h undoes the step. For every force; with a clause when only for a(x, t).
  Property symmetric;
  /// The area of phase space is kept, for a = -V'(x) or -V'(x, t).
  Property symplectic;
  /// A change of variables makes it symplectic; looked at where it is not symplectic itself.
  std::optional<Property> conjugate_symplectic;
  /// v^2/2 + V itself is kept, for a = -V'(x).
  Property energy_preserving;
  /// Of tableaus: every stage is right to this order (the simplifying condition C).
  std::optional<int> stage_order;
  std::optional<int> embedded_order;
  std::optional<bool> row_sums;  ///< c = A 1
};

/// throws  Unable, Undefined  when the step has no series
Structure structure(const SeriesSource& source);

/// That of a tableau's embedded result; conditions are looked at up to `highest`.
int embedded_order(const SeriesSource& source, int highest);

}  // namespace shortfall
