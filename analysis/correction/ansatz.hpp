// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/correction/kit.hpp"

namespace shortfall {

/// An unknown coefficient c_k of a correction c_k h^p f^(k), p = k + 2 for positions, k + 1 for velocities, k
/// for the force.
struct Coefficient {
  enum class Target {
    launch_x,
    launch_v,
    launch_x_by_v0,
    read_x,
    read_v,
    read_x_by_v,
    force,
    term_x,
    term_v
  };
  Target place;
  int derivative;  ///< k
};

/// Which coefficients an option may use.
struct Ansatz {
  std::string name;
  std::vector<Coefficient::Target> places;
  bool position_only = false;  ///< only positions must be exact
};

/// The linear system of an ansatz: what each unknown adds to the reported position and velocity must equal
/// the shortfall, power by power of n.
class AnsatzSystem {
 public:
  explicit AnsatzSystem(const Derivation& derivation);

  /// Solves for the coefficients, substitutes them back and words the result.
  CorrectionOption solved(const Ansatz& ansatz) const;

 private:
  /// What an unknown adds to the motion per unit: position and velocity.
  struct Effect {
    Motion position;
    Motion velocity;
  };
  struct Equation {
    std::vector<Fraction> row;
    Fraction right;
    std::string term;  ///< of which monomial of the shortfall it speaks
  };

  Effect effect(const Coefficient& c) const;
  std::vector<Equation> equations(const std::vector<Coefficient>& unknowns, bool position_only) const;
  std::vector<Correction> worded(const std::vector<Coefficient>& unknowns,
                                 const std::vector<Fraction>& values) const;
  int columns() const { return 2 + d_.degree + 1; }

  const Derivation& d_;
  ClosedForm response_;  ///< to adding n^j to x (columns 2..) and to v (after them) at the end of each step
};

}  // namespace shortfall
