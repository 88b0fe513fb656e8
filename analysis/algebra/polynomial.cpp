// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/polynomial.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/algebra/error.hpp"

namespace shortfall {
namespace {

using Term = Polynomial::Term;

bool precedes(const Term& a, const Term& b) { return b.monomial < a.monomial; }

}  // namespace

Polynomial::Polynomial(Rational constant) {
  if (!constant.is_zero()) terms_.push_back({Monomial(), std::move(constant)});
}

Polynomial Polynomial::letter(Letter letter, int exponent) {
  Polynomial result;
  result.terms_.push_back({Monomial::of(letter, exponent), 1});
  return result;
}

Polynomial Polynomial::in(Letter letter, std::span<const Rational> coefficients) {
  Polynomial result;
  for (std::size_t k = coefficients.size(); k-- > 0;)
    if (!coefficients[k].is_zero())
      result.terms_.push_back({Monomial::of(letter, static_cast<int>(k)), coefficients[k]});
  return result;
}

Polynomial Polynomial::from_terms(std::vector<Term> terms) {
  if (!std::is_sorted(terms.begin(), terms.end(), precedes)) std::sort(terms.begin(), terms.end(), precedes);
  Polynomial result;
  result.terms_.reserve(terms.size());
  for (std::size_t i = 0; i < terms.size();) {
    Term sum = std::move(terms[i]);
    for (++i; i < terms.size() && terms[i].monomial == sum.monomial; ++i)
      sum.coefficient += terms[i].coefficient;
    if (!sum.coefficient.is_zero()) result.terms_.push_back(std::move(sum));
  }
  return result;
}

bool Polynomial::is_constant() const {
  return terms_.empty() || (terms_.size() == 1 && terms_.front().monomial.is_one());
}

Rational Polynomial::constant() const {
  // The monomial 1 is the smallest.
  return !terms_.empty() && terms_.back().monomial.is_one() ? terms_.back().coefficient : Rational();
}

int Polynomial::degree(Letter letter) const {
  int most = -1;
  for (const Term& term : terms_) most = std::max(most, term.monomial.exponent(letter));
  return most;
}

int Polynomial::total_degree() const { return terms_.empty() ? -1 : terms_.front().monomial.total_degree(); }

Polynomial Polynomial::operator-() const {
  Polynomial result;
  result.terms_.reserve(terms_.size());
  for (const Term& term : terms_) result.terms_.push_back({term.monomial, -term.coefficient});
  return result;
}

void Polynomial::add(const Polynomial& other, bool negated) {
  const auto signed_coefficient = [negated](const Term& term) {
    return negated ? -term.coefficient : term.coefficient;
  };
  if (other.terms_.empty()) return;
  if (other.terms_.size() == 1) {
    const Term& term = other.terms_.front();
    const auto place = std::lower_bound(terms_.begin(), terms_.end(), term, precedes);
    if (place == terms_.end() || !(place->monomial == term.monomial)) {
      terms_.insert(place, {term.monomial, signed_coefficient(term)});
      return;
    }
    if (negated)
      place->coefficient -= term.coefficient;
    else
      place->coefficient += term.coefficient;
    if (place->coefficient.is_zero()) terms_.erase(place);
    return;
  }
  std::vector<Term> sum;
  sum.reserve(terms_.size() + other.terms_.size());
  auto mine = terms_.begin();
  auto theirs = other.terms_.begin();
  while (mine != terms_.end() && theirs != other.terms_.end()) {
    if (mine->monomial == theirs->monomial) {
      if (negated)
        mine->coefficient -= theirs->coefficient;
      else
        mine->coefficient += theirs->coefficient;
      if (!mine->coefficient.is_zero()) sum.push_back(std::move(*mine));
      ++mine, ++theirs;
    } else if (precedes(*mine, *theirs)) {
      sum.push_back(std::move(*mine++));
    } else {
      sum.push_back({theirs->monomial, signed_coefficient(*theirs)});
      ++theirs;
    }
  }
  std::move(mine, terms_.end(), std::back_inserter(sum));
  for (; theirs != other.terms_.end(); ++theirs)
    sum.push_back({theirs->monomial, signed_coefficient(*theirs)});
  terms_ = std::move(sum);
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  if (this == &other) return *this *= Rational(2);
  add(other, false);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  if (this == &other)
    terms_.clear();
  else
    add(other, true);
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) { return *this = *this * other; }

Polynomial& Polynomial::operator*=(const Rational& factor) {
  if (factor.is_zero()) {
    terms_.clear();
  } else if (!factor.is_one()) {
    // A copy: it may be one of our own coefficients.
    const Rational kept = factor;  // NOLINT(performance-unnecessary-copy-initialization)
    for (Term& term : terms_) term.coefficient *= kept;
  }
  return *this;
}

Polynomial Polynomial::pow(int exponent) const {
  if (exponent < 0) throw Error("a polynomial has no negative powers, such as " + std::to_string(exponent));
  if (exponent == 0) return 1;
  if (terms_.size() <= 1) {
    Polynomial result = *this;
    for (Term& term : result.terms_) term = {term.monomial.pow(exponent), term.coefficient.pow(exponent)};
    return result;
  }
  Polynomial result = *this;
  int bit = 1;
  while (bit <= exponent / 2) bit *= 2;
  for (bit /= 2; bit > 0; bit /= 2) {
    result = result * result;
    if (exponent & bit) result = result * *this;
  }
  return result;
}

Polynomial Polynomial::coefficient(Letter letter, int power) const {
  // Terms with the same power of the letter keep their order when it is taken away.
  Polynomial result;
  for (const Term& term : terms_)
    if (term.monomial.exponent(letter) == power)
      result.terms_.push_back({term.monomial.without(letter), term.coefficient});
  return result;
}

std::vector<Polynomial> Polynomial::coefficients(Letter letter) const {
  std::vector<Polynomial> result(static_cast<std::size_t>(degree(letter) + 1));
  for (const Term& term : terms_)
    result[static_cast<std::size_t>(term.monomial.exponent(letter))].terms_.push_back(
        {term.monomial.without(letter), term.coefficient});
  return result;
}

Polynomial Polynomial::substitute(Letter letter, const Polynomial& value) const {
  if (!contains(letter)) return *this;
  if (value.is_constant()) return substitute(letter, value.constant());
  if (value.terms_.size() == 1) {
    std::vector<Term> terms;
    terms.reserve(terms_.size());
    const Term& by = value.terms_.front();
    for (const Term& term : terms_) {
      const int power = term.monomial.exponent(letter);
      terms.push_back(
          {term.monomial.without(letter) * by.monomial.pow(power),
           by.coefficient.is_one() ? term.coefficient : term.coefficient * by.coefficient.pow(power)});
    }
    return from_terms(std::move(terms));
  }
  // Horner's rule; runs of missing powers are taken in one stride.
  const std::vector<Polynomial> by_power = coefficients(letter);
  Polynomial result;
  int stride = 0;
  for (std::size_t power = by_power.size(); power-- > 0;) {
    if (by_power[power].is_zero() && power > 0) {
      ++stride;
      continue;
    }
    if (!result.is_zero()) result *= value.pow(stride);
    stride = 1;
    result += by_power[power];
  }
  return result;
}

Polynomial Polynomial::substitute(Letter letter, const Rational& value) const {
  if (!contains(letter)) return *this;
  std::vector<Rational> powers{1};
  const int most = degree(letter);
  for (int k = 1; k <= most; ++k) powers.push_back(powers.back() * value);
  std::vector<Term> terms;
  terms.reserve(terms_.size());
  for (const Term& term : terms_)
    terms.push_back({term.monomial.without(letter),
                     term.coefficient * powers[static_cast<std::size_t>(term.monomial.exponent(letter))]});
  return from_terms(std::move(terms));
}

Rational Polynomial::evaluate(const std::map<Letter, Rational>& values) const {
  // Every power that occurs is made once, from the next lower one that occurs.
  std::array<std::map<int, Rational>, kLetters> powers;
  for (Letter letter = 0; letter < kLetters; ++letter) {
    std::map<int, Rational>& of_letter = powers[static_cast<std::size_t>(letter)];
    for (const Term& term : terms_)
      if (const int power = term.monomial.exponent(letter); power > 0) of_letter[power] = 1;
    if (of_letter.empty()) continue;
    const auto value = values.find(letter);
    if (value == values.end())
      throw Error("the letter number " + std::to_string(letter) + " of the polynomial has no value");
    std::pair<int, Rational> below{0, 1};
    for (auto& [power, result] : of_letter) {
      result = below.second * value->second.pow(power - below.first);
      below = {power, result};
    }
  }
  Rational sum;
  for (const Term& term : terms_) {
    Rational product = term.coefficient;
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (const int power = term.monomial.exponent(letter); power > 0)
        product *= powers[static_cast<std::size_t>(letter)].at(power);
    sum += product;
  }
  return sum;
}

Polynomial Polynomial::derivative(Letter letter) const {
  Polynomial result;
  for (const Term& term : terms_) {
    const int power = term.monomial.exponent(letter);
    if (power > 0) result.terms_.push_back({term.monomial.with(letter, power - 1), term.coefficient * power});
  }
  return result;
}

std::string Polynomial::str(std::span<const std::string> names) const {
  if (terms_.empty()) return "0";
  std::string text;
  for (const Term& term : terms_) {
    const bool negative = term.coefficient.sign() < 0;
    if (text.empty())
      text = negative ? "-" : "";
    else
      text += negative ? " - " : " + ";
    const Rational size = term.coefficient.abs();
    std::string product;
    for (Letter letter = 0; letter < kLetters; ++letter) {
      const int power = term.monomial.exponent(letter);
      if (power == 0) continue;
      if (static_cast<std::size_t>(letter) >= names.size())
        throw Error("the letter number " + std::to_string(letter) + " of the polynomial has no name");
      if (!product.empty()) product += "*";
      product += names[static_cast<std::size_t>(letter)];
      if (power > 1) product += "^" + std::to_string(power);
    }
    if (product.empty())
      product = size.str();
    else if (!size.is_one())
      product = size.str() + "*" + product;
    text += product;
  }
  return text;
}

}  // namespace shortfall
