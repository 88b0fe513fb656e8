// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/stability/algebraic_letter.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall {

/// What one step multiplies the carried vectors by under x'' = -k x - c v.
///
/// Measured in units of the step (h = 1), where it depends on y = h^2 k and d = c h only: y stands in the
/// letter of k, d in that of c, and a parameter of dimension T^-j stands for its product with h^j. The
/// characteristic polynomial is z^zeros times `nonzero`.
struct Amplification {
  std::vector<std::string> letters;  ///< names, see letters.hpp
  std::vector<std::string> states;   ///< names of the carried vectors
  std::vector<AlgebraicLetter>
      algebraic;                  ///< letters that stand for numbers; all formulas are reduced by them
  SquareMatrix<Fraction> matrix;  ///< empty for `repeated` steps with two eigenvalues that are not 0
  int zeros =
      0;  ///< multiplicity of the eigenvalue 0: carried vectors that follow from the others, or are not used
  std::vector<Fraction> nonzero;  ///< monic, lowest power first
  std::vector<Fraction> pair;  ///< the factor {D, -T, 1} that tends to (z - 1)^2 as h -> 0; empty when it is
                               ///< no factor over the rational functions
  std::vector<Fraction> spurious{
      Fraction(1)};  ///< nonzero / pair, {1} when nothing is left; meaningful when there is a pair

  /// Of the pair that approximates the motion.
  ///
  /// throws  Unable  when it is no factor of its own: three or more eigenvalues belong together
  Fraction trace() const;
  Fraction determinant() const;
  /// How many eigenvalues there are besides 0 and the two of the motion.
  int spurious_count() const { return static_cast<int>(nonzero.size()) - 3; }
};

/// Of a matrix that is at hand, in the letters and units described above.
///
/// param   letters    names of all letters that occur, see letters.hpp
/// param   algebraic  those that stand for algebraic numbers, such as the root of 2 = w^3
/// throws  Undefined  when a denominator is zero with these numbers
Amplification amplification(SquareMatrix<Fraction> matrix, std::vector<std::string> letters,
                            std::vector<std::string> states, std::vector<AlgebraicLetter> algebraic = {});

enum class Damping { none, viscous };

/// What becomes of exp and pow of parameters, which are no rational functions of the step.
enum class FreeFunctions {
  evaluated,  ///< the parameters get their values, which must make numbers of them
  letters,    ///< letters of their own, as in closed forms
};

/// param   program  run once per step; frames of several substeps: see `repeated`
/// throws  Unable  when the step depends on t, or has too many free parameters;  Undefined  when a stage is
/// singular
Amplification amplification(const Program& program, const Values& given = {}, Damping damping = Damping::none,
                            FreeFunctions functions = FreeFunctions::evaluated);

/// Of a step of a length that is given, for damping whose share depends on it: all parameters have their
/// values, and letters and units are those of `Amplification`.
///
/// param   h        s, the step
/// param   rounded  gets the text of what functions make irrational, "pow(9/10, 1/60)", which is rounded to
/// 100
///                  digits; without it such values stay letters
/// throws  as above
Amplification amplification_at(const Program& program, const Values& given, const Rational& h,
                               Damping damping, std::set<std::string>* rounded = nullptr);

/// Of a frame of `count` steps, each of 1/count of the frame's h; without a matrix where two eigenvalues
/// matter.
Amplification repeated(const Amplification& step, int count);

/// For claims about the undamped oscillator x'' = -w^2 x: trace and determinant of its pair, in the letter of
/// k for h^2 w^2.
Fraction trace(const Program& program, const Values& given = {});
Fraction determinant(const Program& program, const Values& given = {});

}  // namespace shortfall
