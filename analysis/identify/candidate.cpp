// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/candidate.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kCounts[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 20, 24, 32};
constexpr int kWholeSteps[] = {2, 3, 4, 5, 8, 10};

/// Parameters that switch something on: a number without dimension that is 1 or 0 by default and is called
/// neither the damping nor the number of substeps.
std::vector<std::string> flags(const Program& program) {
  std::vector<std::string> result;
  if (family(program) != "engines") return result;
  for (const Parameter& p : program.parameters)
    if (p.name != "c" && p.name != "N" && p.dimension == kPure)
      if (const Rational value = parameter_values(program).at(p.name); value.is_one())
        result.push_back(p.name);
  return result;
}

}  // namespace

std::string Candidate::str() const {
  std::string text = name();
  for (const auto& [parameter, value] : fixed) text += ", " + parameter + " = " + value.str();
  if (substeps > 1) text += ", " + std::to_string(substeps) + " substeps";
  return text;
}

Circumstances Candidate::circumstances(double dt, double c, double k) const {
  Circumstances what;
  what.dt = dt;
  what.k = k;
  what.has_own_c = own_damping;
  what.own_c = own_damping ? c : 0;
  what.drag = own_damping ? 0 : c;
  what.substeps = substeps;
  return what;
}

Candidate candidate(const Program& program, std::optional<int> substeps, const Values& values) {
  Candidate result;
  result.program = &program;
  result.fixed = values;
  const auto own = substep_parameter(program);
  if (own) {
    if (substeps) result.fixed[*own] = *substeps;
    result.counts = static_cast<int>(parameter_values(program, result.fixed).at(*own).to_double());
    result.fixed[*own] = *result.counts;
  } else {
    result.substeps = substeps.value_or(1);
  }
  result.own_damping = program.parameter("c") != nullptr && !values.contains("c");
  result.tape = std::make_shared<const Tape>(lower(program, result.fixed));
  return result;
}

std::vector<Candidate> candidates_of(const Program& program) {
  std::vector<Candidate> result;
  if (substep_parameter(program)) {
    for (const int n : kCounts) result.push_back(candidate(program, n));
    return result;
  }
  result.push_back(candidate(program, std::nullopt));
  for (const std::string& flag : flags(program))
    result.push_back(candidate(program, std::nullopt, {{flag, Rational(0)}}));
  // A game that steps several times a frame does so with a simple method.
  if (const std::string kind = family(program); kind == "euler" || kind == "verlet")
    for (const int n : kWholeSteps) result.push_back(candidate(program, n));
  return result;
}

const std::vector<Candidate>& known_candidates() {
  static const std::vector<Candidate> all = [] {
    std::vector<Candidate> result;
    for (const Program& program : catalogue())
      for (Candidate& c : candidates_of(program)) result.push_back(std::move(c));
    return result;
  }();
  return all;
}

}  // namespace shortfall
