// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness/flint_sums.hpp"

#include <gmp.h>

#include <flint/arith.h>
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>

#include "bench/harness/interleaved.hpp"

namespace shortfall::bench {
namespace {

struct Polynomial {
  Polynomial() { fmpq_poly_init(p); }
  Polynomial(const Polynomial&) = delete;
  Polynomial& operator=(const Polynomial&) = delete;
  ~Polynomial() { fmpq_poly_clear(p); }
  fmpq_poly_t p;
};

/// (B_{m+1}(n) - B_{m+1}) / (m + 1).
void by_bernoulli(Polynomial& sum, int m) {
  arith_bernoulli_polynomial(sum.p, static_cast<unsigned long>(m) + 1);
  fmpq_poly_set_coeff_si(sum.p, 0, 0);
  fmpq_poly_scalar_div_si(sum.p, sum.p, m + 1);
}

/// S_m from S_{m-1}: m times its integral, and the multiple of n that makes it 0 at n = 1.
void by_recurrence(Polynomial& sum, int m, fmpq_t at_one, fmpz_t one, fmpq_t coefficient) {
  fmpq_poly_scalar_mul_si(sum.p, sum.p, m);
  fmpq_poly_integral(sum.p, sum.p);
  fmpq_poly_evaluate_fmpz(at_one, sum.p, one);
  fmpq_poly_get_coeff_fmpq(coefficient, sum.p, 1);
  fmpq_sub(coefficient, coefficient, at_one);
  fmpq_poly_set_coeff_fmpq(sum.p, 1, coefficient);
}

std::string text_of(const Polynomial& polynomial) {
  std::string text;
  fmpq_t c;
  fmpq_init(c);
  for (long i = 0; i < fmpq_poly_length(polynomial.p); ++i) {
    fmpq_poly_get_coeff_fmpq(c, polynomial.p, i);
    char* const digits = fmpq_get_str(nullptr, 10, c);
    text += (text.empty() ? "" : " ") + std::string(digits);
    flint_free(digits);
  }
  fmpq_clear(c);
  return text;
}

template <class Do>
void each_sum(int highest, bool own, Do&& done) {
  Polynomial sum;
  fmpq_t at_one, coefficient;
  fmpz_t one;
  fmpq_init(at_one);
  fmpq_init(coefficient);
  fmpz_init_set_ui(one, 1);
  fmpq_poly_set_coeff_si(sum.p, 1, 1);
  for (int m = 1; m <= highest; ++m) {
    if (own)
      by_bernoulli(sum, m);
    else
      by_recurrence(sum, m, at_one, one, coefficient);
    done(sum);
  }
  fmpq_clear(at_one);
  fmpq_clear(coefficient);
  fmpz_clear(one);
}

}  // namespace

std::vector<std::string> flint_sums(int highest, bool own) {
  std::vector<std::string> lines;
  each_sum(highest, own, [&](const Polynomial& sum) { lines.push_back(text_of(sum)); });
  return lines;
}

void make_flint_sums(int highest, bool own) {
  each_sum(highest, own, [](const Polynomial& sum) { keep(sum); });
}

std::string flint_name() { return std::string("FLINT ") + FLINT_VERSION; }

}  // namespace shortfall::bench
