// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_plan.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/algebra/wide.hpp"

namespace shortfall {

namespace {

using Term = ExactPlan::Term;
using Row = ExactPlan::Row;
using TermKind = Term::Kind;

constexpr int kQuick = 8;      // entries for which no memory is allocated
constexpr int kAllOrders = 4;  // rows of which every order is tried

Term term(int source, bool fresh, const mpz_class& coefficient) {
  Term t;
  t.source = source;
  t.fresh = fresh;
  t.magnitude = abs(coefficient);
  t.negative = coefficient < 0;
  if (t.magnitude == 1) {
    t.kind = TermKind::unit;
  } else if (mpz_popcount(t.magnitude.get_mpz_t()) == 1) {
    t.kind = TermKind::shift;
    t.word = mpz_sizeinbase(t.magnitude.get_mpz_t(), 2) - 1;
  } else if (mpz_fits_ulong_p(t.magnitude.get_mpz_t())) {
    t.kind = TermKind::word;
    t.word = t.magnitude.get_ui();
  } else {
    t.kind = TermKind::integer;
  }
  return t;
}

/// What a coefficient costs, in passes of mpz_mul_ui as measured: where a row begins, and added to it.
struct Cost {
  double first = 0;
  double later = 0;
};
constexpr Cost kUnit{0.3, 0.6}, kShift{0.6, 1.1}, kWord{1, 1.1};

Cost price(const Term& t) {
  if (t.kind == TermKind::unit) return kUnit;
  if (t.kind == TermKind::word) return kWord;
  const double words = 1.3 * static_cast<double>(mpz_size(t.magnitude.get_mpz_t()));
  return t.kind == TermKind::integer ? Cost{words, words} : Cost{kShift.first, std::max(kShift.later, words)};
}

Cost price(Int128 coefficient) {
  const UInt128 size = magnitude(coefficient);
  return size == 1 ? kUnit : (size & (size - 1)) == 0 ? kShift : kWord;
}

/// A row whose coefficients have these costs: what gains most by it begins. Two units are one addition.
class RowCost {
 public:
  void add(Cost c) {
    sum_ += c.later;
    if (c.first == kUnit.first) ++units_;
    ++terms_;
    gain_ = std::max(gain_, c.later - c.first);
  }
  double total() const { return sum_ - gain_ - (terms_ > 1 && units_ == terms_ ? kUnit.first : 0); }

