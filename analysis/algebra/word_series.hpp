// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/algebra/lie_element.hpp"

namespace shortfall {

/// A power series in A and B that do not commute, without what is above a degree.
///
/// Invariant: one coefficient for each word of length 0 .. degree(), at the place Word::code.
template <class Field>
class WordSeries {
 public:
  /// The series 1.
  ///
  /// throws  Unable  when the degree is not from 1 to 12
  explicit WordSeries(int degree) : degree_(LyndonBasis::up_to(degree).degree()) {
    values_.assign(std::size_t{2} << degree, Field(0));
    values_[1] = Field(1);
  }
  static WordSeries zero(int degree) {
    WordSeries result(degree);
    result.values_[1] = Field(0);
    return result;
  }
  /// The Lie element written out in words.
  explicit WordSeries(const LieElement<Field>& x) : WordSeries(zero(x.degree())) {
    for (int d = 1; d <= degree_; ++d)
      for (std::size_t i = 0; i < x.part(d).size(); ++i) {
        const Field& c = x.part(d)[i];
        if (c.is_zero()) continue;
        const auto p = x.basis().polynomial(d, static_cast<int>(i));
        for (std::size_t w = 0; w < p.size(); ++w)
          if (p[w] != 0) values_[(std::size_t{1} << d) + w] += Field(p[w]) * c;
      }
  }

  int degree() const { return degree_; }
  const Field& operator[](Word w) const { return values_[w.code]; }
  Field& operator[](Word w) { return values_[w.code]; }
  bool operator==(const WordSeries&) const = default;

  /// This times exp(c X), X the letter B or A, in place.
  void multiply_by_exponential(bool letter_b, const Field& c) {
    std::vector<Field> powers{Field(1)};  // c^k / k!
    for (int k = 1; k <= degree_; ++k) powers.push_back(powers.back() * c / Field(k));
    const std::uint32_t letter = letter_b ? 1 : 0;
    // Longest words first: what is added comes from shorter ones, which are still as they were.
    for (std::uint32_t w = static_cast<std::uint32_t>(values_.size()) - 1; w > 1; --w) {
      std::uint32_t head = w;
      for (std::size_t k = 1; head > 1 && (head & 1U) == letter; ++k) {
        head >>= 1;
        if (!values_[head].is_zero()) values_[w] += powers[k] * values_[head];
      }
    }
  }

  friend WordSeries operator*(const WordSeries& x, const WordSeries& y) {
    if (x.degree_ != y.degree_) throw Error("series to different degrees were multiplied");
    WordSeries result = zero(x.degree_);
    for (std::uint32_t w = 1; w < x.values_.size(); ++w) {
      const int n = Word{w}.length();
      for (int k = 0; k <= n; ++k) {
        const Field& tail = y.values_[(1U << k) | (w & ((1U << k) - 1))];
        const Field& head = x.values_[w >> k];
        if (!head.is_zero() && !tail.is_zero()) result.values_[w] += head * tail;
      }
    }
    return result;
  }
  WordSeries& operator+=(const WordSeries& other) {
    for (std::size_t w = 0; w < values_.size(); ++w) values_[w] += other.values_[w];
    return *this;
  }
  WordSeries& operator*=(const Field& factor) {
    for (Field& c : values_) c *= factor;
    return *this;
  }

 private:
  int degree_;
  std::vector<Field> values_;
};

/// exp(x) = 1 + x + x^2 / 2 + ...
template <class Field>
WordSeries<Field> exp(const LieElement<Field>& x) {
  const WordSeries<Field> words(x);
  WordSeries<Field> result(x.degree());
  for (int k = x.degree(); k >= 1; --k) {  // Horner: 1 + x (1 + x/2 (1 + x/3 (...)))
    result = words * result;
    result *= Field(1) / Field(k);
    result[Word{}] += Field(1);
  }
  return result;
}

/// The logarithm of a product of exponentials, in the Lyndon basis.
///
/// Only coefficients at Lyndon words are worked out: the sum over all ways to cut the word into k pieces of
/// (-1)^(k-1) / k times the product of the series at the pieces. The series must be group-like (an
/// exponential of a Lie element, or a product of such): then its logarithm is a Lie element, which those
/// determine.
template <class Field>
LieElement<Field> log(const WordSeries<Field>& series) {
  LieElement<Field> result(series.degree());
  const LyndonBasis& basis = result.basis();
  for (int d = 1; d <= series.degree(); ++d) {
    std::vector<Field> at;
    for (const Word w : basis.words(d)) {
      // pieces[end]: the sum over all ways to cut the first `end` letters into as many pieces as rounds were.
      const auto n = static_cast<std::size_t>(d);
      std::vector<Field> pieces(n + 1, Field(0));
      std::vector<Field> whole(n * (n + 1), Field(0));
      for (int first = 0; first < d; ++first)
        for (int end = first + 1; end <= d; ++end)
          whole[static_cast<std::size_t>(first) * (n + 1) + static_cast<std::size_t>(end)] =
              series[w.part(first, end - first)];
      pieces[0] = Field(1);
      Field sum(0);
      for (int k = 1; k <= d; ++k) {
        std::vector<Field> next(n + 1, Field(0));
        for (std::size_t end = static_cast<std::size_t>(k); end <= n; ++end)
          for (std::size_t first = static_cast<std::size_t>(k - 1); first < end; ++first) {
            const Field& piece = whole[first * (n + 1) + end];
            if (!piece.is_zero() && !pieces[first].is_zero()) next[end] += pieces[first] * piece;
          }
        pieces = std::move(next);
        if (!pieces[n].is_zero()) sum += pieces[n] / Field(k % 2 == 1 ? k : -k);
      }
      at.push_back(std::move(sum));
    }
    result.part(d) = basis.coordinates(d, std::move(at));
  }
  return result;
}

/// log(exp(x) exp(y)), the series of Baker, Campbell and Hausdorff.
template <class Field>
LieElement<Field> bch(const LieElement<Field>& x, const LieElement<Field>& y) {
  return log(exp(x) * exp(y));
}

}  // namespace shortfall
