// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/series/structure.hpp"

namespace shortfall {

/// What a step does to the energy v^2/2 + V(x), for x'' = -V'(x): it changes by h^order times the terms, and
/// by higher powers of h.
///
/// The derivative of the energy along the modified field is a sum over free trees, each a contraction of its
/// own, so that all coefficients have to vanish. Source: as below.
struct EnergyChange {
  struct Term {
    std::string contraction;  ///< V''(V', v)
    Fraction coefficient;
  };
  int order = 0;  ///< the first power of h with a change; 0 when there is none up to `looked_at`
  int looked_at = 0;
  std::vector<Term> terms;
};

/// param   highest  power of h that is looked at
/// throws  Unable, Undefined  when the step has no series
EnergyChange energy_change(const SeriesSource& source, int highest);

/// Whether a step keeps v^2/2 + V itself, for x'' = -V'(x), per tree: the derivative of the energy along the
/// modified equation vanishes. Refuted at the first order at which it does not.
///
/// Source: Faou, Hairer & Pham (2004), Energy conservation with non-symplectic methods, BIT 44.
Property energy_preserving(const SeriesSource& source, int order);

/// Whether a change of variables makes the step symplectic, per tree: then it keeps a modified energy in the
/// long run as symplectic steps do. Found order by order, c with L_n + [c, F] Hamiltonian, by exact linear
/// algebra. What c leaves open is a c that is Hamiltonian itself, and that changes nothing; this is checked,
/// and a step is refuted only where it holds.
///
/// Sources: Hairer, Lubich & Wanner (2006), VI.8; Hairer & Zbinden (2013), On conjugate symplecticity of
/// B-series integrators, IMA J. Numer. Anal. 33.
Property conjugate_symplectic(const SeriesSource& source, int order);
/// The same of a modified field in trees of Signature::mechanical(false, false).
template <class K>
Property conjugate_symplectic(const SeriesSource& source, const TreeTable& table, TreeSeries<K> field);

}  // namespace shortfall
