// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/flint.hpp"
#include "analysis/algebra/flint_integer.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/polynomial.hpp"

namespace shortfall {
namespace {

using Term = Polynomial::Term;

/// Integer polynomials of FLINT in the letters that occur.
class Ring {
 public:
  explicit Ring(std::vector<Letter> letters) : letters_(std::move(letters)) {
    fmpz_mpoly_ctx_init(context_, static_cast<FlintSize>(letters_.size()), ORD_DEGLEX);
  }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;
  ~Ring() { fmpz_mpoly_ctx_clear(context_); }

  const fmpz_mpoly_ctx_struct* context() const { return context_; }
  const std::vector<Letter>& letters() const { return letters_; }

 private:
  std::vector<Letter> letters_;
  fmpz_mpoly_ctx_t context_;
};

class FlintPolynomial {
 public:
  explicit FlintPolynomial(const Ring& ring) : ring_(ring) { fmpz_mpoly_init(value_, ring.context()); }

  /// p = content * this, with coprime integer coefficients here.
  FlintPolynomial(const Ring& ring, const Polynomial& p, Rational& content) : FlintPolynomial(ring) {
    FlintInteger above, below, coefficient, cofactor;
    fmpz_one(below.value);
    for (const Term& term : p.terms()) {
      const GmpView q(term.coefficient);
      fmpz_set_mpz(coefficient.value, q.numerator());
      fmpz_gcd(above.value, above.value, coefficient.value);
      fmpz_set_mpz(coefficient.value, q.denominator());
      fmpz_lcm(below.value, below.value, coefficient.value);
    }
    content = rational(above.gmp(), below.gmp());
    std::vector<FlintWord> exponents(ring.letters().size());
    for (const Term& term : p.terms()) {
      for (std::size_t i = 0; i < exponents.size(); ++i)
        exponents[i] = static_cast<FlintWord>(term.monomial.exponent(ring.letters()[i]));
      // (p/q) / (above/below), an integer factor by factor.
      const GmpView q(term.coefficient);
      fmpz_set_mpz(coefficient.value, q.numerator());
      fmpz_divexact(coefficient.value, coefficient.value, above.value);
      fmpz_set_mpz(cofactor.value, q.denominator());
      fmpz_divexact(cofactor.value, below.value, cofactor.value);
      fmpz_mul(coefficient.value, coefficient.value, cofactor.value);
      fmpz_mpoly_push_term_fmpz_ui(value_, coefficient.value, exponents.data(), ring.context());
    }
  }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
  ~FlintPolynomial() { fmpz_mpoly_clear(value_, ring_.context()); }

  fmpz_mpoly_struct* value() { return value_; }
  const fmpz_mpoly_struct* value() const { return value_; }

  Polynomial polynomial() const {
    std::vector<Term> terms;
    std::vector<FlintWord> exponents(std::max<std::size_t>(ring_.letters().size(), 1));
    FlintInteger coefficient;
    const FlintSize length = fmpz_mpoly_length(value_, ring_.context());
    for (FlintSize k = 0; k < length; ++k) {
      fmpz_mpoly_get_term_coeff_fmpz(coefficient.value, value_, k, ring_.context());
      fmpz_mpoly_get_term_exp_ui(exponents.data(), value_, k, ring_.context());
      Monomial monomial;
      for (std::size_t i = 0; i < ring_.letters().size(); ++i)
        monomial = monomial.with(ring_.letters()[i], static_cast<int>(exponents[i]));
      terms.push_back({monomial, coefficient.rational()});
    }
    return Polynomial::from_terms(std::move(terms));
  }

 private:
  const Ring& ring_;
  fmpz_mpoly_t value_;
};

std::vector<Letter> letters_of(const Polynomial& a, const Polynomial& b) {
  std::vector<Letter> letters;
  for (Letter letter = 0; letter < kLetters; ++letter)
    if (a.contains(letter) || b.contains(letter)) letters.push_back(letter);
  return letters;
}

Polynomial monic(Polynomial p) {
  if (!p.is_zero() && !p.terms().front().coefficient.is_one()) p *= 1 / p.terms().front().coefficient;
  return p;
}

/// The largest monomial that divides every term.
Monomial common_monomial(const Polynomial& p) {
  Monomial common = p.terms().front().monomial;
  for (const Term& term : p.terms()) {
    if (common.is_one()) break;
    common = Monomial::gcd(common, term.monomial);
  }
  return common;
}

Polynomial single(const Monomial& monomial) { return Polynomial::from_terms({{monomial, 1}}); }

bool share_a_letter(const Polynomial& a, const Polynomial& b) {
  for (Letter letter = 0; letter < kLetters; ++letter)
    if (a.contains(letter) && b.contains(letter)) return true;
  return false;
}

/// p / term, when it divides.
bool divide_by_term(const Term& term, const Polynomial& p, Polynomial* quotient) {
  std::vector<Term> terms;
  terms.reserve(p.terms().size());
  const Rational factor = 1 / term.coefficient;
  for (const Term& t : p.terms()) {
    if (!term.monomial.divides(t.monomial)) return false;
    terms.push_back({t.monomial / term.monomial, t.coefficient * factor});
  }
  *quotient = Polynomial::from_terms(std::move(terms));
  return true;
}

/// A fixed order of factors, whatever the library found first.
bool comes_before(const std::pair<Polynomial, int>& a, const std::pair<Polynomial, int>& b) {
  const auto& x = a.first.terms();
  const auto& y = b.first.terms();
  if (a.first.total_degree() != b.first.total_degree())
    return a.first.total_degree() < b.first.total_degree();
  if (x.size() != y.size()) return x.size() < y.size();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i].monomial == y[i].monomial)) return y[i].monomial < x[i].monomial;
    if (x[i].coefficient != y[i].coefficient) return x[i].coefficient < y[i].coefficient;
  }
  return false;
}

}  // namespace

