// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/open_step.hpp"
#include "analysis/motion/own_equation.hpp"

namespace shortfall {

/// What a kit can change about an integrator that has a spring or a damper of its own.
struct OwnParameters {
  /// A parameter that takes the place of k (kStiffness) or c (kDamping): it is that letter over `scale`.
  struct Tuned {
    Letter unknown;
    std::string name;
    Fraction scale;
  };

  Force force;                      ///< of the true motion, in the letters of the step
  std::optional<ExactDecay> decay;  ///< the step damps by exp or pow, exactly; then nothing is tuned
  std::vector<Tuned> tuned;
  Values given;                           ///< without the parameters that are tuned
  std::vector<Replacement> replacements;  ///< for open_step

  const Tuned* tuned_for(Letter unknown) const;
};

/// throws  Unable  when the own damping is neither exact nor a multiple of one parameter
OwnParameters own_parameters(const Program& program, const Force& asked, const Values& given, int substeps);

/// How many equal substeps a step has, as far as it says so.
int equal_parts(const Program& program, const Values& given, int substeps);

}  // namespace shortfall
