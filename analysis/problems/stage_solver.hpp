// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {

inline constexpr const char* kSingularStage =
    "an implicit stage has no unique solution: its linear system is singular";

/// How a vector falls into numbers: components, which depend on each other, of several lanes, which do not. A
/// plain number is one component of one lane; vector types specialise this.
template <class V>
struct VectorParts {
  using Scalar = V;
  static constexpr std::size_t kLanes = 1;
  static std::size_t components(const V&) { return 1; }
  static V& at(V& v, std::size_t, std::size_t) { return v; }
  static const V& at(const V& v, std::size_t, std::size_t) { return v; }
};

/// What Newton's iteration needs of the numbers of one lane.
template <class T>
struct StageParts {
  using Matrix = std::vector<std::vector<T>>;

  /// The matrix of 1 - f' by differences, which are exact for an f that is affine; in numbers alone.
  template <class F>
  static Matrix one_minus_slopes(const std::vector<T>& unknowns, const std::vector<T>& at, F&& f,
                                 const T& zero, const T& one) {
    const std::size_t count = unknowns.size();
    Matrix matrix(count, std::vector<T>(count, zero));
    for (std::size_t j = 0; j < count; ++j) {
      std::vector<T> moved = unknowns;
      moved[j] = moved[j] + one;
      const T width = moved[j] - unknowns[j];
      const std::vector<T> there = f(moved);
      for (std::size_t i = 0; i < count; ++i)
        matrix[i][j] = (i == j ? one : zero) - (there[i] - at[i]) / width;
    }
    return matrix;
  }

  /// Elimination with the largest pivot of each column.
  ///
  /// throws  Undefined  when a pivot is zero
  static std::vector<T> solved(Matrix& matrix, std::vector<T> right, const T& zero) {
    const std::size_t count = right.size();
    for (std::size_t p = 0; p < count; ++p) {
      std::size_t best = p;
      for (std::size_t row = p + 1; row < count; ++row)
        if (size(matrix[best][p], zero) < size(matrix[row][p], zero)) best = row;
      if (matrix[best][p] == zero) throw Undefined(kSingularStage);
      std::swap(matrix[best], matrix[p]);
      std::swap(right[best], right[p]);
      for (std::size_t row = 0; row < count; ++row) {
        if (row == p) continue;
        const T factor = matrix[row][p] / matrix[p][p];
        for (std::size_t k = p; k < count; ++k) matrix[row][k] = matrix[row][k] - factor * matrix[p][k];
        right[row] = right[row] - factor * right[p];
      }
    }
    for (std::size_t p = 0; p < count; ++p) right[p] = right[p] / matrix[p][p];
    return right;
  }

  static T size(const T& value, const T& zero) { return value < zero ? T(-value) : value; }
};

/// A function of unknowns by reference, so that the solver is compiled once for all of them.
template <class Unknowns>
class StageFunction {
 public:
  template <class F>
  explicit StageFunction(F& f)
      : object_(&f), call_([](void* object, const Unknowns& unknowns) -> Unknowns {
          return (*static_cast<F*>(object))(unknowns);
        }) {}
  Unknowns operator()(const Unknowns& unknowns) const { return call_(object_, unknowns); }

 private:
  void* object_;
  Unknowns (*call_)(void*, const Unknowns&);
};

/// See `solve_stages`.
template <class Unknowns, class T>
void newton_iteration(Unknowns& unknowns, const StageFunction<Unknowns>& f, const T& zero, const T& one) {
  using Parts = VectorParts<typename Unknowns::value_type>;
  constexpr int kMostRounds = 50;
  constexpr std::size_t kLanes = Parts::kLanes;
  const std::size_t parts = Parts::components(unknowns[0]);
  const std::size_t count = unknowns.size() * parts;
  const auto entry = [parts](auto& vectors, std::size_t i, std::size_t lane) -> auto& {
    return Parts::at(vectors[i / parts], i % parts, lane);
  };
  const auto distance = [&](const Unknowns& a, const Unknowns& b, std::size_t lane) {
    T largest = zero;
    for (std::size_t i = 0; i < count; ++i)
      if (const T d = StageParts<T>::size(entry(a, i, lane) - entry(b, i, lane), zero); largest < d)
        largest = d;
    return largest;
  };
  std::vector<Unknowns> moved(count, unknowns), there(count, unknowns);
  typename StageParts<T>::Matrix matrix(count, std::vector<T>(count, zero));
  std::vector<T> residual(count, zero);
  std::vector<char> settled(kLanes, 0);
  for (int round = 0; round < kMostRounds; ++round) {
    const Unknowns at = f(unknowns);
    for (std::size_t j = 0; j < count; ++j) {
      moved[j] = unknowns;
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        entry(moved[j], j, lane) = entry(unknowns, j, lane) + one;
      there[j] = f(moved[j]);
    }
    Unknowns next = unknowns;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (settled[lane]) continue;
      for (std::size_t j = 0; j < count; ++j) {
        const T width = entry(moved[j], j, lane) - entry(unknowns, j, lane);
        for (std::size_t i = 0; i < count; ++i)
          matrix[i][j] = (i == j ? one : zero) - (entry(there[j], i, lane) - entry(at, i, lane)) / width;
      }
      for (std::size_t i = 0; i < count; ++i) residual[i] = entry(at, i, lane) - entry(unknowns, i, lane);
      const std::vector<T> move = StageParts<T>::solved(matrix, residual, zero);
      for (std::size_t i = 0; i < count; ++i) entry(next, i, lane) = entry(next, i, lane) + move[i];
    }
    if (round > 0) {
      const Unknowns after = f(next);
      bool all = true;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        settled[lane] = settled[lane] || !(distance(next, after, lane) < distance(unknowns, at, lane));
        all = all && settled[lane];
        if (!settled[lane]) continue;
        for (std::size_t i = 0; i < count; ++i) entry(next, i, lane) = entry(unknowns, i, lane);
      }
      if (all) return;
    }
    unknowns = std::move(next);
  }
}

/// Makes unknowns = f(unknowns) true in numbers that round, by Newton's iteration with the differences of f
/// as its Jacobian: for a force that is affine in x and v one round solves the stage, and it goes on until
/// the residual no longer shrinks, 50 rounds at most. Every lane does what it would do alone.
///
/// param   unknowns  a std::vector or std::array of vectors: a first guess, then the solution
/// throws  Undefined  when the stage is singular
template <class Unknowns, class F, class T>
void solve_stages(Unknowns& unknowns, F&& f, const T& zero, const T& one) {
  newton_iteration(unknowns, StageFunction<Unknowns>(f), zero, one);
}

}  // namespace shortfall
