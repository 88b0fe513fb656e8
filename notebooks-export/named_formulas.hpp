// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// The longest rational function of letters that is written out where it stands: characters.
inline constexpr std::size_t kLongestPiece = 150;

/// Formulas as text in which long pieces have names: a rational function of letters (no x0, v0, n, t, no
/// sine) that takes more than kLongestPiece characters becomes p1, p2, ..., the same one, or a multiple of
/// it, the same name.
///
/// What was named is told after the formulas: how many terms it has, of what degree, and how it begins.
class NamedFormulas {
 public:
  /// param   full   nothing is named
  /// param   taken  names that the formulas use already
  NamedFormulas(Style style, bool full, const std::vector<std::string>& taken);

  Style style() const { return style_; }
  bool full() const { return full_; }
  std::string print(const Expr& e);
  /// The formula with names for its long pieces, as `print` writes it.
  Expr shortened(const Expr& e);
  /// What the names stand for.
  std::vector<std::pair<std::string, Expr>> named_values() const;
  /// One line for each piece that was named since this was asked last; empty when none was.
  std::string introduced();
  /// For LaTeX: the names and what they stand for.
  std::vector<std::pair<std::string, std::string>> introduced_pairs();

 private:
  struct Piece {
    Fraction primitive;  ///< numerator monic
    Rational factor;     ///< the piece is factor * primitive
    std::string name;
    Expr value;
  };
  Expr named(const Expr& e);
  Expr gathered(const Expr& e);
  std::string description(const Piece& piece) const;
  Letter letter(const std::string& name);
  Fraction fraction(const Expr& e);

  Style style_;
  bool full_;
  std::string stem_;
  std::vector<Piece> pieces_;
  std::size_t told_ = 0;
  std::map<std::string, Letter> letters_;
  Wording wording_;  ///< of the same letters
};

/// A long polynomial or quotient in short: its size, its degree in each letter, and how it begins, its
/// coefficients rounded to 6 digits where they are longer.
std::string digest(const Expr& e, const Fraction& f, const std::map<std::string, Letter>& letters,
                   Style style);

}  // namespace shortfall
