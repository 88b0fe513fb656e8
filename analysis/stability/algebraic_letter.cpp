// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/algebraic_letter.hpp"

#include <algorithm>

#include "analysis/algebra/sturm.hpp"
#include "analysis/stability/resultant.hpp"

namespace shortfall {

namespace {

// Letters of polynomials that live only inside one function.
constexpr Letter kUnknown = 0;
constexpr Letter kGenerator = 1;

/// r's interval and s's, so narrow that r + k s is told from every other root of `sum`.
RealRoot chosen_sum(const Univariate<Rational>& sum, RealRoot r, RealRoot s, int k) {
  std::vector<RealRoot> candidates = real_roots(sum);
  while (candidates.size() > 1) {
    r = r.refined((r.high() - r.low()) / 256);
    s = s.refined((s.high() - s.low()) / 256);
    const Rational low = r.low() + s.low() * k, high = r.high() + s.high() * k;
    for (RealRoot& c : candidates) c = c.refined((high - low) / 2);
    std::erase_if(candidates, [&](const RealRoot& c) { return c.high() < low || c.low() > high; });
  }
  return candidates.front();
}

Univariate<Algebraic> lifted(const Univariate<Rational>& p) {
  return std::vector<Algebraic>(p.coefficients().begin(), p.coefficients().end());
}

/// m(w - k x), a polynomial in x over the field of w.
Univariate<Algebraic> shifted(const Univariate<Rational>& m, const Algebraic& w, int k) {
  Univariate<Algebraic> result;
  for (int j = m.degree(); j >= 0; --j)
    result = result * Univariate<Algebraic>({w, Algebraic(-k)}) + Univariate<Algebraic>({Algebraic(m[j])});
  return result;
}

/// A number that generates Q(r, s), and both as numbers of its field.
CommonField joined(const RealRoot& r, const RealRoot& s) {
  const auto in = [](const RealRoot& a, Letter letter) {
    return Polynomial::in(letter, a.polynomial().coefficients());
  };
  for (int k = 1;; ++k) {
    // r + k s = w: s is x, and r is w - k x.
    const Polynomial shifted_r = in(r, kUnknown)
                                     .substitute(kUnknown, Polynomial::letter(kGenerator) -
                                                               Polynomial::letter(kUnknown) * Polynomial(k));
    const Univariate<Rational> sums = univariate(resultant(in(s, kUnknown), shifted_r, kUnknown), kGenerator);
    if (gcd(sums, sums.derivative()).degree() > 0) continue;
    const auto generator = std::make_shared<const RealRoot>(chosen_sum(sums, r, s, k));
    const Algebraic w(Univariate<Rational>({0, 1}), generator);
    const Univariate<Algebraic> common = gcd(lifted(s.polynomial()), shifted(r.polynomial(), w, k));
    if (common.degree() != 1) continue;
    const Algebraic s_in_field = -common[0];
    return {generator, {w - s_in_field * Algebraic(k), s_in_field}};
  }
}

}  // namespace

Fraction reduced(const Fraction& f, const std::vector<AlgebraicLetter>& letters) {
  std::vector<NumberField::Generator> generators;
  for (const AlgebraicLetter& a : letters)
    generators.push_back({a.letter, a.value.polynomial().monic().coefficients()});
  const NumberField field(std::move(generators));
  return Fraction(f.numerator(), f.denominator());
}

SquareMatrix<Fraction> reduced(SquareMatrix<Fraction> matrix, const std::vector<AlgebraicLetter>& letters) {
  for (auto& row : matrix)
    for (Fraction& f : row) f = reduced(f, letters);
  return matrix;
}

CommonField common_field(const std::vector<AlgebraicLetter>& letters) {
  // Narrow enough for most signs to be seen at once.
  const auto narrow = [](const RealRoot& r) {
    return std::make_shared<const RealRoot>(r.refined(Rational(1) / Rational(2).pow(80)));
  };
  CommonField field;
  for (const AlgebraicLetter& a : letters) {
    if (!field.generator) {
      field.generator = narrow(a.value);
      field.values = {Algebraic(Univariate<Rational>({0, 1}), field.generator)};
      continue;
    }
    const CommonField larger = joined(*field.generator, a.value);
    const auto generator = narrow(*larger.generator);
    const auto moved = [&](const Algebraic& value, const Algebraic& at) {
      Algebraic result;
      const Univariate<Rational>& p = value.polynomial();
      for (int k = p.degree(); k >= 0; --k) result = result * at + Algebraic(p[k]);
      return result;
    };
    const Algebraic old(larger.values[0].polynomial(), generator);
    for (Algebraic& value : field.values) value = moved(value, old);
    field.values.emplace_back(larger.values[1].polynomial(), generator);
    field.generator = generator;
  }
  return field;
}

Univariate<Algebraic> over_field(const Polynomial& p, Letter letter,
                                 const std::vector<AlgebraicLetter>& letters, const CommonField& field) {
  std::vector<Algebraic> result;
  for (const Polynomial& c : p.coefficients(letter)) {
    Algebraic sum;
    for (const Polynomial::Term& t : c.terms()) {
      Algebraic value = t.coefficient;
      Monomial rest = t.monomial;
      for (std::size_t i = 0; i < letters.size(); ++i) {
        for (int k = rest.exponent(letters[i].letter); k > 0; --k) value *= field.values[i];
        rest = rest.without(letters[i].letter);
      }
      if (!rest.is_one()) throw Error("a polynomial in one letter and algebraic ones was expected");
      sum += value;
    }
    result.push_back(std::move(sum));
  }
  return result;
}

Univariate<Rational> norm(const Univariate<Algebraic>& p, const Algebraic::Generator& generator) {
  Polynomial in_letters;
  for (int k = 0; k <= p.degree(); ++k)
    in_letters +=
        Polynomial::in(kGenerator, p[k].polynomial().coefficients()) * Polynomial::letter(kUnknown, k);
  if (!generator) return univariate(in_letters, kUnknown);
  const Polynomial m = Polynomial::in(kGenerator, generator->polynomial().coefficients());
  return univariate(resultant(m, in_letters, kGenerator), kUnknown);
}

std::vector<RootOver> positive_roots(const std::vector<Univariate<Algebraic>>& polynomials,
                                     const Algebraic::Generator& generator) {
  std::vector<Univariate<Algebraic>> monic;
  std::vector<Univariate<Rational>> norms;
  for (const Univariate<Algebraic>& p : polynomials) {
    if (p.degree() < 1) continue;
    monic.push_back(p.monic());
    norms.push_back(norm(monic.back(), generator));
  }
  std::vector<RootOver> result;
  for (const RealRoot& root : positive_roots(norms)) {
    for (std::size_t i = 0; i < monic.size(); ++i) {
      const Univariate<Algebraic>& p = monic[i];
      const auto [rest, remainder] = divided(norms[i], root.polynomial());
      if (!remainder.is_zero()) continue;
      if (root.is_rational()) {
        if (!p.at(Algebraic(root.low())).is_zero()) continue;
      } else if (p.at(Algebraic(root.low())).sign() == p.at(Algebraic(root.high())).sign()) {
        // Nothing else can be a root there: of p an even number of times, or of conjugates only. A simple
        // root of the norm is a simple root of one conjugate.
        if (!divided(rest, root.polynomial()).second.is_zero()) continue;
        const Univariate<Algebraic> part = gcd(p, lifted(root.polynomial()));
        if (part.degree() < 1 || Sturm<Algebraic>(part).roots_between(root.low(), root.high()) == 0) continue;
      }
      result.push_back({root, p});
      break;
    }
  }
  return result;
}

}  // namespace shortfall
