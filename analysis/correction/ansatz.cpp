// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/ansatz.hpp"

#include <algorithm>
#include <map>

#include "analysis/algebra/linear_solve.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

using Target = Coefficient::Target;

namespace {

Fraction h_power(int exponent) { return Fraction::letter(kStepLetter, exponent); }

/// d! / (d-k)!, the factor of f_d t^(d-k) in f^(k).
Rational falling(int d, int k) { return factorial(d) / factorial(d - k); }

/// The step map with other drives: column j adds n^j to x, column degree + 1 + j adds n^j to v, at the end of
/// each step.
StepMap driven(const StepMap& map, int degree) {
  StepMap result = map;
  result.force.degree = 2 * (degree + 1) - 1;
  const int states = map.force.states;
  const auto only_states = [&](const LinearForm& row) {
    LinearForm kept;
    for (int s = 0; s < states; ++s)
      if (!row[s].is_zero()) kept.at(s) = row[s];
    return kept;
  };
  for (LinearForm& row : result.step) row = only_states(row);
  for (LinearForm& row : result.start) row = {};
  result.position = only_states(map.position);
  result.velocity = only_states(map.velocity);
  for (int j = 0; j <= degree; ++j) {
    result.step[0].at(result.force.force_column(j)) = Fraction::letter(kCount).pow(j);
    result.step[1].at(result.force.force_column(degree + 1 + j)) = Fraction::letter(kCount).pow(j);
  }
  return result;
}

void add_scaled(Motion& to, int column, const Sequence& s, const Fraction& factor) {
  Sequence scaled = s;
  to[column] += scaled *= factor;
}

}  // namespace

AnsatzSystem::AnsatzSystem(const Derivation& derivation)
    : d_(derivation), response_(closed_form(driven(derivation.map, derivation.degree))) {}

AnsatzSystem::Effect AnsatzSystem::effect(const Coefficient& c) const {
  const ClosedForm& form = d_.form;
  const int k = c.derivative;
  const Fraction t = Fraction::letter(kCount) * h_power(1);
  Effect e{Motion(columns()), Motion(columns())};
  switch (c.place) {
    case Target::launch_x:
    case Target::launch_v: {
      const int from = c.place == Target::launch_x ? 0 : 1;
      const Fraction size = h_power(k + 2 - from) * Fraction(factorial(k));  // f^(k)(0) = k! f_k
      add_scaled(e.position, 2 + k, form.position[from], size);
      add_scaled(e.velocity, 2 + k, form.velocity[from], size);
      break;
    }
    case Target::launch_x_by_v0:
      add_scaled(e.position, 1, form.position[0], h_power(1));
      add_scaled(e.velocity, 1, form.velocity[0], h_power(1));
      break;
    case Target::read_x:
    case Target::read_v: {
      const bool x = c.place == Target::read_x;
      for (int d = k; d <= d_.degree; ++d)
        (x ? e.position : e.velocity)[2 + d] +=
            Sequence(h_power(k + (x ? 2 : 1)) * Fraction(falling(d, k)) * t.pow(d - k));
      break;
    }
    case Target::read_x_by_v: {
      const Motion v = exact_velocity(d_.degree);
      for (int column = 0; column < columns(); ++column)
        add_scaled(e.position, column, v[column], h_power(1));
      break;
    }
    case Target::force:
      for (int d = k; d <= d_.degree; ++d) {
        add_scaled(e.position, 2 + d, form.position[2 + d - k], h_power(k) * Fraction(falling(d, k)));
        add_scaled(e.velocity, 2 + d, form.velocity[2 + d - k], h_power(k) * Fraction(falling(d, k)));
      }
      break;
    case Target::term_x:
    case Target::term_v: {
      const bool x = c.place == Target::term_x;
      for (int d = k; d <= d_.degree; ++d) {
        const int column = 2 + (x ? 0 : d_.degree + 1) + d - k;
        const Fraction size = h_power(d + (x ? 2 : 1)) * Fraction(falling(d, k));
        add_scaled(e.position, 2 + d, response_.position[column], size);
        add_scaled(e.velocity, 2 + d, response_.velocity[column], size);
      }
      break;
    }
  }
  return e;
}

