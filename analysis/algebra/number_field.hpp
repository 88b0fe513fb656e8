// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/polynomial.hpp"

namespace shortfall {

/// While it lives, some letters of this thread's rational functions are algebraic numbers: every Fraction is
/// reduced modulo their minimal polynomials, and no denominator contains them. So equality stays structural,
/// and what is zero is seen to be zero.
///
/// Fields may be nested; the innermost counts. A Fraction must be used within a field that has the generators
/// of the one in which it was made.
class NumberField {
 public:
  /// A letter g with minimal polynomial sum of coefficients[k] g^k, irreducible over the field of those
  /// before it.
  struct Generator {
    Letter letter;
    std::vector<Rational> minimal;  ///< lowest power first, monic

    int degree() const { return static_cast<int>(minimal.size()) - 1; }
    bool operator==(const Generator&) const = default;
  };

  explicit NumberField(std::vector<Generator> generators = {});
  NumberField(const NumberField&) = delete;
  NumberField& operator=(const NumberField&) = delete;
  ~NumberField();

  /// One more generator, from here on.
  void adjoin(Generator generator);
  const std::vector<Generator>& generators() const { return generators_; }

  /// The innermost field; nullptr when no letter is algebraic.
  static const NumberField* current() { return current_; }
  static NumberField* innermost() { return current_; }

  /// Powers of the generators replaced by lower ones.
  Polynomial reduced(Polynomial p) const;

  /// Reduces a quotient whose denominator is not 0; afterwards the denominator is free of the generators, and
  /// the two need not be in lowest terms.
  ///
  /// throws  Undefined  when the denominator is zero in the field
  void settle(Polynomial& numerator, Polynomial& denominator) const;

 private:
  bool concerns(const Polynomial& p) const;
  static inline thread_local NumberField* current_ = nullptr;
  NumberField* outer_;
  std::vector<Generator> generators_;
};

}  // namespace shortfall
