// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_plan.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace shortfall {

namespace {

using Term = ExactPlan::Term;
using Kind = Term::Kind;

constexpr std::size_t kAllOrders = 4;  // rows of which every order is tried

Term term(int source, bool fresh, const mpz_class& coefficient) {
  Term t;
  t.source = source;
  t.fresh = fresh;
  t.coefficient = coefficient;
  t.magnitude = abs(coefficient);
  t.negative = coefficient < 0;
  if (t.magnitude == 1) {
    t.kind = Kind::unit;
  } else if (mpz_popcount(t.magnitude.get_mpz_t()) == 1) {
    t.kind = Kind::shift;
    t.word = mpz_sizeinbase(t.magnitude.get_mpz_t(), 2) - 1;
  } else if (mpz_fits_ulong_p(t.magnitude.get_mpz_t())) {
    t.kind = Kind::word;
    t.word = t.magnitude.get_ui();
  } else {
    t.kind = Kind::integer;
  }
  return t;
}

/// Measured passes, relative to mpz_mul_ui.
double cost(const Term& t, bool first) {
  switch (t.kind) {
    case Kind::unit:
      return first ? 0.3 : 0.6;
    case Kind::shift:
      return first ? 0.6 : mpz_fits_ulong_p(t.magnitude.get_mpz_t()) ? 1.1 : 2;
    case Kind::word:
      return first ? 1 : 1.1;
    case Kind::integer:
      return 1.3 * static_cast<double>(mpz_size(t.magnitude.get_mpz_t()));
  }
  return 0;
}

/// What is dear in the first place goes there: the others are added to it.
double arrange(std::vector<Term>& terms) {
  std::ranges::stable_sort(terms, [](const Term& a, const Term& b) {
    const auto gain = [](const Term& t) { return cost(t, false) - cost(t, true); };
    if (gain(a) != gain(b)) return gain(a) > gain(b);
    return !a.negative && b.negative;
  });
  double total = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) total += cost(terms[i], i == 0);
  // Two units are one addition.
  if (terms.size() > 1 && terms[0].kind == Kind::unit && terms[1].kind == Kind::unit) total -= 0.3;
  return total;
}

std::vector<Term> terms_of(const std::vector<mpz_class>& row) {
  std::vector<Term> terms;
  for (std::size_t j = 0; j < row.size(); ++j)
    if (row[j] != 0) terms.push_back(term(static_cast<int>(j), false, row[j]));
  return terms;
}

void begin(mpz_ptr r, const Term& t, mpz_srcptr source) {
  switch (t.kind) {
    case Kind::unit:
      mpz_set(r, source);
      break;
    case Kind::shift:
      mpz_mul_2exp(r, source, t.word);
      break;
    case Kind::word:
      mpz_mul_ui(r, source, t.word);
      break;
    case Kind::integer:
      mpz_mul(r, source, t.magnitude.get_mpz_t());
      break;
  }
  if (t.negative) mpz_neg(r, r);
}

void accumulate(mpz_ptr r, const Term& t, mpz_srcptr source) {
  if (t.kind == Kind::unit) {
    t.negative ? mpz_sub(r, r, source) : mpz_add(r, r, source);
  } else if (mpz_fits_ulong_p(t.magnitude.get_mpz_t())) {
    const unsigned long word = mpz_get_ui(t.magnitude.get_mpz_t());
    t.negative ? mpz_submul_ui(r, source, word) : mpz_addmul_ui(r, source, word);
  } else {
    t.negative ? mpz_submul(r, source, t.magnitude.get_mpz_t())
               : mpz_addmul(r, source, t.magnitude.get_mpz_t());
  }
}

}  // namespace

ExactPlan::ExactPlan(const std::vector<std::vector<mpz_class>>& matrix) {
  std::vector<int> order(matrix.size());
  std::iota(order.begin(), order.end(), 0);
  cost_ = std::numeric_limits<double>::infinity();
  do {
    std::vector<Row> rows;
    double total = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::vector<mpz_class>& row = matrix[order[k]];
      Row best{order[k], terms_of(row)};
      double least = arrange(best.terms);
      for (std::size_t e = 0; e < k; ++e)
        for (const int sign : {1, -1}) {
          std::vector<mpz_class> rest = row;
          for (std::size_t j = 0; j < rest.size(); ++j) rest[j] -= sign * matrix[order[e]][j];
          std::vector<Term> terms = terms_of(rest);
          terms.push_back(term(order[e], true, sign));
          if (const double c = arrange(terms); c < least) {
            least = c;
            best.terms = std::move(terms);
          }
        }
      total += least;
      rows.push_back(std::move(best));
    }
    if (total < cost_) {
      cost_ = total;
      rows_ = std::move(rows);
    }
  } while (order.size() <= kAllOrders && std::ranges::next_permutation(order).found);
}

void ExactPlan::apply(const std::vector<mpz_class>& z, std::vector<mpz_class>& next) const {
  for (const Row& row : rows_) {
    const mpz_ptr r = next[row.target].get_mpz_t();
    const auto source = [&](const Term& t) { return (t.fresh ? next : z)[t.source].get_mpz_t(); };
    const auto& terms = row.terms;
    if (terms.empty()) {
      mpz_set_ui(r, 0);
      continue;
    }
    std::size_t done = 1;
    if (terms.size() > 1 && terms[0].kind == Kind::unit && terms[1].kind == Kind::unit) {
      // The first is positive unless both are negative.
      if (terms[0].negative == terms[1].negative)
        mpz_add(r, source(terms[0]), source(terms[1]));
      else
        mpz_sub(r, source(terms[0]), source(terms[1]));
      if (terms[0].negative) mpz_neg(r, r);
      done = 2;
    } else {
      begin(r, terms[0], source(terms[0]));
    }
    for (; done < terms.size(); ++done) accumulate(r, terms[done], source(terms[done]));
  }
}

}  // namespace shortfall