 private:
  double sum_ = 0, gain_ = 0;
  int units_ = 0, terms_ = 0;
};

/// Row i minus `sign` times row `minus` (none for -1) is what is left to do for it.
struct Choice {
  int row = 0;
  int minus = -1;
  int sign = 0;
};

/// The cheapest order of rows, and for each whether it uses one that has been made.
std::vector<Choice> choices(const std::vector<std::int64_t>& m, int size, double& least) {
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::vector<Choice> best;
  do {
    std::vector<Choice> chosen;
    double total = 0;
    for (int k = 0; k < size; ++k) {
      const int i = order[k];
      const auto row_cost = [&](int minus, int sign) {
        RowCost c;
        for (int j = 0; j < size; ++j) {
          const Int128 rest = m[i * size + j] - (minus < 0 ? Int128{0} : Int128{sign} * m[minus * size + j]);
          // A difference of two words may be no word; it is never the cheaper one.
          if (!fits_64(rest))
            c.add({2.6, 2.6});
          else if (rest != 0)
            c.add(price(rest));
        }
        if (minus >= 0) c.add(kUnit);
        return c.total();
      };
      Choice choice{i};
      double cheapest = row_cost(-1, 0);
      for (int e = 0; e < k; ++e)
        for (const int sign : {1, -1})
          if (const double c = row_cost(order[e], sign); c < cheapest) {
            cheapest = c;
            choice = {i, order[e], sign};
          }
      total += cheapest;
      chosen.push_back(choice);
    }
    if (total < least) {
      least = total;
      best = std::move(chosen);
    }
  } while (size <= kAllOrders && std::ranges::next_permutation(order).found);
  return best;
}

/// The same for any matrix; only words are worth a search.
std::vector<Choice> choices(const std::vector<std::vector<mpz_class>>& matrix, double& least) {
  std::vector<std::int64_t> words;
  for (const auto& row : matrix)
    for (const mpz_class& m : row)
      if (mpz_fits_slong_p(m.get_mpz_t())) words.push_back(m.get_si());
  const int size = static_cast<int>(matrix.size());
  least = std::numeric_limits<double>::infinity();
  if (words.size() == matrix.size() * matrix.size()) return choices(words, size, least);
  std::vector<Choice> in_order;
  least = 0;
  for (int i = 0; i < size; ++i) {
    in_order.push_back({i});
    for (const mpz_class& m : matrix[i])
      if (m != 0) least += price(term(0, false, m)).later;
  }
  return in_order;
}

/// What is dear in the first place goes there, positive if it can be: the others are added to it.
void arrange(std::vector<Term>& terms) {
  std::ranges::stable_sort(terms, [](const Term& a, const Term& b) {
    const auto gain = [](const Term& t) { return price(t).later - price(t).first; };
    if (gain(a) != gain(b)) return gain(a) > gain(b);
    return !a.negative && b.negative;
  });
}

}  // namespace

bool ExactPlan::in_place(const std::vector<Row>& rows) {
  std::vector<bool> changed(rows.size());
  for (const Row& row : rows) {
    for (const Term& t : row.terms)
      if (!t.fresh && changed[t.source]) return false;
    changed[row.target] = true;
  }
  return true;
}

std::vector<ExactPlan::Row> ExactPlan::rows(const std::vector<std::vector<mpz_class>>& matrix) {
  double cost = 0;
  std::vector<Row> rows;
  for (const Choice& c : choices(matrix, cost)) {
    Row row{c.row, {}};
    for (int j = 0; j < static_cast<int>(matrix.size()); ++j) {
      mpz_class rest = matrix[c.row][j];
      if (c.minus >= 0) rest -= c.sign * matrix[c.minus][j];
      if (rest != 0) row.terms.push_back(term(j, false, rest));
    }
    if (c.minus >= 0) row.terms.push_back(term(c.minus, true, c.sign));
    arrange(row.terms);
    rows.push_back(std::move(row));
  }
  return rows;
}

ExactPlan::ExactPlan(const std::vector<std::vector<mpz_class>>& matrix)
    : size_(static_cast<int>(matrix.size())) {
  std::vector<Row> all = rows(matrix);
  in_place_ = in_place(all);
  for (Row& row : all) {
    if (in_place_) {
      const auto own =
          std::ranges::find_if(row.terms, [&](const Term& t) { return !t.fresh && t.source == row.target; });
      if (own != row.terms.end()) std::rotate(row.terms.begin(), own, own + 1);
    }
    translate(row);
  }
}

void ExactPlan::translate(const Row& row) {
  const int next = in_place_ ? 0 : size_;  // where new entries are
  const int out = next + row.target;
  const auto source = [&](const Term& t) { return t.source + (t.fresh ? next : 0); };
  const auto& terms = row.terms;
  if (terms.empty()) {
    operations_.push_back({Operation::Kind::zero, out});
    return;
  }
  std::size_t done = 1;
  const Term& first = terms[0];
  if (terms.size() > 1 && first.kind == TermKind::unit && terms[1].kind == TermKind::unit) {
    const int a = source(first), b = source(terms[1]);
    if (first.negative == terms[1].negative)
      operations_.push_back({Operation::Kind::add, out, a, b});
    else
      operations_.push_back(first.negative ? Operation{Operation::Kind::subtract, out, b, a}
                                           : Operation{Operation::Kind::subtract, out, a, b});
    if (first.negative && terms[1].negative) operations_.push_back({Operation::Kind::negate, out, out});
    done = 2;
  } else {
    switch (first.kind) {
      case TermKind::unit:
        if (source(first) != out) operations_.push_back({Operation::Kind::copy, out, source(first)});
        break;
      case TermKind::shift:
        operations_.push_back({Operation::Kind::shift, out, source(first), 0, first.word});
        break;
      case TermKind::word:
        operations_.push_back({Operation::Kind::multiply, out, source(first), 0, first.word});
        break;
      case TermKind::integer:
        operations_.push_back({Operation::Kind::multiply_long, out, source(first), 0, longs_.size()});
        longs_.push_back(first.magnitude);
        break;
    }
    if (first.negative) operations_.push_back({Operation::Kind::negate, out, out});
  }
  for (; done < terms.size(); ++done) {
    const Term& t = terms[done];
    using Do = Operation::Kind;
    if (t.kind == TermKind::unit) {
      operations_.push_back({t.negative ? Do::subtract : Do::add, out, out, source(t)});
    } else if (mpz_fits_ulong_p(t.magnitude.get_mpz_t())) {
      operations_.push_back({t.negative ? Do::subtract_product : Do::add_product, out, source(t), 0,
                             mpz_get_ui(t.magnitude.get_mpz_t())});
    } else {
      operations_.push_back(
          {t.negative ? Do::subtract_long : Do::add_long, out, source(t), 0, longs_.size()});
      longs_.push_back(t.magnitude);
    }
  }
}

double ExactPlan::cost(const std::vector<std::vector<mpz_class>>& matrix) {
  double least = 0;
  choices(matrix, least);
  return least;
}

void ExactPlan::apply(std::vector<mpz_class>& z, std::vector<mpz_class>& room) const {
  std::array<mpz_ptr, 2 * kQuick> few;
  std::vector<mpz_ptr> many(size_ > kQuick ? 2 * size_ : 0);
  mpz_ptr* const entries = size_ > kQuick ? many.data() : few.data();
  for (int i = 0; i < size_; ++i) {
    entries[i] = z[i].get_mpz_t();
    entries[size_ + i] = room[i].get_mpz_t();
  }
  for (const Operation& o : operations_) {
    const mpz_ptr r = entries[o.out];
    const mpz_srcptr a = entries[o.a];
    switch (o.kind) {
      case Operation::Kind::zero:
        mpz_set_ui(r, 0);
        break;
      case Operation::Kind::copy:
        mpz_set(r, a);
        break;
      case Operation::Kind::negate:
        mpz_neg(r, a);
        break;
      case Operation::Kind::shift:
        mpz_mul_2exp(r, a, o.word);
        break;
      case Operation::Kind::multiply:
        mpz_mul_ui(r, a, o.word);
        break;
      case Operation::Kind::add:
        mpz_add(r, a, entries[o.b]);
        break;
      case Operation::Kind::subtract:
        mpz_sub(r, a, entries[o.b]);
        break;
      case Operation::Kind::add_product:
        mpz_addmul_ui(r, a, o.word);
        break;
      case Operation::Kind::subtract_product:
        mpz_submul_ui(r, a, o.word);
        break;
      case Operation::Kind::multiply_long:
        mpz_mul(r, a, longs_[o.word].get_mpz_t());
        break;
      case Operation::Kind::add_long:
        mpz_addmul(r, a, longs_[o.word].get_mpz_t());
        break;
      case Operation::Kind::subtract_long:
        mpz_submul(r, a, longs_[o.word].get_mpz_t());
        break;
    }
  }
  if (!in_place_) z.swap(room);
}

}  // namespace shortfall
