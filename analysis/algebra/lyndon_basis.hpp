// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shortfall {

/// A word in the two letters A and B.
///
/// Invariant: below the leading one of `code` stand the letters, the first one highest, 0 for A and 1 for B.
/// So 1 is the empty word, words of one length are ordered as their codes are, and A < B.
struct Word {
  std::uint32_t code = 1;

  static Word of(std::string_view letters);  ///< Word::of("AAB"); throws Error for another letter
  int length() const;
  int count_b() const;  ///< how often B occurs
  int count_a() const { return length() - count_b(); }
  /// `count` letters from place `first` on, counted from 0.
  Word part(int first, int count) const;
  std::string str() const;  ///< "AAB"
  bool operator==(const Word&) const = default;
};

Word operator*(Word a, Word b);  ///< one after the other

/// A basis of the free Lie algebra on A and B: Lyndon words with their standard brackets, degree by degree.
///
/// P_w = [P_u, P_v] with w = u v, v the longest proper Lyndon suffix. As a polynomial in words P_w is w plus
/// larger words, so that the coefficients of a Lie element at the Lyndon words determine it.
///
/// source  Lothaire (1983), Combinatorics on Words, Theorem 5.3.1; Reutenauer (1993), Free Lie Algebras, 5.1
class LyndonBasis {
 public:
  static constexpr int kHighestDegree = 12;

  struct Term {
    int index;                 ///< of a basis element of the sum of the degrees
    std::int32_t coefficient;  ///< structure constants of this basis are whole numbers
    bool operator==(const Term&) const = default;
  };

  /// The basis to a degree, made once and kept.
  ///
  /// throws  Unable  when the degree is not from 1 to 12
  static const LyndonBasis& up_to(int degree);

  int degree() const { return static_cast<int>(levels_.size()) - 1; }
  int dimension(int degree) const { return static_cast<int>(level(degree).words.size()); }
  /// Lyndon words of one length, in increasing order.
  std::span<const Word> words(int degree) const { return level(degree).words; }
  /// "[A,[A,B]]".
  std::string bracket_text(int degree, int index) const;
  /// The two factors of the standard bracketing; each a degree and an index there.
  std::pair<std::pair<int, int>, std::pair<int, int>> factors(int degree, int index) const;

  /// [P_i, P_j] for the i-th element of degree d1 and the j-th of degree d2, d1 + d2 <= degree().
  std::span<const Term> bracket(int d1, int i, int d2, int j) const;

  /// [x, X] for x of degree n - 1 and a letter X, 0 for A and 1 for B.
  template <class Field>
  std::vector<Field> with_letter(int n, const std::vector<Field>& x, int letter) const {
    std::vector<Field> result(static_cast<std::size_t>(dimension(n)), Field(0));
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i].is_zero()) continue;
      for (const Term& t : bracket(n - 1, static_cast<int>(i), 1, letter))
        result[static_cast<std::size_t>(t.index)] += Field(t.coefficient) * x[i];
    }
    return result;
  }

  /// P as a polynomial in words: the coefficient at the word that has `letters` below its leading one.
  std::span<const std::int32_t> polynomial(int degree, int index) const;

  /// Coordinates of the Lie polynomial that has these coefficients at the Lyndon words of a degree.
  template <class Field>
  std::vector<Field> coordinates(int degree, std::vector<Field> at_lyndon_words) const {
    const Level& here = level(degree);
    for (std::size_t i = 0; i < at_lyndon_words.size(); ++i) {
      if (at_lyndon_words[i].is_zero()) continue;
      for (const Term& t : here.larger[i])
        at_lyndon_words[static_cast<std::size_t>(t.index)] -= Field(t.coefficient) * at_lyndon_words[i];
    }
    return at_lyndon_words;
  }

 private:
  struct Level {
    std::vector<Word> words;
    std::vector<std::pair<std::pair<int, int>, std::pair<int, int>>> factors;
    std::vector<std::vector<std::int32_t>> polynomials;  ///< [element][letters]
    std::vector<std::vector<Term>> larger;  ///< of each element: its coefficients at larger Lyndon words
    /// [d1][i * dimension(d2) + j] for brackets of degrees d1 and d2 that end here
    std::vector<std::vector<std::vector<Term>>> brackets;
  };

  explicit LyndonBasis(int degree);
  void add_level(int degree);
  void add_brackets(int degree);
  std::pair<int, int> place(Word w) const;
  const Level& level(int degree) const;

  std::vector<Level> levels_;  ///< levels_[0] is empty
};

/// The number of Lyndon words of a length on two letters.
///
/// source  Witt (1937), Treue Darstellung Liescher Ringe: the sum of mu(d) 2^(n/d) / n over the divisors d of
/// n
int witt_dimension(int degree);

}  // namespace shortfall
