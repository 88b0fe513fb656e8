// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_step.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_plan.hpp"

namespace shortfall {

namespace {

using RationalRows = std::vector<std::vector<mpq_class>>;

std::vector<mpq_class> rationals(const std::vector<Fraction>& row, const std::vector<int>& kept) {
  std::vector<mpq_class> result;
  for (const int j : kept) result.push_back(gmp(row[j].constant()));
  return result;
}

/// The entries of the state that what is reported depends on, now or later.
std::vector<int> read_entries(const StepMatrix& m) {
  std::vector<bool> read(m.step.size());
  std::vector<int> waiting;
  const auto mark = [&](const std::vector<Fraction>& row) {
    for (std::size_t j = 0; j < row.size(); ++j)
      if (!row[j].is_zero() && !read[j]) {
        read[j] = true;
        waiting.push_back(static_cast<int>(j));
      }
  };
  mark(m.position);
  mark(m.velocity);
  while (!waiting.empty()) {
    const int i = waiting.back();
    waiting.pop_back();
    mark(m.step[i]);
  }
  std::vector<int> kept;
  for (std::size_t j = 0; j < read.size(); ++j)
    if (read[j]) kept.push_back(static_cast<int>(j));
  return kept;
}

/// The integer without its factors `factor`, and how many there were.
int remove(mpz_class& value, const mpz_class& factor) {
  return static_cast<int>(mpz_remove(value.get_mpz_t(), value.get_mpz_t(), factor.get_mpz_t()));
}

/// Adds an integer to a set of pairwise coprime ones so that all remain products of their powers.
void refine(std::vector<mpz_class>& base, mpz_class value) {
  std::vector<mpz_class> waiting{std::move(value)};
  while (!waiting.empty()) {
    mpz_class a = std::move(waiting.back());
    waiting.pop_back();
    if (a == 1) continue;
    const auto shared = std::ranges::find_if(base, [&](const mpz_class& b) { return gcd(a, b) != 1; });
    if (shared == base.end()) {
      base.push_back(std::move(a));
      continue;
    }
    const mpz_class b = *shared, g = gcd(a, b);
    if (a == b) continue;
    base.erase(shared);
    waiting.insert(waiting.end(), {a / g, b / g, g});
  }
}

/// Pairwise coprime integers of which every denominator is a product; small primes are found, others need not
/// be.
std::vector<mpz_class> coprime_base(const RationalRows& rows) {
  std::vector<mpz_class> base, seen;
  for (const auto& row : rows)
    for (const mpq_class& entry : row) {
      mpz_class rest = entry.get_den();
      if (rest == 1 || std::ranges::find(seen, rest) != seen.end()) continue;
      seen.push_back(rest);
      for (const unsigned long prime : {2, 3, 5, 7, 11, 13})
        if (mpz_divisible_ui_p(rest.get_mpz_t(), prime)) {
          remove(rest, prime);
          refine(base, prime);
        }
      refine(base, std::move(rest));
    }
  return base;
}

/// How often an entry contains a factor, negative in the denominator; a lower bound where the factor is not
/// prime.
int valuation(const mpq_class& entry, const mpz_class& factor) {
  const auto times = [&](const mpz_class& of) {
    if (!mpz_divisible_p(of.get_mpz_t(), factor.get_mpz_t())) return 0;
    mpz_class rest = of;
    return remove(rest, factor);
  };
  const int below = times(entry.get_den());
  return below > 0 ? -below : times(entry.get_num());
}

mpz_class power(const mpz_class& base, int exponent) {
  mpz_class p;
  mpz_pow_ui(p.get_mpz_t(), base.get_mpz_t(), static_cast<unsigned long>(exponent));
  return p;
}

/// The least exponent e >= 0 for which potentials u with valuation + u_i - u_j + e >= 0 for all entries
/// exist, and such potentials: for each entry of the state those in which the others are as large as they can
/// be beside it, and the least ones.
struct Scaling {
  int exponent = 0;
  std::vector<std::vector<int>> potentials;
};

/// Shortest paths from these first distances; nothing when there is a negative cycle.
std::optional<std::vector<int>> shortest(const RationalRows& rows,
                                         const std::vector<std::vector<int>>& lengths, int more,
                                         std::vector<int> u) {
  bool changed = true;
  for (std::size_t round = 0; changed; ++round) {
    if (round > rows.size()) return std::nullopt;  // a path has no more edges
    changed = false;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows.size(); ++j)
        if (rows[i][j] != 0 && u[i] + lengths[i][j] + more < u[j]) {
          u[j] = u[i] + lengths[i][j] + more;
          changed = true;
        }
  }
  return u;
}

Scaling scaling(const RationalRows& rows, const mpz_class& factor) {
  const std::size_t size = rows.size();
  std::vector<std::vector<int>> lengths(size, std::vector<int>(size));
  int longest = 0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      if (rows[i][j] != 0) {
        lengths[i][j] = valuation(rows[i][j], factor);
        longest = std::max(longest, lengths[i][j]);
      }
  Scaling s;
  for (;; ++s.exponent)
    if (const auto least = shortest(rows, lengths, s.exponent, std::vector<int>(size))) {
      for (std::size_t r = 0; r < size; ++r) {
        std::vector<int> far(size, static_cast<int>(size) * (longest + s.exponent));
        far[r] = 0;
        s.potentials.push_back(*shortest(rows, lengths, s.exponent, std::move(far)));
      }
      s.potentials.push_back(*least);
      return s;
    }
}

/// D s_i a_ij / s_j.
std::vector<std::vector<mpz_class>> scaled(const RationalRows& a, const mpz_class& base,
                                           const std::vector<mpz_class>& scale) {
  std::vector<std::vector<mpz_class>> result(a.size(), std::vector<mpz_class>(a.size()));
  mpz_class below, rest;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (a[i][j] == 0) continue;
      mpz_class& entry = result[i][j];
      entry = base * scale[i];
      entry *= a[i][j].get_num();
      below = a[i][j].get_den() * scale[j];
      mpz_tdiv_qr(entry.get_mpz_t(), rest.get_mpz_t(), entry.get_mpz_t(), below.get_mpz_t());
      if (rest != 0) throw Error("the scaled step is not whole");
    }
  return result;
}

