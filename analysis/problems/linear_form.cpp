// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/linear_form.hpp"

#include <algorithm>

namespace shortfall {

LinearForm LinearForm::column(int index, Fraction coefficient) {
  LinearForm form;
  form.at(index) = std::move(coefficient);
  return form;
}

const Fraction& LinearForm::operator[](int column) const {
  static const Fraction zero;
  return column < columns() ? coefficients_[column] : zero;
}

Fraction& LinearForm::at(int column) {
  if (column >= columns()) coefficients_.resize(column + 1);
  return coefficients_[column];
}

bool LinearForm::is_zero() const {
  return std::ranges::all_of(coefficients_, [](const Fraction& c) { return c.is_zero(); });
}

LinearForm LinearForm::operator-() const {
  LinearForm result = *this;
  for (Fraction& c : result.coefficients_) c = -c;
  return result;
}

LinearForm& LinearForm::operator+=(const LinearForm& other) {
  for (int i = 0; i < other.columns(); ++i)
    if (!other.coefficients_[i].is_zero()) at(i) += other.coefficients_[i];
  return *this;
}

LinearForm& LinearForm::operator-=(const LinearForm& other) {
  for (int i = 0; i < other.columns(); ++i)
    if (!other.coefficients_[i].is_zero()) at(i) -= other.coefficients_[i];
  return *this;
}

LinearForm& LinearForm::operator*=(const Fraction& factor) {
  for (Fraction& c : coefficients_)
    if (!c.is_zero()) c *= factor;
  return *this;
}

bool operator==(const LinearForm& a, const LinearForm& b) {
  for (int i = 0; i < std::max(a.columns(), b.columns()); ++i)
    if (!(a[i] == b[i])) return false;
  return true;
}

LinearForm LinearForm::substitute(Letter letter, const Fraction& value) const {
  LinearForm result = *this;
  for (Fraction& c : result.coefficients_) c = c.substitute(letter, value);
  return result;
}

}  // namespace shortfall
