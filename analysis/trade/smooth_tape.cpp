// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/smooth_tape.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

using Op = SmoothTape::Op;

namespace {

bool is_unary(Op op) { return op >= Op::negate && op < Op::power; }

}  // namespace

bool SmoothTape::has_corners() const {
  return std::ranges::any_of(nodes, [](const Node& n) { return n.op == Op::absolute; });
}

TapeRecorder::TapeRecorder(int inputs) {
  tape_.inputs = inputs;
  for (int i = 0; i < inputs; ++i) tape_.nodes.push_back({Op::input, i, 0});
}

const Rational* TapeRecorder::constant_value(int node) const {
  const SmoothTape::Node& n = tape_.nodes[static_cast<std::size_t>(node)];
  return n.op == Op::constant ? &tape_.constants[static_cast<std::size_t>(n.a)] : nullptr;
}

int TapeRecorder::constant(const Rational& value) {
  const auto [found, is_new] = constant_nodes_.emplace(value, 0);
  if (is_new) {
    tape_.constants.push_back(value);
    tape_.nodes.push_back({Op::constant, static_cast<int>(tape_.constants.size()) - 1, 0});
    found->second = static_cast<int>(tape_.nodes.size()) - 1;
  }
  return found->second;
}

int TapeRecorder::add(SmoothTape::Node node) {
  const auto key = std::make_tuple(static_cast<int>(node.op), node.a, node.b);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  tape_.nodes.push_back(node);
  const int index = static_cast<int>(tape_.nodes.size()) - 1;
  known_.emplace(key, index);
  return index;
}

int TapeRecorder::binary(Op op, int a, int b) {
  const Rational *left = constant_value(a), *right = constant_value(b);
  if (left && right) {
    switch (op) {
      case Op::add:
        return constant(*left + *right);
      case Op::subtract:
        return constant(*left - *right);
      case Op::multiply:
        return constant(*left * *right);
      default:
        return constant(*left / *right);
    }
  }
  const bool zero_left = left && left->is_zero(), zero_right = right && right->is_zero();
  switch (op) {
    case Op::add:
      if (zero_left) return b;
      if (zero_right) return a;
      break;
    case Op::subtract:
      if (zero_right) return a;
      if (zero_left) return unary(Op::negate, b);
      break;
    case Op::multiply:
      if (zero_left || zero_right) return constant(0);
      if (left && left->is_one()) return b;
      if (right && right->is_one()) return a;
      break;
    default:
      if (zero_right) throw Undefined("the force divides by zero");
      if (zero_left) return constant(0);
      if (right && right->is_one()) return a;
  }
  return add({op, a, b});
}

int TapeRecorder::unary(Op op, int a) {
  const Rational* value = constant_value(a);
  if (value) {
    if (op == Op::negate) return constant(-*value);
    if (op == Op::absolute) return constant(value->abs());
    if (value->is_zero() && (op == Op::sin || op == Op::sqrt)) return constant(0);
    if (value->is_zero() && (op == Op::cos || op == Op::exp)) return constant(1);
    if (value->is_one() && op == Op::sqrt) return constant(1);
    if (value->is_one() && op == Op::log) return constant(0);
  }
  if (op == Op::sin || op == Op::cos) {
    // Always both, one behind the other: a series of one needs the other.
    const int sine = add({Op::sin, a, 0});
    if (sine + 1 == static_cast<int>(tape_.nodes.size())) add({Op::cos, a, 0});
    return op == Op::sin ? sine : sine + 1;
  }
  return add({op, a, 0});
}

int TapeRecorder::power(int a, const Rational& exponent) {
  std::int64_t whole = 0;
  if (exponent.fits_int64(whole) && whole >= 0 && whole <= 32) {
    int result = constant(1), square = a;
    for (; whole > 0; whole /= 2) {
      if (whole % 2) result = binary(Op::multiply, result, square);
      if (whole > 1) square = binary(Op::multiply, square, square);
    }
    return result;
  }
  if (exponent.fits_int64(whole) && whole < 0 && whole >= -32)
    return binary(Op::divide, constant(1), power(a, -exponent));
  if (exponent == Rational(1, 2)) return unary(Op::sqrt, a);
  const int e = constant(exponent);
  return add({Op::power, a, e});
}