mpz_class common_denominator(const std::vector<mpq_class>& values) {
  mpz_class common = 1;
  for (const mpq_class& v : values) common = lcm(common, v.get_den());
  return common;
}

ExactStep::Report report(const std::vector<mpq_class>& row, const std::vector<mpz_class>& scale) {
  std::vector<mpq_class> weights;
  for (std::size_t j = 0; j < row.size(); ++j) weights.emplace_back(row[j] / scale[j]);
  ExactStep::Report r;
  r.denominator = common_denominator(weights);
  for (const mpq_class& w : weights) {
    r.row.emplace_back(w.get_num() * (r.denominator / w.get_den()));
  }
  int reads = 0;
  for (std::size_t j = 0; j < row.size(); ++j)
    if (r.row[j] != 0) {
      ++reads;
      r.unit = static_cast<int>(j);
    }
  if (reads != 1 || r.row[r.unit] != 1) r.unit = -1;
  return r;
}

}  // namespace

ExactStep exact_step(const StepMatrix& m) {
  const std::vector<int> kept = read_entries(m);
  RationalRows a;
  for (const int i : kept) a.push_back(rationals(m.step[i], kept));
  const std::size_t size = a.size();

  // Of the scalings with the least denominator the one whose step is the least work.
  ExactStep step;
  std::vector<std::vector<mpz_class>> scales(size + 1, std::vector<mpz_class>(size, 1));
  for (const mpz_class& factor : coprime_base(a)) {
    const Scaling s = scaling(a, factor);
    step.base *= power(factor, s.exponent);
    for (std::size_t r = 0; r < scales.size(); ++r) {
      const int lowest = *std::ranges::min_element(s.potentials[r]);
      for (std::size_t i = 0; i < size; ++i) scales[r][i] *= power(factor, s.potentials[r][i] - lowest);
    }
  }
  std::vector<mpz_class> scale;
  double least = std::numeric_limits<double>::infinity();
  for (std::vector<mpz_class>& candidate : scales) {
    auto matrix = scaled(a, step.base, candidate);
    if (const double cost = ExactPlan::cost(matrix); cost < least) {
      least = cost;
      step.matrix = std::move(matrix);
      scale = std::move(candidate);
    }
  }

  std::vector<mpq_class> start = rationals(m.start, kept);
  for (std::size_t i = 0; i < size; ++i) start[i] *= scale[i];
  step.start_denominator = common_denominator(start);
  for (const mpq_class& s : start)
    step.start.emplace_back(s.get_num() * (step.start_denominator / s.get_den()));
  step.position = report(rationals(m.position, kept), scale);
  step.velocity = report(rationals(m.velocity, kept), scale);
  return step;
}

std::vector<mpz_class> product(const std::vector<std::vector<mpz_class>>& matrix,
                               const std::vector<mpz_class>& vector) {
  std::vector<mpz_class> result(matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < vector.size(); ++j)
      if (matrix[i][j] != 0) result[i] += matrix[i][j] * vector[j];
  return result;
}

std::vector<std::vector<mpz_class>> product(const std::vector<std::vector<mpz_class>>& a,
                                            const std::vector<std::vector<mpz_class>>& b) {
  std::vector<std::vector<mpz_class>> result(a.size(), std::vector<mpz_class>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a.size(); ++k)
      if (a[i][k] != 0)
        for (std::size_t j = 0; j < a.size(); ++j) result[i][j] += a[i][k] * b[k][j];
  return result;
}

}  // namespace shortfall
