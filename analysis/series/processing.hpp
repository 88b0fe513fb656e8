// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/series/modified.hpp"

namespace shortfall {

/// What may be done to a step besides a launch and a read-out.
struct ProcessingQuestion {
  const ForceClass* forces = nullptr;
  int order = 0;               ///< the effective order that is wanted; 0: as high as it goes
  bool correct_force = false;  ///< the step may be given another force, of the position alone
  int highest = 6;             ///< for order 0
  OrderLimits limits;
};

/// A launch P, done once at the start, and the read-out that undoes it, such that P, n steps, P^-1 are of a
/// higher order than the steps themselves.
///
/// P = exp(c_{p-1}) ... exp(c_1), the leftmost done first, with c_k a combination of trees of order k; the
/// c_k are found one after the other, by exact linear algebra, from [c_{n-1}, F] = -L_n. A system that has no
/// solution is a proof that no launch exists; which combination of coefficients proves it is the obstruction.
///
/// Sources: Butcher (1969), The effective order of Runge-Kutta methods; Blanes, Casas & Murua (2004), On the
/// numerical integration of ordinary differential equations by processed methods, SIAM J. Numer. Anal. 42;
/// Rowlands (1991), A numerical algorithm for Hamiltonian systems, J. Comput. Phys. 97 (the force a + h^2/12
/// a_x a).
struct Processing {
  std::string integrator;
  const ForceClass* forces = nullptr;
  int plain_order = 0;      ///< of the step by itself
  int effective_order = 0;  ///< with launch and read-out (and the force)
  bool complete = false;    ///< as far as was asked; otherwise the obstruction says why not
  bool proved = true;       ///< exact, and nothing was left open that could have been chosen in another way
  std::vector<FieldTerm> force;  ///< what is added to a; power of h as in a + h^2/12 a_x a
  std::vector<FieldTerm>
      launch;  ///< what is added to x0 and v0; h^power includes the step: order of the tree
  std::vector<FieldTerm> read_out;    ///< what is added to x_n and v_n
  std::vector<FieldTerm> generators;  ///< the c_k
  /// Where it stops: a sentence, and the linear combination of error coefficients that no launch changes.
  std::string obstruction;
  int obstructed_at = 0;            ///< the order that is not reached
  std::vector<FieldTerm> residual;  ///< a certificate: weights of tree coefficients of the modified equation
  Fraction residual_value;          ///< what they add up to; not 0
  int digits = 0;
  std::vector<std::string> notes;
};

/// throws  Unable, Undefined  when the step has no series
Processing processing(const SeriesSource& source, const ProcessingQuestion& question);

}  // namespace shortfall
