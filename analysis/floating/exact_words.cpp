// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_words.hpp"

#include <algorithm>
#include <bit>

namespace shortfall {

namespace {

constexpr int kLongestRun = 30;         // doublings of the number of steps between checks
constexpr int kWorthwhile = 6;          // doublings for which the state is copied into other words
constexpr double kOneUp = 1 + 0x1p-40;  // more than a bound's own rounding errors
constexpr double kWide = 0x1p126;       // bounds of |z|, a bit below the word's
constexpr double kNarrow = 0x1p62;

/// Unrolled, so that the state stays in registers. kUpper: nothing stands below the diagonal, as under
/// gravity alone.
template <class Word, int kSize, bool kUpper>
void run(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix, std::int64_t steps) {
  Word m[kSize * kSize], z[kSize];
  for (int i = 0; i < kSize * kSize; ++i) m[i] = matrix[i];
  for (int i = 0; i < kSize; ++i) z[i] = static_cast<Word>(state[i]);
  for (std::int64_t n = 0; n < steps; ++n) {
    Word next[kSize];
#pragma GCC unroll 4
    for (int i = 0; i < kSize; ++i) {
      next[i] = 0;
#pragma GCC unroll 4
      for (int j = kUpper ? i : 0; j < kSize; ++j) next[i] += m[i * kSize + j] * z[j];
    }
#pragma GCC unroll 4
    for (int i = 0; i < kSize; ++i) z[i] = next[i];
  }
  for (int i = 0; i < kSize; ++i) state[i] = z[i];
}

template <class Word>
void run(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix, std::int64_t steps) {
  const std::size_t size = state.size();
  std::vector<Word> z(state.begin(), state.end()), next(size);
  for (std::int64_t n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < size; ++i) {
      next[i] = 0;
      for (std::size_t j = 0; j < size; ++j)
        if (const std::int64_t m = matrix[i * size + j]) next[i] += Word{m} * z[j];
    }
    z.swap(next);
  }
  std::copy(z.begin(), z.end(), state.begin());
}

template <class Word, int kSize>
void run_of_size(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix, std::int64_t steps) {
  bool upper = true;
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < i; ++j) upper = upper && matrix[i * kSize + j] == 0;
  upper ? run<Word, kSize, true>(state, matrix, steps) : run<Word, kSize, false>(state, matrix, steps);
}

template <class Word>
void run_of_any_size(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix,
                     std::int64_t steps) {
  switch (state.size()) {
    case 2:
      return run_of_size<Word, 2>(state, matrix, steps);
    case 3:
      return run_of_size<Word, 3>(state, matrix, steps);
    case 4:
      return run_of_size<Word, 4>(state, matrix, steps);
    default:
      return run<Word>(state, matrix, steps);
  }
}

}  // namespace

ExactWords::ExactWords(std::vector<std::int64_t> matrix, std::vector<Int128> start)
    : matrix_(std::move(matrix)), state_(std::move(start)) {
  const std::size_t size = state_.size();
  // At least the identity: then a bound for 2^i steps is one for fewer.
  std::vector<double> bound(size * size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      bound[i * size + j] =
          std::max(static_cast<double>(magnitude(matrix_[i * size + j])) * kOneUp, i == j ? 1.0 : 0.0);
  for (int doubling = 0; doubling <= kLongestRun; ++doubling) {
    growth_.push_back(bound);
    if (!(*std::ranges::max_element(bound) < kWide)) break;
    std::vector<double> next(size * size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t j = 0; j < size; ++j)
          next[i * size + j] += bound[i * size + k] * bound[k * size + j];
    for (double& b : next) b *= kOneUp;
    bound = std::move(next);
  }
}

std::int64_t ExactWords::advance(std::int64_t steps) {
  const std::size_t size = state_.size();
  std::vector<double> sizes(size);
  std::int64_t done = 0;
  while (done < steps) {
    for (std::size_t j = 0; j < size; ++j) sizes[j] = static_cast<double>(magnitude(state_[j])) * kOneUp;
    // Also on the way: what comes before has smaller bounds.
    const auto stays_below = [&](const std::vector<double>& growth, double limit) {
      for (std::size_t i = 0; i < size; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < size; ++j) sum += growth[i * size + j] * sizes[j];
        if (!(sum * kOneUp < limit)) return false;
      }
      return true;
    };
    const auto longest = [&](double limit) {
      int i = std::min(static_cast<int>(growth_.size()),
                       static_cast<int>(std::bit_width(static_cast<std::uint64_t>(steps - done)))) -
              1;
      while (i >= 0 && !stays_below(growth_[i], limit)) --i;
      return i;
    };
    const int wide = longest(kWide);
    if (wide < 0) break;
    // Words of 64 bits are several times faster, unless they have to be looked at every few steps.
    const int narrow = longest(kNarrow);
    const bool in_64 = narrow >= std::min(wide, kWorthwhile);
    const std::int64_t safe = std::int64_t{1} << (in_64 ? narrow : wide);
    if (in_64)
      run_of_any_size<std::int64_t>(state_, matrix_, safe);
    else
      run_of_any_size<Int128>(state_, matrix_, safe);
    done += safe;
  }
  return done;
}

}  // namespace shortfall
