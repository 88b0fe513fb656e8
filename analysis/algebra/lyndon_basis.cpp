// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/lyndon_basis.hpp"

#include <algorithm>
#include <bit>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/kept_by_degree.hpp"

namespace shortfall {

Word Word::of(std::string_view letters) {
  Word word;
  if (letters.size() > 30) throw Error("a word has at most 30 letters");
  for (const char c : letters) {
    if (c != 'A' && c != 'B')
      throw Error("words have the letters A and B only, not '" + std::string(1, c) + "'");
    word.code = word.code << 1 | (c == 'B' ? 1U : 0U);
  }
  return word;
}

int Word::length() const { return static_cast<int>(std::bit_width(code)) - 1; }

int Word::count_b() const { return std::popcount(code) - 1; }

Word Word::part(int first, int count) const {
  const std::uint32_t low = code >> (length() - first - count);
  return {(1U << count) | (low & ((1U << count) - 1))};
}

std::string Word::str() const {
  std::string text;
  for (int k = length(); k-- > 0;) text += (code >> k & 1U) != 0 ? 'B' : 'A';
  return text;
}

Word operator*(Word a, Word b) {
  const int n = b.length();
  return {a.code << n | (b.code ^ (1U << n))};
}

namespace {

/// Whether it comes before each of its proper suffixes, as in a dictionary.
bool is_lyndon(Word w) {
  const int n = w.length();
  for (int k = 1; k < n; ++k) {
    const int rest = n - k;
    const std::uint32_t head = w.part(0, rest).code, tail = w.part(k, rest).code;
    // With equal letters the suffix is a prefix, hence smaller.
    if (head >= tail) return false;
  }
  return true;
}

/// Where the longest proper Lyndon suffix begins.
int standard_cut(Word w) {
  int k = 1;
  while (!is_lyndon(w.part(k, w.length() - k))) ++k;
  return k;
}

}  // namespace

const LyndonBasis& LyndonBasis::up_to(int degree) {
  static KeptByDegree<LyndonBasis> kept;
  return kept.at(0, degree, 1, [&] { return new LyndonBasis(degree); });
}

LyndonBasis::LyndonBasis(int degree) {
  levels_.resize(1);
  for (int d = 1; d <= degree; ++d) {
    add_level(d);
    add_brackets(d);
  }
}

const LyndonBasis::Level& LyndonBasis::level(int degree) const {
  if (degree < 1 || degree > this->degree())
    throw Error("this basis has no degree " + std::to_string(degree));
  return levels_[static_cast<std::size_t>(degree)];
}

std::pair<int, int> LyndonBasis::place(Word w) const {
  const std::vector<Word>& words = level(w.length()).words;
  const auto at = std::ranges::lower_bound(words, w.code, {}, &Word::code);
  return {w.length(), static_cast<int>(at - words.begin())};
}

void LyndonBasis::add_level(int degree) {
  levels_.emplace_back();
  Level& here = levels_.back();
  const std::uint32_t count = 1U << degree;
  for (std::uint32_t letters = 0; letters < count; ++letters)
    if (const Word w{count | letters}; is_lyndon(w)) here.words.push_back(w);

  for (const Word w : here.words) {
    std::vector<std::int32_t>& p = here.polynomials.emplace_back(count, 0);
    if (degree == 1) {
      p[w.code ^ count] = 1;
      here.factors.emplace_back();
      continue;
    }
    const int cut = standard_cut(w);
    const auto left = place(w.part(0, cut)), right = place(w.part(cut, degree - cut));
    here.factors.emplace_back(left, right);
    const auto u = polynomial(left.first, left.second), v = polynomial(right.first, right.second);
    const int rest = degree - cut;
    for (std::uint32_t i = 0; i < u.size(); ++i) {
      if (u[i] == 0) continue;
      for (std::uint32_t j = 0; j < v.size(); ++j) {
        p[i << rest | j] += u[i] * v[j];
        p[j << cut | i] -= u[i] * v[j];
      }
    }
  }

  for (std::size_t i = 0; i < here.words.size(); ++i) {
    std::vector<Term>& larger = here.larger.emplace_back();
    for (std::size_t k = i + 1; k < here.words.size(); ++k)
      if (const std::int32_t c = here.polynomials[i][here.words[k].code ^ count]; c != 0)
        larger.push_back({static_cast<int>(k), c});
  }
}

void LyndonBasis::add_brackets(int degree) {
  Level& here = levels_.back();
  here.brackets.resize(static_cast<std::size_t>(degree));
  std::vector<std::int64_t> at(here.words.size());
  for (int d1 = 1; d1 < degree; ++d1) {
    const int d2 = degree - d1;
    auto& table = here.brackets[static_cast<std::size_t>(d1)];
    for (int i = 0; i < dimension(d1); ++i) {
      for (int j = 0; j < dimension(d2); ++j) {
        const auto u = polynomial(d1, i), v = polynomial(d2, j);
        std::vector<Term>& terms = table.emplace_back();
        for (std::size_t k = 0; k < here.words.size(); ++k) {
          const std::uint32_t w = here.words[k].code ^ (1U << degree);
          const std::uint32_t low2 = (1U << d2) - 1, low1 = (1U << d1) - 1;
          at[k] = static_cast<std::int64_t>(u[w >> d2]) * v[w & low2] -
                  static_cast<std::int64_t>(v[w >> d1]) * u[w & low1];
        }
        for (std::size_t k = 0; k < at.size(); ++k) {
          if (at[k] == 0) continue;
          for (const Term& t : here.larger[k]) at[static_cast<std::size_t>(t.index)] -= t.coefficient * at[k];
          terms.push_back({static_cast<int>(k), static_cast<std::int32_t>(at[k])});
        }
      }
    }
  }
}

std::string LyndonBasis::bracket_text(int degree, int index) const {
  if (degree == 1) return index == 0 ? "A" : "B";
  const auto [left, right] = factors(degree, index);
  return "[" + bracket_text(left.first, left.second) + "," + bracket_text(right.first, right.second) + "]";
}

std::pair<std::pair<int, int>, std::pair<int, int>> LyndonBasis::factors(int degree, int index) const {
  return level(degree).factors[static_cast<std::size_t>(index)];
}

std::span<const LyndonBasis::Term> LyndonBasis::bracket(int d1, int i, int d2, int j) const {
  return level(d1 + d2)
      .brackets[static_cast<std::size_t>(d1)][static_cast<std::size_t>(i * dimension(d2) + j)];
}

std::span<const std::int32_t> LyndonBasis::polynomial(int degree, int index) const {
  return level(degree).polynomials[static_cast<std::size_t>(index)];
}

int witt_dimension(int degree) {
  const auto mobius = [](int n) {
    int sign = 1;
    for (int p = 2; p <= n; ++p) {
      if (n % p != 0) continue;
      n /= p;
      if (n % p == 0) return 0;
      sign = -sign;
    }
    return sign;
  };
  std::int64_t sum = 0;
  for (int d = 1; d <= degree; ++d)
    if (degree % d == 0) sum += mobius(d) * (std::int64_t{1} << (degree / d));
  return static_cast<int>(sum / degree);
}

}  // namespace shortfall