std::vector<AnsatzSystem::Equation> AnsatzSystem::equations(const std::vector<Coefficient>& unknowns,
                                                            bool position_only) const {
  std::vector<Effect> effects;
  for (const Coefficient& c : unknowns) effects.push_back(effect(c));
  std::vector<Equation> all;
  for (const bool position : {true, false}) {
    if (position_only && !position) continue;
    const Motion& right = position ? d_.shortfall_position_motion : d_.shortfall_velocity_motion;
    for (int column = 0; column < columns(); ++column) {
      // One equation for each power of n and each base.
      std::vector<std::pair<Fraction, std::map<int, Equation>>> found;
      const auto collect = [&](const Sequence& s, auto&& store) {
        for (const Sequence::Term& term : s.terms()) {
          auto at = std::ranges::find(found, term.base, [](const auto& f) { return f.first; });
          if (at == found.end()) at = found.insert(found.end(), {term.base, {}});
          const auto coefficients = term.coefficient.numerator().coefficients(kCount);
          for (std::size_t j = 0; j < coefficients.size(); ++j) {
            if (coefficients[j].is_zero()) continue;
            Equation& equation = at->second[static_cast<int>(j)];
            equation.row.resize(unknowns.size());
            store(equation, Fraction(coefficients[j], term.coefficient.denominator()));
          }
        }
      };
      for (std::size_t u = 0; u < unknowns.size(); ++u)
        collect(position ? effects[u].position[column] : effects[u].velocity[column],
                [&](Equation& e, const Fraction& f) { e.row[u] = f; });
      collect(right[column], [](Equation& e, const Fraction& f) { e.right = f; });
      for (auto& [base, powers] : found)
        for (auto& [power, equation] : powers) {
          const Sequence term(base, equation.right * Fraction::letter(kCount).pow(power));
          Motion only(columns());
          only[column] = term;
          equation.term = std::string(position ? "position" : "velocity") + " term " +
                          print(formula(only, d_.degree, d_.wording()), Style::language);
          all.push_back(std::move(equation));
        }
    }
  }
  return all;
}

CorrectionOption AnsatzSystem::solved(const Ansatz& ansatz) const {
  std::vector<Coefficient> unknowns;
  for (const Target place : ansatz.places) {
    const bool once = place == Target::launch_x_by_v0 || place == Target::read_x_by_v;
    for (int k = 0; k <= (once ? 0 : d_.degree); ++k) unknowns.push_back({place, k});
  }
  const std::vector<Equation> all = equations(unknowns, ansatz.position_only);
  std::vector<std::vector<Fraction>> matrix;
  std::vector<Fraction> right;
  for (const Equation& e : all) {
    matrix.push_back(e.row);
    right.push_back(e.right);
  }
  CorrectionOption option;
  option.name = ansatz.name;
  const LinearSolution<Fraction> found = solve_linear(matrix, right);
  if (!found.solution) {
    // The last equation of the certificate with a right side is the term that the others leave no room for.
    std::string culprit;
    int involved = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (found.certificate[i].is_zero()) continue;
      ++involved;
      if (!right[i].is_zero() || culprit.empty()) culprit = all[i].term;
    }
    option.obstruction = "no such correction cancels the " + culprit + " of the shortfall";
    option.proof = involved == 1 ? "nothing it adds contains this power of t"
                                 : "a combination of " + std::to_string(involved) +
                                       " of the conditions on its coefficients has left side 0 and right "
                                       "side not 0 (Fredholm's alternative)";
    return option;
  }
  // The proof is the substitution, not the solver.
  Motion x = d_.shortfall_position_motion;
  Motion v = d_.shortfall_velocity_motion;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const Fraction& value = (*found.solution)[u];
    if (value.is_zero()) continue;
    const Effect e = effect(unknowns[u]);
    for (int column = 0; column < columns(); ++column) {
      add_scaled(x, column, e.position[column], -value);
      add_scaled(v, column, e.velocity[column], -value);
    }
  }
  option.exists = is_zero(x) && (ansatz.position_only || is_zero(v));
  if (!option.exists) throw Error("a correction was found but does not survive substitution");
  option.proof =
      "substituted back, the corrected motion equals the true one as a function of n, h and all letters";
  option.corrections = worded(unknowns, *found.solution);
  return option;
}

