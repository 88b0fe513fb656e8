// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A function of several numbers as a straight list of operations, recorded once and then run in numbers of
/// any kind, in power series, or differentiated.
struct SmoothTape {
  enum class Op : std::uint8_t {
    input,     ///< the value of input a
    constant,  ///< constants[a]
    add,
    subtract,
    multiply,
    divide,
    negate,
    absolute,
    sqrt,
    exp,
    log,
    sin,    ///< its cosine is the next node
    cos,    ///< its sine is the node before
    power,  ///< a ^ b, b a constant node
  };
  struct Node {
    Op op;
    int a = 0;
    int b = 0;
  };
  int inputs = 0;
  std::vector<Node> nodes;
  std::vector<Rational> constants;
  std::vector<int> outputs;  ///< nodes

  /// Whether |u| occurs: then the function is smooth only between the zeros of those u.
  bool has_corners() const;
};

/// Records a tape. The same operation on the same nodes is recorded once; operations on constants are done at
/// once, exactly, where the result is rational.
class TapeRecorder {
 public:
  explicit TapeRecorder(int inputs);

  int input(int index) const { return index; }
  int constant(const Rational& value);
  int binary(SmoothTape::Op op, int a, int b);
  int unary(SmoothTape::Op op, int a);
  int power(int a, const Rational& exponent);
  /// The derivatives of one node by all inputs, as nodes (reverse accumulation).
  ///
  /// source  Griewank & Walther (2008), Evaluating Derivatives, section 3.2
  std::vector<int> gradient(int node);

  /// The tape of what the outputs need, and nothing else.
  SmoothTape finish(const std::vector<int>& outputs) const;
  const Rational* constant_value(int node) const;

 private:
  int add(SmoothTape::Node node);

  SmoothTape tape_;
  std::map<std::tuple<int, int, int>, int> known_;
  std::map<Rational, int> constant_nodes_;
};

/// A number that records what is done to it.
///
/// Invariant: all that meet in an operation have the same recorder.
struct Traced {
  TapeRecorder* recorder = nullptr;
  int node = 0;

  Traced operator-() const { return {recorder, recorder->unary(SmoothTape::Op::negate, node)}; }
};

inline Traced traced(SmoothTape::Op op, const Traced& a, const Traced& b) {
  return {a.recorder, a.recorder->binary(op, a.node, b.node)};
}
inline Traced operator+(const Traced& a, const Traced& b) { return traced(SmoothTape::Op::add, a, b); }
inline Traced operator-(const Traced& a, const Traced& b) { return traced(SmoothTape::Op::subtract, a, b); }
inline Traced operator*(const Traced& a, const Traced& b) { return traced(SmoothTape::Op::multiply, a, b); }
inline Traced operator/(const Traced& a, const Traced& b) { return traced(SmoothTape::Op::divide, a, b); }
inline Traced traced(SmoothTape::Op op, const Traced& a) {
  return {a.recorder, a.recorder->unary(op, a.node)};
}
inline Traced sqrt(const Traced& a) { return traced(SmoothTape::Op::sqrt, a); }
inline Traced exp(const Traced& a) { return traced(SmoothTape::Op::exp, a); }
inline Traced log(const Traced& a) { return traced(SmoothTape::Op::log, a); }
inline Traced sin(const Traced& a) { return traced(SmoothTape::Op::sin, a); }
inline Traced cos(const Traced& a) { return traced(SmoothTape::Op::cos, a); }
inline Traced abs(const Traced& a) { return traced(SmoothTape::Op::absolute, a); }

}  // namespace shortfall
