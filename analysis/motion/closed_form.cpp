// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/closed_form.hpp"

#include <algorithm>

#include "analysis/algebra/linear_solve.hpp"
#include "analysis/motion/faulhaber.hpp"
#include "analysis/motion/spectrum.hpp"

namespace shortfall {

namespace {

using Column = std::vector<Fraction>;  // one entry per carried vector, polynomials in n

Column times(const Matrix& m, const Column& v) {
  Column result(v.size());
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j)
      if (!m[i][j].is_zero() && !v[j].is_zero()) result[i] += m[i][j] * v[j];
  return result;
}

bool all_zero(const Column& v) {
  return std::ranges::all_of(v, [](const Fraction& f) { return f.is_zero(); });
}

/// The polynomial q with q(n+1) - base q(n) = b(n); for base 1 the one with q(0) = 0.
Fraction particular(const Fraction& b, const Fraction& base) {
  if (b.is_zero()) return {};
  if (base == Fraction(1)) return indefinite_sum(b, kCount);
  const Fraction n = Fraction::letter(kCount);
  const Fraction gap = Fraction(1) / (Fraction(1) - base);
  // From the top: the leading coefficient of q is that of b divided by 1 - base; subtract what it causes, go
  // on.
  Fraction q;
  Fraction rest = b;
  while (!rest.is_zero()) {
    const int degree = rest.numerator().degree(kCount);
    Fraction leading(rest.numerator().coefficient(kCount, degree), rest.denominator());
    const Fraction term = leading * gap * n.pow(degree);
    q += term;
    rest -= term.substitute(kCount, n + Fraction(1)) - base * term;
  }
  return q;
}

/// C(n, j) as a polynomial in n.
Fraction choose_n(int j) {
  Fraction result = 1;
  for (int i = 0; i < j; ++i)
    result *= (Fraction::letter(kCount) - Fraction(i)) * Fraction(Rational(1, i + 1));
  return result;
}

/// Adds, for one eigenvalue, the part of the motion of one column (a letter x0, v0 or f_d) that lives in its
/// generalised eigenspace.
void add_part(const SpectralPart& part, const Column& first, const Column& drive,
              std::vector<Sequence>& motion, std::vector<Column>& transient) {
  const std::size_t size = first.size();
  Column q(size);
  Column level = times(part.projector, drive);
  for (int j = 0; j < part.multiplicity && !all_zero(level); ++j) {
    for (Fraction& entry : level) entry = particular(entry, part.value);
    for (std::size_t i = 0; i < size; ++i) q[i] += level[i];
    level = times(part.nilpotent, level);
  }
  Column free = times(part.projector, first);
  for (std::size_t i = 0; i < size; ++i) {
    free[i] -= q[i].substitute(kCount, Fraction(0));
    motion[i] += Sequence(q[i]);
  }
  if (part.value.is_zero()) {
    transient.push_back(std::move(free));
    return;
  }
  for (int j = 0; j < part.multiplicity && !all_zero(free); ++j) {
    const Fraction weight = choose_n(j) / part.value.pow(j);
    for (std::size_t i = 0; i < size; ++i) motion[i] += Sequence(part.value, weight * free[i]);
    free = times(part.nilpotent, free);
  }
}

/// Whether what is reported of a state sees this part of it.
bool shows(const StepMap& map, const Column& part) {
  for (const LinearForm* row : {&map.position, &map.velocity})
    for (std::size_t s = 0; s < part.size(); ++s)
      if (!(*row)[static_cast<int>(s)].is_zero() && !part[s].is_zero()) return true;
  return false;
}

Fraction weighted(const LinearForm& row, const Column& state) {
  Fraction total;
  for (std::size_t s = 0; s < state.size(); ++s)
    if (!row[static_cast<int>(s)].is_zero()) total += row[static_cast<int>(s)] * state[s];
  return total;
}

/// The polynomials q in n with q(n+1) - M q(n) = b(n), on the part of the space where 1 is no eigenvalue of
/// M.
Column particular_of_rest(const Matrix& m, const Matrix& projector, const Column& b) {
  const int size = static_cast<int>(m.size());
  // (1 - M) on the rest, 1 elsewhere: invertible.
  Matrix a = identity_matrix(size);
  const Matrix mp = m * projector;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) a[i][j] -= mp[i][j];
  int degree = -1;
  for (const Fraction& entry : b) degree = std::max(degree, entry.numerator().degree(kCount));
  std::vector<Column> q(degree + 1);
  Column total(size);
  for (int j = degree; j >= 0; --j) {
    Column right(size);
    for (int s = 0; s < size; ++s) {
      if (!b[s].is_zero()) right[s] = Fraction(b[s].numerator().coefficient(kCount, j), b[s].denominator());
      for (int i = j + 1; i <= degree; ++i) right[s] -= Fraction(binomial(i, j)) * q[i][s];
    }
    q[j] = *solve_linear(a, right).solution;
    for (int s = 0; s < size; ++s) total[s] += q[j][s] * Fraction::letter(kCount).pow(j);
  }
  return total;
}

