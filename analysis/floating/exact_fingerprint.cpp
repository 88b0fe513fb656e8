// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_fingerprint.hpp"

#include <array>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/exact_question.hpp"

namespace shortfall {

namespace {

/// A product of residues is less than 2^122, so that 32 of them can be added before they are reduced.
constexpr std::size_t kUnreduced = 32;

Modular reduced(UInt128 sum) {
  // 2^61 = 1: the upper parts are added to the lowest.
  std::uint64_t low = (static_cast<std::uint64_t>(sum) & Modular::kPrime) +
                      static_cast<std::uint64_t>(sum >> 61 & Modular::kPrime) +
                      static_cast<std::uint64_t>(sum >> 122);
  return Modular(low);
}

Modular dot(const Modular* row, const Modular* vector, std::size_t size) {
  Modular total;
  for (std::size_t begin = 0; begin < size; begin += kUnreduced) {
    UInt128 sum = 0;
    for (std::size_t j = begin; j < size && j < begin + kUnreduced; ++j)
      sum += static_cast<UInt128>(row[j].value()) * vector[j].value();
    total += reduced(sum);
  }
  return total;
}

/// Two folds instead of a full reduction: residues stay below 2^61 + 8, and four products of such below
/// 2^125.
template <std::size_t kSize>
void run(std::vector<Modular>& state, const std::vector<Modular>& matrix, std::int64_t steps) {
  static_assert(kSize <= 4);
  std::array<std::uint64_t, kSize * kSize> m;
  std::array<std::uint64_t, kSize> z, next;
  for (std::size_t i = 0; i < m.size(); ++i) m[i] = matrix[i].value();
  for (std::size_t i = 0; i < kSize; ++i) z[i] = state[i].value();
  for (std::int64_t n = 0; n < steps; ++n) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kSize; ++i) {
      UInt128 sum = 0;
#pragma GCC unroll 4
      for (std::size_t j = 0; j < kSize; ++j) sum += static_cast<UInt128>(m[i * kSize + j]) * z[j];
      const std::uint64_t once =
          (static_cast<std::uint64_t>(sum) & Modular::kPrime) + static_cast<std::uint64_t>(sum >> 61);
      next[i] = (once & Modular::kPrime) + (once >> 61);
    }
    z = next;
  }
  for (std::size_t i = 0; i < kSize; ++i) state[i] = Modular(z[i]);
}

void run(std::vector<Modular>& state, const std::vector<Modular>& matrix, std::int64_t steps) {
  const std::size_t size = state.size();
  std::vector<Modular> next(size);
  for (std::int64_t n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < size; ++i) next[i] = dot(&matrix[i * size], state.data(), size);
    state.swap(next);
  }
}

std::vector<Modular> residues(const std::vector<Fraction>& row) {
  std::vector<Modular> result;
  for (const Fraction& f : row) result.emplace_back(f.constant());
  return result;
}

}  // namespace

ExactFingerprint::ExactFingerprint(const Program& program, const NumericQuestion& question) {
  const StepMatrix m = exact_matrix(program, question);
  for (const auto& row : m.step)
    for (const Modular entry : residues(row)) matrix_.push_back(entry);
  state_ = residues(m.start);
  position_ = residues(m.position);
  velocity_ = residues(m.velocity);
}

Modular ExactFingerprint::read(const std::vector<Modular>& row) const {
  return dot(row.data(), state_.data(), state_.size());
}

void ExactFingerprint::advance(std::int64_t steps) {
  if (steps < 0) throw BadInput("a trajectory goes forwards only");
  switch (state_.size()) {
    case 2:
      run<2>(state_, matrix_, steps);
      break;
    case 3:
      run<3>(state_, matrix_, steps);
      break;
    case 4:
      run<4>(state_, matrix_, steps);
      break;
    default:
      run(state_, matrix_, steps);
  }
  frame_ += steps;
}

void ExactFingerprint::jump(std::int64_t steps) {
  if (steps < 0) throw BadInput("a trajectory goes forwards only");
  frame_ += steps;
  const std::size_t size = state_.size();
  std::vector<Modular> power = matrix_;
  for (; steps > 0; steps >>= 1) {
    if (steps & 1) run(state_, power, 1);
    std::vector<Modular> square(size * size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t j = 0; j < size; ++j)
          square[i * size + j] += power[i * size + k] * power[k * size + j];
    power = std::move(square);
  }
}

}  // namespace shortfall
