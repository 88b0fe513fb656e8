// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/amplification.hpp"

#include <algorithm>
#include <utility>

#include "analysis/motion/step_map.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/problems/undisturbed_numbers.hpp"
#include "analysis/stability/motion_pair.hpp"

namespace shortfall {

namespace {

/// Whether a factor has the root 1 where there is no force.
bool belongs_to_motion(const Polynomial& factor) {
  return factor.substitute(kStiffness, Rational(0))
      .substitute(kDamping, Rational(0))
      .substitute(kEigenvalue, Rational(1))
      .is_zero();
}

struct TraceAndDeterminant {
  Fraction trace;
  Fraction determinant;
};

/// Of M^count, from those of M: with roots z and w, V_k = z^k + w^k and D = z w,
/// V_2k = V_k^2 - 2 D^k and V_2k+1 = V_k V_k+1 - V_1 D^k. No entry of M is needed.
///
/// source  Lucas (1878), Theorie des fonctions numeriques simplement periodiques
template <class Reduce>
TraceAndDeterminant of_power(const TraceAndDeterminant& m, int count, Reduce reduce) {
  Fraction now = 2, next = m.trace, power = 1;  // V_k, V_k+1, D^k for the leading bits k of count
  for (int bit = 30; bit >= 0; --bit) {
    const bool odd = (count >> bit & 1) != 0;
    if (count >> bit == 0) continue;
    const bool last = bit == 0;
    Fraction between, beyond;
    if (odd || !last) between = reduce(now * next - m.trace * power);
    if (odd && !last) beyond = reduce(next * next - Fraction(2) * power * m.determinant);
    if (!odd) now = reduce(now * now - Fraction(2) * power);
    power = reduce(power * power);
    if (odd) {
      power = reduce(power * m.determinant);
      now = between;
      next = beyond;
    } else {
      next = between;
    }
  }
  return {now, power};
}

void split(Amplification& a) {
  std::vector<Fraction> p = characteristic_coefficients(a.matrix);
  for (Fraction& c : p) c = reduced(c, a.algebraic);
  MotionPair found = motion_pair(p, belongs_to_motion);
  a.zeros = found.zeros;
  a.nonzero = std::move(found.nonzero);
  a.pair = std::move(found.pair);
  a.spurious = std::move(found.spurious);
}

}  // namespace

Fraction Amplification::trace() const {
  if (pair.empty())
    throw Unable("the motion's two eigenvalues cannot be told from " + std::to_string(spurious_count()) +
                 " spurious one(s) by a formula without roots, so there is no trace of their own");
  return -pair[1];
}

Fraction Amplification::determinant() const {
  if (pair.empty()) trace();
  return pair[0];
}

Amplification amplification(SquareMatrix<Fraction> matrix, std::vector<std::string> letters,
                            std::vector<std::string> states, std::vector<AlgebraicLetter> algebraic) {
  Amplification result;
  result.letters = std::move(letters);
  result.states = std::move(states);
  result.algebraic = std::move(algebraic);
  result.matrix = reduced(std::move(matrix), result.algebraic);
  split(result);
  return result;
}

Amplification amplification(const Program& program, const Values& given, Damping damping,
                            FreeFunctions functions) {
  const Fraction c = damping == Damping::viscous ? Fraction::letter(kDamping) : Fraction();
  const auto is_number = [](const ExtraLetters::Extra& e) { return e.root != nullptr; };
  StepMap map = step_map(lower(program, given), -1, Fraction::letter(kStiffness), c);
  // exp and pow of parameters are no rational functions; of the parameters' values they may be numbers.
  if (functions == FreeFunctions::evaluated && !std::ranges::all_of(map.extras, is_number))
    map = step_map(lower(program, parameter_values(program, given)), -1, Fraction::letter(kStiffness), c);
  std::vector<AlgebraicLetter> algebraic;
  for (const ExtraLetters::Extra& e : map.extras) {
    if (!e.root && functions == FreeFunctions::letters) continue;
    if (!e.root)
      throw Unable("the step of " + program.name + " contains " + e.name +
                   ", which depends on the length of the step itself: say how long it is, with --dt");
    algebraic.push_back({e.letter, *e.root});
  }
  const NumberField field(map.generators);
  SquareMatrix<Fraction> matrix;
  for (auto& row : map.matrix()) {
    matrix.emplace_back();
    for (const Fraction& f : row) {
      if (f.contains(kCount))
        throw Unable("the step of " + program.name + " changes with t, so it has no amplification matrix");
      matrix.back().push_back(f.substitute(kStepLetter, Fraction(1)));
    }
  }
  return amplification(std::move(matrix), map.letters, map.states, std::move(algebraic));
}

Amplification amplification_at(const Program& program, const Values& given, const Rational& h,
                               Damping damping, std::set<std::string>* rounded) {
  const Tape tape = lower(program, parameter_values(program, given));
  const Fraction c = damping == Damping::viscous ? Fraction::letter(kDamping) : Fraction();
  StepMap map = step_map(tape, -1, Fraction::letter(kStiffness), c, Fraction(h));
  const NumberField field(map.generators);
  std::vector<std::pair<Letter, Rational>> values;
  std::vector<AlgebraicLetter> algebraic;
  const auto number = [&](Fraction f) {
    for (const auto& [letter, value] : values) f = f.substitute(letter, value);
    if (!f.is_constant())
      throw Unable("the step of " + program.name + " contains a function of roots, which we do not round");
    return f.constant();
  };
  for (const ExtraLetters::Extra& e : map.extras) {
    if (e.root)
      algebraic.push_back({e.letter, *e.root});
    else if (rounded)
      values.emplace_back(e.letter, value_to_100_digits(e.function, number(e.a), number(e.b), rounded));
  }
  // In units of the step a vector of dimension L T^p is h^-p times what it is in seconds.
  std::vector<int> time;
  for (const Dimension& d : tape.state_dimensions) time.push_back(d.time);
  SquareMatrix<Fraction> matrix = map.matrix();
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      Fraction& f = matrix[i][j];
      if (f.contains(kCount))
        throw Unable("the step of " + program.name + " changes with t, so it has no amplification matrix");
      for (const auto& [letter, value] : values) f = f.substitute(letter, value);
      f = f.substitute(kStiffness, Fraction::letter(kStiffness) / Fraction(h * h))
              .substitute(kDamping, Fraction::letter(kDamping) / Fraction(h)) *
          Fraction(h.pow(time[j] - time[i]));
    }
  return amplification(std::move(matrix), map.letters, map.states, std::move(algebraic));
}

