// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/sequence.hpp"

#include <algorithm>

namespace shortfall {

Sequence::Sequence(const Fraction& base, const Fraction& coefficient) { add(base, coefficient); }

void Sequence::add(const Fraction& base, const Fraction& coefficient) {
  if (coefficient.is_zero()) return;
  const auto found = std::ranges::find_if(terms_, [&](const Term& t) { return t.base == base; });
  if (found == terms_.end()) {
    terms_.push_back({base, coefficient});
    return;
  }
  found->coefficient += coefficient;
  if (found->coefficient.is_zero()) terms_.erase(found);
}

bool Sequence::is_polynomial() const {
  return std::ranges::all_of(terms_, [](const Term& t) { return t.base == Fraction(1); });
}

Fraction Sequence::polynomial() const {
  for (const Term& t : terms_)
    if (t.base == Fraction(1)) return t.coefficient;
  return {};
}

Sequence Sequence::operator-() const {
  Sequence result = *this;
  for (Term& t : result.terms_) t.coefficient = -t.coefficient;
  return result;
}

Sequence& Sequence::operator+=(const Sequence& other) {
  for (const Term& t : other.terms_) add(t.base, t.coefficient);
  return *this;
}

Sequence& Sequence::operator-=(const Sequence& other) {
  for (const Term& t : other.terms_) add(t.base, -t.coefficient);
  return *this;
}

Sequence& Sequence::operator*=(const Fraction& factor) {
  if (factor.is_zero()) terms_.clear();
  for (Term& t : terms_) t.coefficient *= factor;
  return *this;
}

Sequence operator*(const Sequence& a, const Sequence& b) {
  Sequence result;
  for (const Sequence::Term& s : a.terms_)
    for (const Sequence::Term& t : b.terms_) result.add(s.base * t.base, s.coefficient * t.coefficient);
  return result;
}

Fraction Sequence::at(int n) const {
  Fraction value;
  for (const Term& t : terms_) {
    const Fraction coefficient = t.coefficient.substitute(kCount, Fraction(n));
    value += t.base == Fraction(1) ? coefficient : coefficient * t.base.pow(n);
  }
  return value;
}

Sequence Sequence::shifted(int by) const {
  const Fraction later = Fraction::letter(kCount) + Fraction(by);
  Sequence result;
  for (const Term& t : terms_) result.add(t.base, t.coefficient.substitute(kCount, later) * t.base.pow(by));
  return result;
}

}  // namespace shortfall
