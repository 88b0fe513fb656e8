// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_question.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/motion/own_equation.hpp"

namespace shortfall {

namespace {

constexpr int kHighestDegree = 30;  // the matrix grows with it

NumericQuestion checked(const Program& program, const NumericQuestion& asked) {
  NumericQuestion q = asked;
  q.force = without_own_equation(
      with_own_equation(asked.force, program, parameter_values(program, asked.parameters)));
  const Force& f = q.force;
  const auto need = [](bool there, const std::string& letter) {
    if (!there)
      throw BadInput("an exact trajectory needs a number for " + letter +
                     " of the force, as in spring:k=4, drag:a=3,c=1/2 or constant:a=3");
  };
  need(!f.spring || f.k, "k");
  need(!f.damper || f.c, "c");
  for (int d = 0; d <= f.degree; ++d) need(f.push.contains(d), d == 0 ? "a (= f0)" : "f" + std::to_string(d));
  if (f.degree > kHighestDegree)
    throw Unable("exact trajectories are given for forces up to poly:" + std::to_string(kHighestDegree));
  return q;
}

}  // namespace

StepMatrix exact_matrix(const Program& program, const NumericQuestion& question) {
  StepMatrix matrix = step_matrix(program, checked(program, question));
  if (!matrix.rational())
    throw Unable("'" + program.name +
                 "' has no exact trajectory in rational numbers: a coefficient of its step is irrational "
                 "(a root, exp or pow); x_n alone is known to any number of certain digits nevertheless");
  return matrix;
}

}  // namespace shortfall