std::vector<Correction> AnsatzSystem::worded(const std::vector<Coefficient>& unknowns,
                                             const std::vector<Fraction>& values) const {
  struct Where {
    Correction::Kind kind;
    const char* target;
    const char* reason;
  };
  const std::string force = d_.degree == 0 ? "a" : "f";
  const std::map<Target, Where> where{
      {Target::launch_x, {Correction::Kind::launch, "x0", "start the integrator here"}},
      {Target::launch_x_by_v0,
       {Correction::Kind::launch, "x0",
        "start the integrator here; v0 is the true velocity, not yet corrected"}},
      {Target::launch_v, {Correction::Kind::launch, "v0", "start the integrator with this velocity"}},
      {Target::read_x,
       {Correction::Kind::read_out, "x", "report this position; go on with the integrator's own"}},
      {Target::read_x_by_v,
       {Correction::Kind::read_out, "x",
        "report this position, v being the corrected velocity; go on with the integrator's own"}},
      {Target::read_v,
       {Correction::Kind::read_out, "v", "report this velocity; go on with the integrator's own"}},
      {Target::force, {Correction::Kind::force, "", "let the integrator see this force instead"}},
      {Target::term_x, {Correction::Kind::term, "x", "add this to the position at the end of each step"}},
      {Target::term_v, {Correction::Kind::term, "v", "add this to the velocity at the end of each step"}}};
  const Wording w = d_.wording();
  std::vector<Correction> corrections;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const auto [place, k] = unknowns[u];
    if (values[u].is_zero()) continue;
    const Where& at = where.at(place);
    const std::string target = *at.target ? at.target : force;
    auto mine = std::ranges::find_if(
        corrections, [&](const Correction& c) { return c.kind == at.kind && c.target == target; });
    if (mine == corrections.end())
      mine = corrections.insert(mine, {at.kind, target, number(0), "", true, at.reason});
    Fraction coefficient = values[u];
    Motion added(columns());
    std::string base = force;
    if (place == Target::launch_x_by_v0 || place == Target::read_x_by_v) {
      mine->reason = at.reason;
      coefficient *= h_power(1);
      base = place == Target::read_x_by_v ? "v" : "v0";
      added[1] = Sequence(coefficient);
    } else {
      const bool x = place == Target::launch_x || place == Target::read_x || place == Target::term_x;
      coefficient *= h_power(k + (place == Target::force ? 0 : x ? 2 : 1));
      const bool at_launch = place == Target::launch_x || place == Target::launch_v;
      const Fraction t = Fraction::letter(kCount) * h_power(1);
      for (int d = k; d <= (at_launch ? k : d_.degree); ++d)
        added[2 + d] = Sequence(coefficient * Fraction(falling(d, k)) * t.pow(d - k));
      if (d_.degree > 0)
        base += k <= 3 ? std::string(static_cast<std::size_t>(k), '\'') : "^(" + std::to_string(k) + ")";
    }
    Expr expanded =
        place == Target::read_x_by_v ? formula(coefficient, name("v"), w) : formula(added, d_.degree, w);
    mine->add = joined(mine->add, expanded);
    const std::string piece = print(formula(coefficient, name(base), w), Style::language);
    const bool minus = piece.starts_with("-");
    const bool sum = coefficient.is_polynomial() && coefficient.numerator().terms().size() > 1;
    if (mine->series.empty())
      mine->series = piece;
    else if (sum)
      mine->series += " + (" + piece + ")";
    else
      mine->series += minus ? " - " + piece.substr(1) : " + " + piece;
  }
  return corrections;
}

}  // namespace shortfall
