// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/root_count.hpp"

#include "analysis/algebra/arb.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

namespace {

/// The coefficients times the least number that makes all of them whole.
std::vector<mpz_class> whole(const Univariate<Rational>& p) {
  mpz_class common = 1;
  for (const Rational& c : p.coefficients()) {
    const GmpView view(c);
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), view.denominator());
  }
  std::vector<mpz_class> result;
  for (const Rational& c : p.coefficients()) {
    const GmpView view(c);
    mpz_class& scaled = result.emplace_back();
    mpz_divexact(scaled.get_mpz_t(), common.get_mpz_t(), view.denominator());
    mpz_mul(scaled.get_mpz_t(), scaled.get_mpz_t(), view.numerator());
  }
  return result;
}

Rational exact(const arf_struct* value) {
  fmpq_t q;
  fmpq_init(q);
  arf_get_fmpq(q, value);
  mpq_class result;
  fmpq_get_mpq(result.get_mpq_t(), q);
  fmpq_clear(q);
  return rational(std::move(result));
}

std::pair<Rational, Rational> ends(const arb_struct* ball) {
  arf_t low, high;
  arf_init(low);
  arf_init(high);
  arb_get_interval_arf(low, high, ball, ARF_PREC_EXACT);
  std::pair<Rational, Rational> result(exact(low), exact(high));
  arf_clear(low);
  arf_clear(high);
  return result;
}

}  // namespace

struct ExactSign::Coefficients {
  std::vector<mpz_class> whole;
};

ExactSign::ExactSign(const Univariate<Rational>& p)
    : coefficients_(std::make_shared<const Coefficients>(Coefficients{whole(p)})) {}

int ExactSign::operator()(const Rational& x) const {
  const std::vector<mpz_class>& c = coefficients_->whole;
  if (c.empty()) return 0;
  const GmpView at(x);
  mpz_class sum = c.back(), scale = 1, term;
  for (std::size_t k = c.size() - 1; k-- > 0;) {
    mpz_mul(scale.get_mpz_t(), scale.get_mpz_t(), at.denominator());
    mpz_mul(sum.get_mpz_t(), sum.get_mpz_t(), at.numerator());
    mpz_mul(term.get_mpz_t(), c[k].get_mpz_t(), scale.get_mpz_t());
    sum += term;
  }
  return sgn(sum);
}

RootCount::RootCount(const Univariate<Rational>& p) : sign_(p) {
  constexpr FlintSize kBits = 64;
  if (p.is_zero()) throw Error("the roots of the zero polynomial cannot be counted");
  if (p.degree() == 0) return;
  const std::vector<mpz_class> coefficients = whole(p);
  fmpz_poly_t integers;
  fmpz_poly_init(integers);
  fmpz_t coefficient;
  fmpz_init(coefficient);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    fmpz_set_mpz(coefficient, coefficients[k].get_mpz_t());
    fmpz_poly_set_coeff_fmpz(integers, static_cast<FlintSize>(k), coefficient);
  }
  fmpz_clear(coefficient);
  const bool simple = fmpz_poly_is_squarefree(integers);
  const auto degree = static_cast<FlintSize>(p.degree());
  acb_ptr found = _acb_vec_init(degree);
  if (simple) arb_fmpz_poly_complex_roots(found, integers, 0, kBits);
  for (FlintSize k = 0; simple && k < degree && acb_is_real(found + k); ++k)
    enclosures_.push_back(ends(acb_realref(found + k)));
  _acb_vec_clear(found, degree);
  fmpz_poly_clear(integers);
  if (!simple) throw Error("a polynomial with a multiple root: only simple roots are counted");
}

int RootCount::above(const Rational& low) const {
  int count = 0;
  for (const auto& [from, to] : enclosures_) {
    if (low < from) {
      ++count;
    } else if (low < to) {
      // Where the sign at `low` is still that before the root, the root is greater.
      const int before = sign_(from);
      if (before != 0 && sign_(low) == before) ++count;
    }
  }
  return count;
}

int RootCount::roots_between(const Rational& low, const Rational& high) const {
  return above(low) - above(high);
}

}  // namespace shortfall
