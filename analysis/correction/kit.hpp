// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/derivation.hpp"

namespace shortfall {

/// One thing to add: to the launch (once, at the start), to what is read out, to the force, or to the step
/// itself.
struct Correction {
  enum class Kind { launch, read_out, force, term };
  Kind kind;
  std::string target;  ///< what it is added to: "v0", "x0", "v", "x", "a" or "f"
  Expr add;  ///< in h, t, the force's letters, parameters (t: the time of the launch is 0; of a read-out n h;
             ///< of a step its beginning)
  std::string series;  ///< the same in derivatives of the force: "-1/2 h f + 1/6 h^2 f'"
  bool exact = true;   ///< exact for every n
  std::string reason;  ///< one sentence
};

/// A set of corrections that belong together, or the proof that there is none of this kind.
struct CorrectionOption {
  std::string name;  ///< "launch", "launch and read-out", "force and launch", "force alone", "term"
  bool exists = false;
  std::vector<Correction> corrections;
  std::string obstruction;  ///< when there is none: the term that no such correction can cancel
  std::string proof;        ///< how it is known
};

/// How to repair an integrator for a force polynomial in time.
struct CorrectionKit {
  bool needed = true;  ///< false: nothing to correct, both shortfalls are 0
  std::vector<CorrectionOption> options;

  /// The cheapest option that exists; nullptr when nothing is needed or nothing exists.
  const CorrectionOption* best() const;
};

/// Solves for the corrections, exactly, as linear systems in the coefficients of f, h f', h^2 f'', ...;
/// nothing is looked up.
///
/// Each option is substituted back into the closed form and compared with the true motion as rational
/// functions of n, h, parameters; an option that does not exist comes with the equation that makes the system
/// inconsistent. source  the ansatz: Euler-Maclaurin's; Hairer, Lubich & Wanner (2006), IX.8 (modifying
/// integrators), V.3.3 (processing) throws  Unable  for a degree above 30
CorrectionKit correction_kit(const Derivation& derivation);

const char* kind_name(Correction::Kind kind);

}  // namespace shortfall