Sequence combined(const LinearForm& row, const std::vector<Motion>& states, int column,
                  const LinearForce& force) {
  Sequence result;
  for (int s = 0; s < force.states; ++s)
    if (!row[s].is_zero()) result += Sequence(row[s]) * states[s][column];
  if (column >= 2) result += Sequence(row[force.force_column(column - 2)]);
  return result;
}

}  // namespace

Fraction Oscillation::at(const std::vector<Fraction>& first, int n) const {
  std::vector<Fraction> window = first;
  for (int k = 0; k < n; ++k) {
    Fraction next;
    for (int j = 0; j < order(); ++j) next -= polynomial[j] * window[j];
    window.erase(window.begin());
    window.push_back(std::move(next));
  }
  return window.front();
}

Fraction motion_at(const ClosedForm& form, bool position, int n, std::size_t column) {
  Fraction value = (position ? form.position : form.velocity)[column].at(n);
  if (!form.oscillation.is_zero())
    value +=
        form.oscillation.at((position ? form.oscillation.position : form.oscillation.velocity)[column], n);
  return value;
}

Motion operator-(const Motion& a, const Motion& b) {
  Motion result = a;
  for (std::size_t i = 0; i < b.size(); ++i) result[i] -= b[i];
  return result;
}

bool is_zero(const Motion& motion) {
  return std::ranges::all_of(motion, [](const Sequence& s) { return s.is_zero(); });
}

