// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/kit.hpp"

#include <algorithm>

#include "analysis/correction/ansatz.hpp"

namespace shortfall {

using Target = Coefficient::Target;

namespace {

constexpr int kHighestSolvedDegree = 30;

/// Whether all numbers in it are so small that coefficients known to some digits explain them; two digits are
/// allowed for how strongly a result depends on them.
bool is_below_digits(const Sequence& s, int digits) {
  if (digits <= 2 || !s.is_polynomial() || !s.polynomial().is_polynomial()) return false;
  const Rational allowed = Rational(1) / Rational(10).pow(digits - 2);
  return std::ranges::all_of(s.polynomial().numerator().terms(),
                             [&](const Polynomial::Term& t) { return t.coefficient.abs() < allowed; });
}

/// An inconsistent step lets even a free body move wrongly; then no amount of force repairs it.
std::string free_motion_defect(const Derivation& d) {
  for (const auto& [motion, what] :
       {std::pair{&d.shortfall_position_motion, "position"}, {&d.shortfall_velocity_motion, "velocity"}})
    for (int column : {0, 1}) {
      const Sequence& wrong = (*motion)[column];
      if (wrong.is_zero()) continue;
      if (is_below_digits(wrong, d.digits))
        return std::string("the coefficients as they are printed move even a free body wrongly, its ") +
               what + " by no more than their last digits";
      return std::string("the step is not consistent: even without a force the ") + what + " is wrong";
    }
  return "";
}

}  // namespace

const char* kind_name(Correction::Kind kind) {
  switch (kind) {
    case Correction::Kind::launch:
      return "launch";
    case Correction::Kind::read_out:
      return "read-out";
    case Correction::Kind::force:
      return "force";
    case Correction::Kind::term:
      return "term";
  }
  return "";
}

const CorrectionOption* CorrectionKit::best() const {
  const auto found = std::ranges::find_if(options, [](const CorrectionOption& o) { return o.exists; });
  return found == options.end() ? nullptr : &*found;
}

CorrectionKit correction_kit(const Derivation& d) {
  if (d.degree > kHighestSolvedDegree)
    throw Unable("correction kits are solved for up to degree " + std::to_string(kHighestSolvedDegree) +
                 "; the closed form goes up to degree 200");
  const NumberField field(d.map.generators);
  CorrectionKit kit;
  kit.needed = !is_zero(d.shortfall_position_motion) || !is_zero(d.shortfall_velocity_motion);
  if (!kit.needed) return kit;
  const AnsatzSystem system(d);
  // From the cheapest to the dearest. A later one of the first three is of interest only when an earlier one
  // does not exist.
  kit.options.push_back(system.solved({"launch", {Target::launch_v, Target::read_v}}));
  if (!kit.options.back().exists) {
    kit.options.push_back(system.solved(
        {"launch and read-out", {Target::launch_v, Target::read_v, Target::launch_x, Target::read_x}}));
    if (!kit.options.back().exists)
      kit.options.push_back(system.solved({"launch and read-out with a shift in time",
                                           {Target::launch_v, Target::read_v, Target::launch_x,
                                            Target::read_x, Target::launch_x_by_v0, Target::read_x_by_v}}));
    kit.options.push_back(
        system.solved({"force and launch", {Target::force, Target::launch_v, Target::read_v}}));
  }
  kit.options.push_back(system.solved({"force alone", {Target::force}}));
  kit.options.push_back(system.solved({"term", {Target::term_x, Target::term_v}}));
  if (const std::string defect = free_motion_defect(d); !defect.empty())
    for (CorrectionOption& o : kit.options)
      if (!o.exists) o.obstruction = defect + "; " + o.obstruction;
  return kit;
}

}  // namespace shortfall
