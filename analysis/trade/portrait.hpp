// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/series/hamiltonian.hpp"
#include "analysis/trade/scene_model.hpp"

namespace shortfall {

/// A body on a line in a potential, mass 1: x'' = -V'(x).
struct PortraitQuestion {
  Expr potential;          ///< V, of x
  Rational h;              ///< s, the frame
  int substeps = 1;        ///< of a frame
  Values parameters = {};  ///< of the integrator
  int steps = 200;         ///< frames
  int order = 6;           ///< the modified energy is cut before h^order

  struct Start {
    Rational x, v;
  };
  std::vector<Start> starts;
};

/// The true energy v^2/2 + V(x), and the energy that the step conserves instead, cut after some powers of h.
/// In binary64.
class EnergySurfaces {
 public:
  /// param   h  that of the modified energy's series
  EnergySurfaces(const Expr& potential, const ModifiedHamiltonian& modified, const SeriesSource& source,
                 double h);

  struct Values {
    double energy = 0;
    double modified = 0;  ///< the energy itself where there is no modified one
  };
  Values at(double x, double v);
  /// The force for mass 1, -V'(x).
  double force(double x);

 private:
  struct Term {
    double factor;             ///< coefficient * h^power
    std::vector<int> factors;  ///< see EnergyTerm::in_one_dimension
  };
  const std::vector<double>& derivatives(double x);

  std::vector<Term> terms_;
  TapeValues<double> tape_;
  std::vector<double> derivatives_;
  std::optional<double> known_at_;
};

/// One motion as the integrator makes it, frame by frame from the start on.
struct PortraitOrbit {
  std::vector<double> x, v;
  std::vector<double> energy;    ///< v^2/2 + V
  std::vector<double> modified;  ///< the modified energy, cut
  /// The frame in which a number left all bounds, or has no value; the rows end before it.
  std::optional<int> lost;
  bool no_number = false;  ///< the latter: V is not defined where the step asks for it

  /// The largest |value - value at the start|.
  static double largest_change(const std::vector<double>& values);
};

/// Motions in the plane of position and velocity, and what becomes of their energy.
struct Portrait {
  std::string integrator;
  PortraitQuestion question;
  ModifiedHamiltonian hamiltonian;  ///< of the whole frame
  std::vector<std::string> notes;   ///< of its series
  std::vector<PortraitOrbit> orbits;
};

/// Steps the motions in binary64 and follows both energies along them.
///
/// throws  BadInput   without a start, for a potential of other letters than x
///         Undefined  where V or the step is singular;  Unable  when the step has no series
Portrait portrait(const Program& program, const PortraitQuestion& question);

/// The surfaces of a portrait, to draw level lines by.
EnergySurfaces surfaces_of(const Portrait& portrait, const Program& program);

}  // namespace shortfall