std::vector<int> TapeRecorder::gradient(int node) {
  const std::vector<SmoothTape::Node> nodes(tape_.nodes.begin(), tape_.nodes.begin() + node + 1);
  const int zero = constant(0);
  std::vector<int> slope(nodes.size(), zero);
  slope[static_cast<std::size_t>(node)] = constant(1);
  const auto give = [&](int to, int amount) {
    int& s = slope[static_cast<std::size_t>(to)];
    s = binary(Op::add, s, amount);
  };
  for (int i = node; i >= tape_.inputs; --i) {
    const SmoothTape::Node n = nodes[static_cast<std::size_t>(i)];
    const int s = slope[static_cast<std::size_t>(i)];
    if (s == zero) continue;
    switch (n.op) {
      case Op::input:
      case Op::constant:
        break;
      case Op::add:
        give(n.a, s);
        give(n.b, s);
        break;
      case Op::subtract:
        give(n.a, s);
        give(n.b, unary(Op::negate, s));
        break;
      case Op::multiply:
        give(n.a, binary(Op::multiply, s, n.b));
        give(n.b, binary(Op::multiply, s, n.a));
        break;
      case Op::divide:
        give(n.a, binary(Op::divide, s, n.b));
        give(n.b, unary(Op::negate, binary(Op::divide, binary(Op::multiply, s, i), n.b)));
        break;
      case Op::negate:
        give(n.a, unary(Op::negate, s));
        break;
      case Op::absolute:
        give(n.a, binary(Op::multiply, s, binary(Op::divide, i, n.a)));
        break;
      case Op::sqrt:
        give(n.a, binary(Op::divide, s, binary(Op::multiply, constant(2), i)));
        break;
      case Op::exp:
        give(n.a, binary(Op::multiply, s, i));
        break;
      case Op::log:
        give(n.a, binary(Op::divide, s, n.a));
        break;
      case Op::sin:
        give(n.a, binary(Op::multiply, s, i + 1));
        break;
      case Op::cos:
        give(n.a, unary(Op::negate, binary(Op::multiply, s, i - 1)));
        break;
      case Op::power: {
        const Rational exponent = *constant_value(n.b);
        const int lower = power(n.a, exponent - Rational(1));
        give(n.a, binary(Op::multiply, s, binary(Op::multiply, constant(exponent), lower)));
        break;
      }
    }
  }
  return {slope.begin(), slope.begin() + tape_.inputs};
}

SmoothTape TapeRecorder::finish(const std::vector<int>& outputs) const {
  std::vector<bool> needed(tape_.nodes.size(), false);
  for (int o : outputs) needed[static_cast<std::size_t>(o)] = true;
  for (std::size_t i = tape_.nodes.size(); i-- > 0;) {
    const SmoothTape::Node& n = tape_.nodes[i];
    if (n.op == Op::sin && needed[i + 1]) needed[i] = true;
    if (!needed[i] || n.op == Op::input || n.op == Op::constant) continue;
    if (n.op == Op::sin) needed[i + 1] = true;
    needed[static_cast<std::size_t>(n.a)] = true;
    if (!is_unary(n.op)) needed[static_cast<std::size_t>(n.b)] = true;
  }
  SmoothTape result;
  result.inputs = tape_.inputs;
  result.constants = tape_.constants;
  std::vector<int> place(tape_.nodes.size(), -1);
  for (std::size_t i = 0; i < tape_.nodes.size(); ++i) {
    SmoothTape::Node n = tape_.nodes[i];
    if (!needed[i] && n.op != Op::input) continue;
    if (n.op != Op::input && n.op != Op::constant) {
      n.a = place[static_cast<std::size_t>(n.a)];
      if (!is_unary(n.op)) n.b = place[static_cast<std::size_t>(n.b)];
    }
    place[i] = static_cast<int>(result.nodes.size());
    result.nodes.push_back(n);
  }
  for (int o : outputs) result.outputs.push_back(place[static_cast<std::size_t>(o)]);
  return result;
}

}  // namespace shortfall
