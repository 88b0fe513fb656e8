// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/algebra/number_field.hpp"
#include "analysis/audit/method.hpp"
#include "analysis/problems/extra_letters.hpp"
#include "analysis/program/tableau_file.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

/// A tableau made ready for questions: its numbers, how they were written, and what is claimed of it.
///
/// Numbers are of one of three kinds that are never mixed: rational, with roots (and then proved), or known
/// to the digits printed.
struct AuditedTableau {
  enum class Numbers { rational, roots, digits };

  explicit AuditedTableau(const TableauFile& file);
  /// Of an integrator that is written as a tableau block.
  explicit AuditedTableau(const Program& program, const Values& given = {});

  std::string name;
  bool nystroem = false;
  bool c_given = true;
  Numbers numbers = Numbers::rational;
  TableauClaims claims;
  Method<Rational> rational;   ///< Numbers::rational
  Method<Fraction> roots;      ///< Numbers::roots; letters of `extras`, of which `field` knows the squares
  Method<KnownDigits> digits;  ///< always: what searches are made with when there are roots
  Method<std::string> texts;   ///< as written
  Method<int> places;          ///< digits after the point, of decimals that stand for other numbers; else 0
  std::shared_ptr<NumberField> field;  ///< this thread's innermost as long as the tableau lives
  std::shared_ptr<ExtraLetters> extras;
  Program program;

  std::size_t stages() const { return texts.b.size(); }
  /// A number with roots as a formula of the language.
  std::string formula(const Fraction& f) const;
  KnownDigits near(const Fraction& f) const;
  double to_double(const Fraction& f) const { return near(f).ball().to_double(); }
};

/// A constant of a program as a ball: its printed decimals are known to one unit of their last digit.
///
/// throws  Unable  for what is no number
KnownDigits known_value(const Expr& e, const Program& program, const Values& values = {});

/// "A[4][2]", "b[5]", "bhat[1]": as in the file, counted from 1.
std::string cell_name(const Cell& cell, bool nystroem);

}  // namespace shortfall