Polynomial gcd(const Polynomial& a, const Polynomial& b) { return gcd(a, b, nullptr, nullptr); }

Polynomial gcd(const Polynomial& a, const Polynomial& b, Polynomial* a_rest, Polynomial* b_rest) {
  const auto found = [&](Polynomial common) {
    if (a_rest) *a_rest = common.is_constant() ? a : exact_quotient(a, common);
    if (b_rest) *b_rest = common.is_constant() ? b : exact_quotient(b, common);
    return common;
  };
  if (a.is_zero() || b.is_zero()) {
    if (a.is_zero() && b.is_zero()) return found(Polynomial());
    return found(monic(a.is_zero() ? b : a));
  }
  if (a.is_constant() || b.is_constant() || !share_a_letter(a, b)) return found(1);
  if (a.terms().size() == 1 || b.terms().size() == 1)
    return found(single(Monomial::gcd(common_monomial(a), common_monomial(b))));
  if (a == b) return found(monic(a));

  const Ring ring(letters_of(a, b));
  Rational content_a, content_b;
  const FlintPolynomial x(ring, a, content_a);
  const FlintPolynomial y(ring, b, content_b);
  FlintPolynomial result(ring), x_rest(ring), y_rest(ring);
  const bool rests = a_rest || b_rest;
  if (!(rests ? fmpz_mpoly_gcd_cofactors(result.value(), x_rest.value(), y_rest.value(), x.value(), y.value(),
                                         ring.context())
              : fmpz_mpoly_gcd(result.value(), x.value(), y.value(), ring.context())))
    throw Unable("FLINT found no greatest common divisor of two polynomials of " +
                 std::to_string(a.terms().size()) + " and " + std::to_string(b.terms().size()) + " terms");
  Polynomial common = result.polynomial();
  const Rational leading = common.terms().front().coefficient;
  if (common.is_constant()) return found(1);
  const auto rest = [&](const FlintPolynomial& quotient, const Rational& content) {
    Polynomial p = quotient.polynomial();
    p *= content * leading;
    return p;
  };
  if (a_rest) *a_rest = rest(x_rest, content_a);
  if (b_rest) *b_rest = rest(y_rest, content_b);
  return monic(std::move(common));
}

bool divides(const Polynomial& b, const Polynomial& a, Polynomial* quotient) {
  if (b.is_zero()) return false;
  if (a.is_zero()) {
    *quotient = {};
    return true;
  }
  if (b.terms().size() == 1) return divide_by_term(b.terms().front(), a, quotient);
  if (b.total_degree() > a.total_degree()) return false;
  for (Letter letter = 0; letter < kLetters; ++letter)
    if (b.degree(letter) > a.degree(letter)) return false;

  // By Gauss's lemma a primitive polynomial divides over the rationals only if it divides over the integers.
  const Ring ring(letters_of(a, b));
  Rational content_a, content_b;
  const FlintPolynomial x(ring, a, content_a);
  const FlintPolynomial y(ring, b, content_b);
  FlintPolynomial result(ring);
  if (!fmpz_mpoly_divides(result.value(), x.value(), y.value(), ring.context())) return false;
  *quotient = result.polynomial();
  *quotient *= content_a / content_b;
  return true;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw Undefined("division of a polynomial by zero");
  Polynomial quotient;
  if (!divides(b, a, &quotient))
    throw Undefined("one polynomial does not divide the other: their quotient is a fraction");
  return quotient;
}

Factorization factor(const Polynomial& p) {
  if (p.is_constant()) return {p.constant(), {}};
  Factorization result{p.terms().front().coefficient, {}};
  if (p.terms().size() == 1) {
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (p.contains(letter)) result.factors.emplace_back(Polynomial::letter(letter), p.degree(letter));
    return result;
  }
  const Ring ring(letters_of(p, p));
  Rational content;
  const FlintPolynomial x(ring, p, content);
  fmpz_mpoly_factor_t found;
  fmpz_mpoly_factor_init(found, ring.context());
  const bool done = fmpz_mpoly_factor(found, x.value(), ring.context());
  if (done) {
    FlintPolynomial base(ring);
    for (FlintSize i = 0; i < fmpz_mpoly_factor_length(found, ring.context()); ++i) {
      fmpz_mpoly_factor_get_base(base.value(), found, i, ring.context());
      const FlintSize power = fmpz_mpoly_factor_get_exp_si(found, i, ring.context());
      result.factors.emplace_back(monic(base.polynomial()), static_cast<int>(power));
    }
  }
  fmpz_mpoly_factor_clear(found, ring.context());
  if (!done)
    throw Unable("FLINT could not factor a polynomial of " + std::to_string(p.terms().size()) + " terms");
  std::sort(result.factors.begin(), result.factors.end(), comes_before);
  return result;
}

}  // namespace shortfall
