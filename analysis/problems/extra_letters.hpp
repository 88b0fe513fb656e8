// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/function.hpp"

namespace shortfall {

/// Letters that a run in letters takes on its way, for what is no rational function of the others: roots of
/// polynomials, square roots of rational numbers, exp and pow.
///
/// Roots and square roots are generators of the NumberField that must be open while they are used; exp and
/// pow are free letters: what is proved with them holds for every value of them.
class ExtraLetters {
 public:
  struct Extra {
    Letter letter;
    std::string name;  ///< as an expression of the language: "theta", "sqrt(2)", "exp(-c*h)"
    std::shared_ptr<const RealRoot> root;  ///< what it is, for an algebraic one
    Function function = Function::exp;     ///< for the others: function(a, b)
    Fraction a;
    Fraction b;
  };
  struct Assumed {
    Fraction positive;
    std::string text;
    bool used = false;
  };

  /// param   names  of the letters so far, see letters.hpp; those taken here are appended
  explicit ExtraLetters(std::vector<std::string> names) : names_(std::move(names)) {}

  /// A root by its name. Roots of degree 2 become a + b sqrt(D), so that they fit with other square roots.
  ///
  /// throws  Unable  when it cannot be told from the other generators' field
  Fraction root(const RealRoot& root, const std::string& name);
  /// throws  Unable  for a value that no letter can stand for, or for max and min that no assumption decides
  Fraction function(Function f, const Fraction& a, const Fraction& b);
  /// From here on this is taken to be positive.
  void assume(Fraction positive, std::string text);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<Extra>& all() const { return extras_; }
  std::vector<NumberField::Generator> generators() const;
  /// The assumptions that decided something.
  std::vector<std::string> used() const;

 private:
  Fraction square_root(const Rational& value);
  Fraction square_root_of_prime(const Rational& prime);
  Letter new_letter(std::string name);
  void adjoin(Extra extra);
  int sign(const Fraction& difference, Function f);

  std::vector<std::string> names_;
  std::vector<Extra> extras_;
  std::vector<Assumed> assumed_;
};

}  // namespace shortfall
