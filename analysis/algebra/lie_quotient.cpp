// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/lie_quotient.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/kept_by_degree.hpp"
#include "analysis/algebra/row_echelon.hpp"

namespace shortfall {

namespace {

using Row = std::vector<Rational>;

}  // namespace

const LieQuotient& LieQuotient::of(VectorFields kind, int degree) {
  static KeptByDegree<LieQuotient> kept;
  return kept.at(static_cast<std::size_t>(kind), degree, 1, [&] { return new LieQuotient(kind, degree); });
}

const LieQuotient::Level& LieQuotient::level(int degree) const {
  if (degree < 1 || degree > this->degree())
    throw Error("this quotient has no degree " + std::to_string(degree));
  return levels_[static_cast<std::size_t>(degree)];
}

LieQuotient::LieQuotient(VectorFields kind, int degree) : kind_(kind) {
  const LyndonBasis& lyndon = LyndonBasis::up_to(degree);
  levels_.resize(static_cast<std::size_t>(degree) + 1);
  for (int n = 1; n <= degree; ++n) {
    Level& here = levels_[static_cast<std::size_t>(n)];
    const auto words = lyndon.words(n);
    if (kind == VectorFields::mechanical) {
      // Both letters' numbers are kept by every relation: eliminate among equals only.
      std::map<int, std::vector<Row>> spanning;
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].count_b() <= words[i].count_a() + 1) continue;
        Row row(words.size());
        row[i] = 1;
        spanning[words[i].count_b()].push_back(std::move(row));
      }
      if (n > 1)
        for (const Row& relation : levels_[static_cast<std::size_t>(n) - 1].relations)
          for (const int letter : {0, 1}) {
            Row row = lyndon.with_letter(n, relation, letter);
            const auto first = std::ranges::find_if(row, [](const Rational& r) { return !r.is_zero(); });
            if (first == row.end()) continue;
            const int b = words[static_cast<std::size_t>(first - row.begin())].count_b();
            if (b <= n - b + 1) spanning[b].push_back(std::move(row));  // others are there already
          }
      for (auto& [b, rows] : spanning) {
        RowEchelon reduced = row_echelon(std::move(rows), words.size());
        std::ranges::move(reduced.rows, std::back_inserter(here.relations));
        std::ranges::move(reduced.pivots, std::back_inserter(here.pivots));
      }
    }
    for (int i = 0; i < static_cast<int>(words.size()); ++i)
      if (std::ranges::find(here.pivots, i) == here.pivots.end()) here.basis.push_back(i);
  }
}

std::vector<int> mechanical_dimensions(int degree) {
  if (degree < 1 || degree > 40)
    throw Unable("the dimensions are known from degree 1 to 40, not to degree " + std::to_string(degree));
  const auto size = static_cast<std::size_t>(degree) + 1;
  // Commutative products of i factors: unordered pairs of smaller ones.
  std::vector<std::int64_t> x(size, 0);
  x[1] = 1;
  for (std::size_t i = 2; i < size; ++i) {
    for (std::size_t j = 1; 2 * j < i; ++j) x[i] += x[j] * x[i - j];
    if (i % 2 == 0) x[i] += x[i / 2] * (x[i / 2] + 1) / 2;
  }
  // Generators: A of degree 1; a product of i factors has i kicks and i - 1 drifts, its bracket with A one
  // more.
  std::vector<std::int64_t> generators(size, 0);
  generators[1] = 1;
  for (std::size_t i = 1; 2 * i < size; ++i) generators[2 * i] += x[i];
  // The universal enveloping algebra is the tensor algebra: 1 / (1 - g(t)) = product of (1 - t^n)^(-dim n).
  std::vector<std::int64_t> words(size, 0);
  words[0] = 1;
  for (std::size_t n = 1; n < size; ++n)
    for (std::size_t k = 1; k <= n; ++k) words[n] += generators[k] * words[n - k];
  std::vector<std::int64_t> symmetric(size, 0);
  symmetric[0] = 1;
  std::vector<int> result(size, 0);
  for (std::size_t n = 1; n < size; ++n) {
    const std::int64_t dimension = words[n] - symmetric[n];
    // Times (1 - t^n)^(-dimension), whose coefficients are binomials.
    const std::vector<std::int64_t> before = symmetric;
    std::int64_t choices = 1;
    for (std::size_t k = 1; k * n < size; ++k) {
      const auto count = static_cast<std::int64_t>(k);
      choices = choices * (dimension + count - 1) / count;
      for (std::size_t m = k * n; m < size; ++m) symmetric[m] += choices * before[m - k * n];
    }
    const std::size_t potentials = n % 2 == 1 ? (n + 1) / 2 : 0;
    result[n] = static_cast<int>(dimension + (potentials > 0 ? x[potentials] : 0));
  }
  return result;
}

}  // namespace shortfall
