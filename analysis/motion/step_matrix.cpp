// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/step_matrix.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

const Fraction& checked(const Fraction& f) {
  if (f.contains(kCount) || f.contains(kTimeLetter))
    throw Unable("the coefficients of the step depend on t, so its n-step map is no power of a matrix");
  return f;
}

/// n^j as a sum of binomial coefficients (n choose i): Stirling numbers of the second kind times i!.
std::vector<std::vector<Rational>> powers_in_binomials(int highest) {
  std::vector<std::vector<Rational>> rows{{1}};
  for (int j = 1; j <= highest; ++j) {
    // n (n choose i) = i (n choose i) + (i + 1) (n choose i + 1)
    std::vector<Rational> next(j + 1);
    for (int i = 0; i < j; ++i) {
      next[i] += Rational(i) * rows.back()[i];
      next[i + 1] += Rational(i + 1) * rows.back()[i];
    }
    rows.push_back(std::move(next));
  }
  return rows;
}

/// A form's coefficients of the carried vectors, then of the binomials.
std::vector<Fraction> row(const LinearForm& form, const StepMap& map, const Force& force, int size) {
  std::vector<Fraction> result(size);
  const int states = map.force.states;
  for (int j = 0; j < states; ++j) result[j] = checked(form[j]);
  for (int d = 0; states + d < size; ++d) {
    const Fraction& f = form[map.force.force_column(d)];
    if (f.is_zero()) continue;
    const Fraction weight = Fraction(force.push.at(d)) / checked(Fraction(f.denominator()));
    const int degree = f.numerator().degree(kCount);
    const auto binomials = powers_in_binomials(degree);
    for (int j = 0; j <= degree; ++j) {
      const Fraction share = weight * checked(Fraction(f.numerator().coefficient(kCount, j)));
      for (int i = 0; i <= j; ++i) result[states + i] += share * Fraction(binomials[j][i]);
    }
  }
  return result;
}

Fraction at_start(const LinearForm& form, const StepMap& map, const NumericQuestion& q) {
  Fraction total = checked(form[0]) * Fraction(q.x0) + checked(form[1]) * Fraction(q.v0);
  for (int d = 0; d <= map.force.degree; ++d) {
    const Fraction& f = form[map.force.force_column(d)];
    if (!f.is_zero()) total += checked(f) * Fraction(q.force.push.at(d));
  }
  return total;
}

}  // namespace

bool StepMatrix::rational() const {
  const auto constant = [](const std::vector<Fraction>& row) {
    return std::ranges::all_of(row, [](const Fraction& f) { return f.is_constant(); });
  };
  return std::ranges::all_of(step, constant) && constant(start) && constant(position) && constant(velocity);
}

StepMatrix step_matrix(const Program& program, const NumericQuestion& q) {
  const Tape tape = lower(substepped(program, q.substeps), parameter_values(program, q.parameters));
  const Force f = without_own_equation(q.force);
  StepMatrix m;
  try {
    m.map = step_map(tape, f.degree, f.stiffness(), f.damping(), Fraction(q.h));
  } catch (const Undefined& e) {
    throw Undefined("there is no step of " + program.name + " with dt = " + q.h.str() +
                    " s and this force: " + e.what());
  }
  const NumberField field(m.map.generators);
  const int states = m.map.force.states, binomials = std::max(f.degree + 1, 0), size = states + binomials;
  for (int i = 0; i < states; ++i) {
    m.step.push_back(row(m.map.step[i], m.map, f, size));
    m.start.push_back(at_start(m.map.start[i], m.map, q));
  }
  for (int j = 0; j < binomials; ++j) {
    m.step.emplace_back(size);
    m.step.back()[states + j] = 1;
    if (j > 0) m.step.back()[states + j - 1] = 1;
    m.start.push_back(j == 0 ? 1 : 0);
  }
  m.position = row(m.map.position, m.map, f, size);
  m.velocity = row(m.map.velocity, m.map, f, size);
  return m;
}

}  // namespace shortfall