Amplification repeated(const Amplification& step, int count) {
  if (count == 1) return step;
  const auto of_part = [count](const Fraction& f) {
    return f.substitute(kStiffness, Fraction::letter(kStiffness) / Fraction(count * count))
        .substitute(kDamping, Fraction::letter(kDamping) / Fraction(count));
  };
  if (step.nonzero.size() == 3) {
    Amplification result{.letters = step.letters,
                         .states = step.states,
                         .algebraic = step.algebraic,
                         .matrix = {},
                         .zeros = step.zeros,
                         .nonzero = {},
                         .pair = {}};
    const TraceAndDeterminant frame = of_power({of_part(step.trace()), of_part(step.determinant())}, count,
                                               [&](const Fraction& f) { return reduced(f, step.algebraic); });
    result.nonzero = result.pair = {frame.determinant, -frame.trace, Fraction(1)};
    return result;
  }
  SquareMatrix<Fraction> once = step.matrix;
  for (auto& row : once)
    for (Fraction& f : row) f = of_part(f);
  SquareMatrix<Fraction> matrix = once;
  for (int k = 1; k < count; ++k) matrix = reduced(product(matrix, once), step.algebraic);
  return amplification(std::move(matrix), step.letters, step.states, step.algebraic);
}

Fraction trace(const Program& program, const Values& given) { return amplification(program, given).trace(); }

Fraction determinant(const Program& program, const Values& given) {
  return amplification(program, given).determinant();
}

}  // namespace shortfall