ClosedForm closed_form(const StepMap& map, const Progress& progress) {
  const LinearForce& force = map.force;
  const int columns = 2 + force.degree + 1;
  const Matrix matrix = map.matrix();
  Matrix all = matrix;
  for (const LinearForm* row : {&map.position, &map.velocity})
    for (int s = 0; s < force.states; ++s) all.front().push_back((*row)[s]);
  for (const auto& row : all)
    for (const Fraction& entry : row)
      if (entry.contains(kCount))
        throw Unable(
            "the coefficients of the step depend on t, so its n-step map has no closed form of this kind");
  const Spectrum parts = spectrum(matrix);
  const int order = parts.rest_size();

  ClosedForm form;
  form.degree = force.degree;
  for (const SpectralPart& part : parts.parts) form.spectrum.emplace_back(part.value, part.multiplicity);
  form.states.assign(force.states, Motion(columns));
  form.oscillation.polynomial = parts.rest;
  form.oscillation.position.assign(columns, {});
  form.oscillation.velocity.assign(columns, {});
  for (int column = 0; column < columns; ++column) {
    if (progress) progress("summing up", column, columns);
    const int source = column < 2 ? column : force.force_column(column - 2);
    Column first;
    Column drive;
    for (int s = 0; s < force.states; ++s) {
      first.push_back(map.start[s][source]);
      drive.push_back(column < 2 ? Fraction() : map.step[s][source]);
    }
    std::vector<Sequence> motion(force.states);
    std::vector<Column> transient;
    for (const SpectralPart& part : parts.parts) {
      add_part(part, first, drive, motion, transient);
    }
    // What starts inside the nilpotent part dies after a few steps; until then the closed form does not hold
    // where it shows.
    for (Column left : transient)
      for (int n = 0; n < force.states && !all_zero(left); ++n, left = times(matrix, left))
        if (shows(map, left)) form.valid_from = std::max(form.valid_from, n + 1);
    if (order > 0) {
      const Column q = particular_of_rest(matrix, parts.rest_projector, times(parts.rest_projector, drive));
      Column free = times(parts.rest_projector, first);
      for (int s = 0; s < force.states; ++s) {
        motion[s] += Sequence(q[s]);
        free[s] -= q[s].substitute(kCount, Fraction(0));
      }
      for (int j = 0; j < order; ++j, free = times(matrix, free)) {
        form.oscillation.position[column].push_back(weighted(map.position, free));
        form.oscillation.velocity[column].push_back(weighted(map.velocity, free));
      }
    }
    for (int s = 0; s < force.states; ++s) form.states[s][column] = motion[s];
  }
  for (int column = 0; column < columns; ++column) {
    form.position.push_back(combined(map.position, form.states, column, force));
    form.velocity.push_back(combined(map.velocity, form.states, column, force));
  }
  return form;
}

Motion exact_position(int degree) {
  const Fraction t = Fraction::letter(kCount) * Fraction::letter(kStepLetter);
  Motion motion{Fraction(1), t};
  for (int d = 0; d <= degree; ++d) motion.push_back(t.pow(d + 2) * Fraction(Rational(1, (d + 1) * (d + 2))));
  return motion;
}

Motion exact_velocity(int degree) {
  const Fraction t = Fraction::letter(kCount) * Fraction::letter(kStepLetter);
  Motion motion{Fraction(0), Fraction(1)};
  for (int d = 0; d <= degree; ++d) motion.push_back(t.pow(d + 1) * Fraction(Rational(1, d + 1)));
  return motion;
}

MotionProof prove(const StepMap& map, const ClosedForm& form, const Progress& progress) {
  MotionProof proof;
  const int states = map.force.states;
  // The stepped values obey the recurrence of the matrix (order: its size) driven by polynomials in n, which
  // adds their degree + 1; so does the closed form, whose bases are the same eigenvalues. `finish` multiplies
  // by polynomials in n at most of the degree read here.
  int degree = 0;
  for (const auto* rows : {&map.step, &map.start})
    for (const LinearForm& row : *rows)
      for (int c = 0; c < row.columns(); ++c) degree = std::max(degree, row[c].numerator().degree(kCount));
  for (const LinearForm* row : {&map.position, &map.velocity})
    for (int c = 0; c < row->columns(); ++c) degree = std::max(degree, (*row)[c].numerator().degree(kCount));
  proof.recurrence = states + degree + 1;
  const auto values = stepped(map, form.valid_from + proof.recurrence - 1, progress);
  for (int n = form.valid_from; n < static_cast<int>(values.size()); ++n) {
    if (progress) progress("comparing the closed form with the steps", n, static_cast<int>(values.size()));
    ++proof.points;
    for (const auto& [row, motion] :
         {std::pair{&map.position, &form.position}, {&map.velocity, &form.velocity}}) {
      const LinearForm truth = reported(*row, values[n], n, states);
      for (std::size_t column = 0; column < motion->size(); ++column) {
        const int source =
            column < 2 ? static_cast<int>(column) : map.force.force_column(static_cast<int>(column) - 2);
        if (!(motion_at(form, motion == &form.position, n, column) == truth[source])) return proof;
      }
    }
  }
  proof.proved = true;
  return proof;
}

}  // namespace shortfall
