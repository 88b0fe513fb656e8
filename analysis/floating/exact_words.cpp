// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_words.hpp"

#include <algorithm>
#include <cmath>

namespace shortfall {

namespace {

constexpr int kLongestRun = 30;         // doublings of the number of steps between checks
constexpr double kOneUp = 1 + 0x1p-40;  // more than a bound's own rounding errors
constexpr double kWide = 0x1p126;       // bounds of |z|, a bit below the word's
constexpr double kNarrow = 0x1p62;

template <class Word, int kSize>
void run(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix, std::int64_t steps) {
  Word m[kSize * kSize], z[kSize];
  for (int i = 0; i < kSize * kSize; ++i) m[i] = matrix[i];
  for (int i = 0; i < kSize; ++i) z[i] = static_cast<Word>(state[i]);
  for (std::int64_t n = 0; n < steps; ++n) {
    Word next[kSize];
    for (int i = 0; i < kSize; ++i) {
      next[i] = 0;
      for (int j = 0; j < kSize; ++j) next[i] += m[i * kSize + j] * z[j];
    }
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

template <class Word>
void run_of_any_size(std::vector<Int128>& state, const std::vector<std::int64_t>& matrix,
                     std::int64_t steps) {
  switch (state.size()) {
    case 2:
      return run<Word, 2>(state, matrix, steps);
    case 3:
      return run<Word, 3>(state, matrix, steps);
    case 4:
      return run<Word, 4>(state, matrix, steps);
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
    double largest = 0;
    for (std::size_t i = 0; i < size; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < size; ++j) sum += bound[i * size + j];
      largest = std::max(largest, sum * kOneUp);
    }
    growth_.push_back(largest);
    if (!(largest < kWide)) break;
    std::vector<double> next(size * size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t j = 0; j < size; ++j)
          next[i * size + j] += bound[i * size + k] * bound[k * size + j] * kOneUp;
    bound = std::move(next);
  }
}

std::int64_t ExactWords::advance(std::int64_t steps) {
  std::int64_t done = 0;
  while (done < steps) {
    UInt128 largest = 1;
    for (const Int128 z : state_) largest = std::max(largest, magnitude(z));
    const double size = static_cast<double>(largest) * kOneUp;
    int i = static_cast<int>(growth_.size()) - 1;
    while (i >= 0 && ((std::int64_t{1} << i) > steps - done || !(size * growth_[i] < kWide))) --i;
    if (i < 0) break;
    const std::int64_t safe = std::int64_t{1} << i;
    if (size * growth_[i] < kNarrow)
      run_of_any_size<std::int64_t>(state_, matrix_, safe);
    else
      run_of_any_size<Int128>(state_, matrix_, safe);
    done += safe;
  }
  return done;
}

}  // namespace shortfall
