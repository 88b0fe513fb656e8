// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/claims.hpp"

#include <algorithm>

#include "analysis/motion/agreement.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

/// The motion of an integrator and the closed form of what it falls short by, oscillations apart.
struct Shortfall {
  StepMap map;
  NumberField field;
  ClosedForm form;
  Motion position;
  Motion velocity;

  Shortfall(const Program& program, int degree)
      : map(step_map(lower(program), degree)),
        field(map.generators),
        form(closed_form(map)),
        position(exact_position(degree) - form.position),
        velocity(exact_velocity(degree) - form.velocity) {}

  /// Whether the motion has a part on irrational eigenvalues in this column. No formula of a claim has one.
  static bool oscillates(const Oscillation::Values& values, std::size_t column) {
    return column < values.size() &&
           !std::ranges::all_of(values[column], [](const Fraction& f) { return f.is_zero(); });
  }

  /// Exact minus reported after so many steps, by stepping: for the first steps, which the closed form may
  /// not cover.
  std::vector<Fraction> stepped_at(int n, const LinearForm& row, const Motion& exact) const {
    const LinearForm value = reported(row, stepped(map, n).back(), n, map.force.states);
    std::vector<Fraction> difference;
    for (std::size_t column = 0; column < exact.size(); ++column) {
      const int c = static_cast<int>(column);
      difference.push_back(exact[column].at(n) - value[c < 2 ? c : map.force.force_column(c - 2)]);
    }
    return difference;
  }
};

ClaimVerdict shortfall_verdict(const Program& program, const Claim& claim, const Shortfall& constant) {
  const bool of_position = claim.word == "shortfall";
  const Motion& exact = of_position ? exact_position(0) : exact_velocity(0);
  const Motion& found = of_position ? constant.position : constant.velocity;
  const Motion claimed = evaluated(claim.value, formula_scalars(program, {}, constant.map.force.extras.get()),
                                   0, constant.map.force.extras.get());
  const auto& oscillation =
      of_position ? constant.form.oscillation.position : constant.form.oscillation.velocity;
  bool oscillates = false;
  for (std::size_t column = 0; column < found.size(); ++column)
    oscillates = oscillates || Shortfall::oscillates(oscillation, column);
  Agreement agreement(program);
  for (const Sequence& difference : claimed - found) agreement.add(difference);
  for (int n = 1; n < constant.form.valid_from && agreement.holds(); ++n) {
    const auto value =
        constant.stepped_at(n, of_position ? constant.map.position : constant.map.velocity, exact);
    for (std::size_t column = 0; column < value.size(); ++column)
      agreement.add(claimed[column].at(n) - value[column]);
  }
  return {claim.word + " " + print(claim.value), !oscillates && agreement.holds(),
          claim.word + " " + print(formula(found, 0, {constant.map.letters, "n", true})) +
              (oscillates ? " and an oscillation" : ""),
          agreement.digits()};
}

/// How far a motion is exact: up to which degree of a force polynomial, at most the one it was computed for
/// (-1 when not even for a constant force), and to how many digits.
struct Exactness {
  int degree;
  int digits;
};

Exactness exactness(const Program& program, const Shortfall& shortfall) {
  const int columns = shortfall.form.degree + 3;
  std::vector<Agreement> exact(columns, Agreement(program));
  std::vector<bool> oscillates(columns);
  for (int c = 0; c < columns; ++c) {
    exact[c].add(shortfall.position[c]);
    exact[c].add(shortfall.velocity[c]);
    oscillates[c] = Shortfall::oscillates(shortfall.form.oscillation.position, c) ||
                    Shortfall::oscillates(shortfall.form.oscillation.velocity, c);
  }
  for (int n = 1; n < shortfall.form.valid_from; ++n) {
    const auto x = shortfall.stepped_at(n, shortfall.map.position, exact_position(shortfall.form.degree));
    const auto v = shortfall.stepped_at(n, shortfall.map.velocity, exact_velocity(shortfall.form.degree));
    for (int c = 0; c < columns; ++c) {
      exact[c].add(x[c]);
      exact[c].add(v[c]);
    }
  }
  // Columns: x0, v0, f0, f1, ...
  int column = 0, digits = exact[0].digits();
  for (; column < columns && exact[column].holds() && !oscillates[column]; ++column)
    digits = std::min(digits, exact[column].digits());
  return {std::max(column - 3, -1), digits};
}

ClaimVerdict exact_verdict(const Program& program, const Claim& claim) {
  std::int64_t degree = 0;
  claim.value->value.fits_int64(degree);
  const int claimed = static_cast<int>(degree);
  const auto [found, digits] = exactness(program, Shortfall(program, claimed + 1));
  const std::string more = found > claimed ? " or more" : "";
  return {claim.word + " " + print(claim.value), found == claimed,
          found < 0 ? "not exact for a constant force" : "exact " + std::to_string(found) + more, digits};
}

}  // namespace

std::vector<ClaimVerdict> claims(const Program& program) {
  std::vector<ClaimVerdict> verdicts;
  const auto about_shortfall = [](const Claim& c) { return c.word.starts_with("shortfall"); };
  const bool about_constant_force = std::ranges::any_of(program.claims, about_shortfall);
  std::optional<Shortfall> constant;
  if (about_constant_force) constant.emplace(program, 0);
  for (const Claim& claim : program.claims) {
    if (claim.word == "exact") verdicts.push_back(exact_verdict(program, claim));
    if (about_shortfall(claim)) verdicts.push_back(shortfall_verdict(program, claim, *constant));
  }
  return verdicts;
}

}  // namespace shortfall
