// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/lyndon_basis.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// An element of the free Lie algebra on A and B over a field, without what is above a degree.
///
/// Invariant: parts_[d] has one coordinate for each Lyndon word of length d, 1 <= d <= degree(). All
/// operations are exact up to that degree; two operands must have the same one.
template <class Field>
class LieElement {
 public:
  /// The zero element.
  ///
  /// throws  Unable  when the degree is not from 1 to 12
  explicit LieElement(int degree) : basis_(&LyndonBasis::up_to(degree)) {
    parts_.resize(static_cast<std::size_t>(degree) + 1);
    for (int d = 1; d <= degree; ++d)
      parts_[static_cast<std::size_t>(d)].assign(static_cast<std::size_t>(basis_->dimension(d)), Field(0));
  }
  static LieElement a(int degree) { return basis_element(degree, 1, 0); }
  static LieElement b(int degree) { return basis_element(degree, 1, 1); }
  static LieElement basis_element(int degree, int d, int index) {
    LieElement result(degree);
    result.at(d, index) = Field(1);
    return result;
  }
  /// Only one degree, with these coordinates.
  static LieElement homogeneous(int degree, int d, std::vector<Field> coordinates) {
    LieElement result(degree);
    if (coordinates.size() != result.part(d).size())
      throw Error("degree " + std::to_string(d) + " has " + std::to_string(result.part(d).size()) +
                  " coordinates, not " + std::to_string(coordinates.size()));
    result.parts_[static_cast<std::size_t>(d)] = std::move(coordinates);
    return result;
  }

  int degree() const { return static_cast<int>(parts_.size()) - 1; }
  const LyndonBasis& basis() const { return *basis_; }
  const std::vector<Field>& part(int d) const { return parts_[static_cast<std::size_t>(d)]; }
  std::vector<Field>& part(int d) { return parts_[static_cast<std::size_t>(d)]; }
  const Field& at(int d, int index) const { return part(d)[static_cast<std::size_t>(index)]; }
  Field& at(int d, int index) { return part(d)[static_cast<std::size_t>(index)]; }
  bool is_zero() const { return lowest_degree() == 0; }
  /// The lowest degree that is not zero; 0 for the zero element.
  int lowest_degree() const {
    for (int d = 1; d <= degree(); ++d)
      for (const Field& c : part(d))
        if (!c.is_zero()) return d;
    return 0;
  }

  LieElement operator-() const { return Field(-1) * *this; }
  LieElement& operator+=(const LieElement& other) {
    check(other);
    for (int d = 1; d <= degree(); ++d)
      for (std::size_t i = 0; i < part(d).size(); ++i) part(d)[i] += other.part(d)[i];
    return *this;
  }
  LieElement& operator-=(const LieElement& other) {
    check(other);
    for (int d = 1; d <= degree(); ++d)
      for (std::size_t i = 0; i < part(d).size(); ++i) part(d)[i] -= other.part(d)[i];
    return *this;
  }
  LieElement& operator*=(const Field& factor) {
    for (auto& part : parts_)
      for (Field& c : part) c *= factor;
    return *this;
  }
  friend LieElement operator+(LieElement x, const LieElement& y) { return x += y; }
  friend LieElement operator-(LieElement x, const LieElement& y) { return x -= y; }
  friend LieElement operator*(const Field& factor, LieElement x) { return x *= factor; }
  bool operator==(const LieElement& other) const { return parts_ == other.parts_; }

  /// [x, y].
  friend LieElement bracket(const LieElement& x, const LieElement& y) {
    x.check(y);
    LieElement result(x.degree());
    for (int d1 = 1; d1 < x.degree(); ++d1) {
      for (std::size_t i = 0; i < x.part(d1).size(); ++i) {
        if (x.part(d1)[i].is_zero()) continue;
        for (int d2 = 1; d1 + d2 <= x.degree(); ++d2) {
          for (std::size_t j = 0; j < y.part(d2).size(); ++j) {
            if (y.part(d2)[j].is_zero()) continue;
            const Field product = x.part(d1)[i] * y.part(d2)[j];
            for (const auto& [index, c] : x.basis_->bracket(d1, static_cast<int>(i), d2, static_cast<int>(j)))
              result.at(d1 + d2, index) += Field(c) * product;
          }
        }
      }
    }
    return result;
  }

 private:
  void check(const LieElement& other) const {
    if (degree() != other.degree())
      throw Error("Lie elements to degree " + std::to_string(degree()) + " and to degree " +
                  std::to_string(other.degree()) + " were combined");
  }
  const LyndonBasis* basis_;
  std::vector<std::vector<Field>> parts_;
};

/// exp(ad c) x = x + [c, x] + [c, [c, x]] / 2 + ..., which is exp(c) x exp(-c).
template <class Field>
LieElement<Field> exp_ad(const LieElement<Field>& c, const LieElement<Field>& x) {
  LieElement<Field> result = x;
  LieElement<Field> term = x;
  for (int k = 1; k < x.degree(); ++k) {
    term = bracket(c, term);
    if (term.is_zero()) break;
    term *= Field(1) / Field(k);
    result += term;
  }
  return result;
}

/// "A + B - 1/2*[A,B]"; coefficients written by the caller's function, without brackets around sums.
template <class Field, class Write>
std::string text(const LieElement<Field>& x, const Write& write) {
  std::string result;
  for (int d = 1; d <= x.degree(); ++d) {
    for (std::size_t i = 0; i < x.part(d).size(); ++i) {
      const Field& c = x.part(d)[i];
      if (c.is_zero()) continue;
      std::string factor = write(c);
      bool minus = factor.starts_with('-');
      if (factor.find(' ') != std::string::npos) {
        factor = "(" + factor + ")";
        minus = false;
      } else if (minus) {
        factor.erase(0, 1);
      }
      result += result.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
      if (factor != "1") result += factor + "*";
      result += x.basis().bracket_text(d, static_cast<int>(i));
    }
  }
  return result.empty() ? "0" : result;
}

inline std::string text(const LieElement<Rational>& x) {
  return text(x, [](const Rational& c) { return c.str(); });
}

}  // namespace shortfall
