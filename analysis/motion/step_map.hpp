// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/problems/linear_force.hpp"
#include "analysis/program/progress.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// One step of an integrator under x'' = f0 + f1 t + ... + fD t^D (- k x - c v), written out: an affine map
/// of the carried vectors.
///
/// Columns of `step`, `position` and `velocity`: the carried vectors at step n, then f0..fD; coefficients in
/// n, h, parameters. Columns of `start`: x0, v0, then (after the carried vectors' places) f0..fD.
struct StepMap {
  LinearForce force;
  std::vector<std::string> letters;  ///< names of the letters, see letters.hpp
  std::vector<std::string> states;   ///< names of the carried vectors
  std::vector<LinearForm> start;     ///< their first values
  std::vector<LinearForm> step;      ///< their values after step n -> n + 1
  LinearForm position;               ///< what `finish` reports after n steps
  LinearForm velocity;
  std::vector<ExtraLetters::Extra> extras;         ///< what the last letters stand for
  std::vector<NumberField::Generator> generators;  ///< of the NumberField in which these forms are to be used
  std::vector<std::string> assumed;  ///< what the head assumes and was used; limits that must not act

  /// Coefficients of the carried vectors in `step`.
  std::vector<std::vector<Fraction>> matrix() const;
};

/// param   h  the step: its letter, or a number
/// throws  Undefined  when a stage is singular; Unable when there are too many free parameters
StepMap step_map(const Tape& tape, int degree, Fraction stiffness = {}, Fraction damping = {},
                 const Fraction& h = Fraction::letter(kStepLetter));

/// The carried vectors after 0..steps steps, by stepping in letters: what a closed form is held against.
///
/// shape   steps + 1 entries, each one row per carried vector; columns as in `start`
std::vector<std::vector<LinearForm>> stepped(const StepMap& map, int steps, const Progress& progress = {});

/// What `finish` reports of a stepped state.
LinearForm reported(const LinearForm& row, const std::vector<LinearForm>& state, int n, int states);

}  // namespace shortfall
