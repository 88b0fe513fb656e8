// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_model.hpp"

#include <algorithm>
#include <functional>
#include <type_traits>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/double_double.hpp"
#include "analysis/program/function.hpp"
#include "analysis/trade/rounded_number.hpp"
#include "analysis/trade/tape_lanes.hpp"
#include "analysis/trade/tape_run.hpp"

namespace shortfall {

namespace {

bool is_chosen(const ForceChoice& chosen, std::size_t i) { return chosen.empty() || chosen[i]; }

bool is_expression(const SceneForce& f) {
  return f.kind == SceneForce::Kind::expression || f.kind == SceneForce::Kind::potential;
}

template <class S>
ForceTerm<S> term_of(const Scene& scene, const SceneForce& force,
                     const std::function<S(const Rational&)>& number) {
  ForceTerm<S> term{force.kind, scene.dimension, force.bodies, {}, {}, number(1), number(2)};
  for (const Rational& n : force.numbers) term.p.push_back(number(n));
  for (const SceneBody& b : scene.bodies) term.masses.push_back(number(b.mass));
  term.damped = (force.kind == SceneForce::Kind::spring || force.kind == SceneForce::Kind::link) &&
                !force.numbers[1].is_zero();
  term.has_rest = force.kind == SceneForce::Kind::spring && !force.numbers.back().is_zero();
  return term;
}

/// What an expression of a force is, recorded.
class ExpressionTracer {
 public:
  ExpressionTracer(TapeRecorder& recorder, int dimension, int coordinates, int body)
      : r_(recorder), d_(dimension), m_(coordinates), body_(body) {}

  int operator()(const Expr& e) const {
    using Op = Expression::Op;
    const auto part = [&](std::size_t i) { return (*this)(e->operands[i]); };
    switch (e->op) {
      case Op::number:
        return r_.constant(e->value);
      case Op::name:
        return variable(e->name);
      case Op::negate:
        return r_.unary(SmoothTape::Op::negate, part(0));
      case Op::add:
        return r_.binary(SmoothTape::Op::add, part(0), part(1));
      case Op::subtract:
        return r_.binary(SmoothTape::Op::subtract, part(0), part(1));
      case Op::multiply:
        return r_.binary(SmoothTape::Op::multiply, part(0), part(1));
      case Op::divide:
        return r_.binary(SmoothTape::Op::divide, part(0), part(1));
      case Op::power:
        return power(part(0), part(1));
      case Op::call:
        return call(e);
      default:
        throw Unable("a force of a scene is an expression in x, y, z, vx, vy, vz and t");
    }
  }

 private:
  int variable(const std::string& name) const {
    static const std::string kAxes = "xyz";
    if (name == "t") return r_.input(2 * m_);
    const bool velocity = name.size() == 2 && name[0] == 'v';
    const std::size_t axis = kAxes.find(name.back());
    return r_.input((velocity ? m_ : 0) + body_ * d_ + static_cast<int>(axis));
  }

  int power(int base, int exponent) const {
    if (const Rational* value = r_.constant_value(exponent)) return r_.power(base, *value);
    const int logarithm = r_.unary(SmoothTape::Op::log, base);
    return r_.unary(SmoothTape::Op::exp, r_.binary(SmoothTape::Op::multiply, exponent, logarithm));
  }

  int call(const Expr& e) const {
    const Function f = *function_named(e->name);
    const int a = (*this)(e->operands[0]);
    switch (f) {
      case Function::sqrt:
        return r_.unary(SmoothTape::Op::sqrt, a);
      case Function::exp:
        return r_.unary(SmoothTape::Op::exp, a);
      case Function::log:
        return r_.unary(SmoothTape::Op::log, a);
      case Function::sin:
        return r_.unary(SmoothTape::Op::sin, a);
      case Function::cos:
        return r_.unary(SmoothTape::Op::cos, a);
      case Function::cosh:
      case Function::sinh: {
        const int up = r_.unary(SmoothTape::Op::exp, a);
        const int down = r_.binary(SmoothTape::Op::divide, r_.constant(1), up);
        const auto op = f == Function::cosh ? SmoothTape::Op::add : SmoothTape::Op::subtract;
        return r_.binary(SmoothTape::Op::multiply, r_.constant(Rational(1, 2)), r_.binary(op, up, down));
      }
      case Function::pow:
        return power(a, (*this)(e->operands[1]));
      case Function::max:
      case Function::min: {  // (a + b +- |a - b|)/2
        const int b = (*this)(e->operands[1]);
        const int apart = r_.unary(SmoothTape::Op::absolute, r_.binary(SmoothTape::Op::subtract, a, b));
        const auto op = f == Function::max ? SmoothTape::Op::add : SmoothTape::Op::subtract;
        const int sum = r_.binary(op, r_.binary(SmoothTape::Op::add, a, b), apart);
        return r_.binary(SmoothTape::Op::multiply, r_.constant(Rational(1, 2)), sum);
      }
      default:
        throw Unable("the function " + e->name + " does not stand in a scene's forces");
    }
  }

  TapeRecorder& r_;
  int d_, m_, body_;
};

/// The accelerations of an expression force, one node for each coordinate; -1 where it has none.
std::vector<int> traced_expression(const Scene& scene, const SceneForce& force, TapeRecorder& recorder) {
  const int d = scene.dimension, m = scene.coordinates();
  std::vector<int> nodes(static_cast<std::size_t>(m), -1);
  for (int b : force.bodies) {
    const ExpressionTracer trace(recorder, d, m, b);
    if (force.kind == SceneForce::Kind::expression) {
      for (int i = 0; i < d; ++i)
        nodes[static_cast<std::size_t>(b * d + i)] = trace(force.expressions[static_cast<std::size_t>(i)]);
    } else {
      const std::vector<int> slopes = recorder.gradient(trace(force.expressions[0]));
      for (int i = b * d; i < b * d + d; ++i)
        nodes[static_cast<std::size_t>(i)] =
            recorder.unary(SmoothTape::Op::negate, slopes[static_cast<std::size_t>(i)]);
    }
  }
  return nodes;
}

SmoothTape expression_tape(const Scene& scene, const SceneForce& force) {
  TapeRecorder recorder(2 * scene.coordinates() + 1);
  std::vector<int> nodes = traced_expression(scene, force, recorder);
  for (int& n : nodes)
    if (n < 0) n = recorder.constant(0);
  return recorder.finish(nodes);
}

struct TracedState {
  std::vector<Traced> x, v;
  Traced t;
};

TracedState traced_state(TapeRecorder& recorder, int m) {
  TracedState state;
  for (int i = 0; i < m; ++i) state.x.push_back({&recorder, recorder.input(i)});
  for (int i = 0; i < m; ++i) state.v.push_back({&recorder, recorder.input(m + i)});
  state.t = {&recorder, recorder.input(2 * m)};
  return state;
}

std::function<Traced(const Rational&)> traced_numbers(TapeRecorder& recorder) {
  return [&recorder](const Rational& r) { return Traced{&recorder, recorder.constant(r)}; };
}

}  // namespace

SmoothTape acceleration_tape(const Scene& scene, const ForceChoice& chosen) {
  const int m = scene.coordinates();
  TapeRecorder recorder(2 * m + 1);
  const auto number = traced_numbers(recorder);
  const TracedState s = traced_state(recorder, m);
  std::vector<Traced> a(static_cast<std::size_t>(m), number(0));
  for (std::size_t i = 0; i < scene.forces.size(); ++i) {
    if (!is_chosen(chosen, i)) continue;
    const SceneForce& force = scene.forces[i];
    if (!is_expression(force)) {
      term_of<Traced>(scene, force, number).add(s.x.data(), s.v.data(), s.t, a.data());
      continue;
    }
    const std::vector<int> nodes = traced_expression(scene, force, recorder);
    for (std::size_t c = 0; c < a.size(); ++c)
      if (nodes[c] >= 0) a[c] = a[c] + Traced{&recorder, nodes[c]};
  }
  std::vector<int> outputs;
  for (const Traced& t : a) outputs.push_back(t.node);
  return recorder.finish(outputs);
}

std::optional<SmoothTape> energy_tape(const Scene& scene, const ForceChoice& chosen, std::string* why) {
  const int m = scene.coordinates(), d = scene.dimension;
  TapeRecorder recorder(2 * m + 1);
  const auto number = traced_numbers(recorder);
  const TracedState s = traced_state(recorder, m);
  Traced energy = number(0);
  for (int i = 0; i < m; ++i) {
    const Traced& v = s.v[static_cast<std::size_t>(i)];
    energy = energy + number(scene.bodies[static_cast<std::size_t>(i / d)].mass / Rational(2)) * (v * v);
  }
  for (std::size_t i = 0; i < scene.forces.size(); ++i) {
    if (!is_chosen(chosen, i)) continue;
    const SceneForce& force = scene.forces[i];
    if (force.kind == SceneForce::Kind::potential) {
      for (int b : force.bodies) {
        const ExpressionTracer trace(recorder, d, m, b);
        energy = energy + number(scene.bodies[static_cast<std::size_t>(b)].mass) *
                              Traced{&recorder, trace(force.expressions[0])};
      }
      continue;
    }
    const auto potential = term_of<Traced>(scene, force, number).potential(s.x.data());
    if (!potential) {
      if (why) *why = force.name;
      return std::nullopt;
    }
    energy = energy + *potential;
  }
  return recorder.finish({energy.node});
}

SmoothTape potential_tape(const Expr& potential, int derivatives) {
  TapeRecorder recorder(3);
  std::vector<int> nodes{ExpressionTracer(recorder, 1, 1, 0)(potential)};
  for (int k = 0; k < derivatives; ++k) nodes.push_back(recorder.gradient(nodes.back())[0]);
  return recorder.finish(nodes);
}

template <class S>
TapeValues<S>::TapeValues(SmoothTape tape) : tape_(std::move(tape)), values_(tape_.nodes.size()) {
  for (std::size_t i = 0; i < tape_.nodes.size(); ++i)
    if (tape_.nodes[i].op == SmoothTape::Op::constant)
      values_[i] = rounded_number<S>(tape_.constants[static_cast<std::size_t>(tape_.nodes[i].a)]);
}

template <class S>
void TapeValues<S>::operator()(const S* x, const S* v, const S& t, int m, S* out) {
  run_tape(tape_, x, v, t, m, nullptr, values_, out);
}

template <class S>
void TapeValues<S>::lanes(const S* x, const S* v, const S& t, S* out) {
  if constexpr (std::is_floating_point_v<S>) {
    if (rows_.empty()) {
      rows_.resize(values_.size() * kTapeLanes);
      for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = values_[i / kTapeLanes];
    }
    run_tape_lanes(tape_, x, v, t, rows_.data(), out);
  } else {
    throw Error("tapes have lanes in binary32 and binary64");
  }
}

template <class S>
SceneAcceleration<S>::SceneAcceleration(const Scene& scene, const ForceChoice& chosen)
    : m_(scene.coordinates()), kept_(static_cast<std::size_t>(m_)), extra_(static_cast<std::size_t>(m_)) {
  const std::function<S(const Rational&)> number = rounded_number<S>;
  for (std::size_t i = 0; i < scene.forces.size(); ++i) {
    if (!is_chosen(chosen, i)) continue;
    const SceneForce& force = scene.forces[i];
    (force.held ? held_ : free_).push_back(static_cast<int>(terms_.size()));
    terms_.push_back(term_of<S>(scene, force, number));
    tape_of_.push_back(is_expression(force) ? static_cast<int>(tapes_.size()) : -1);
    if (is_expression(force)) tapes_.emplace_back(expression_tape(scene, force));
  }
}

template <class S>
void SceneAcceleration<S>::add(const std::vector<int>& which, const S* x, const S* v, const S& t, S* a) {
  for (int i : which) {
    const int tape = tape_of_[static_cast<std::size_t>(i)];
    if (tape < 0) {
      terms_[static_cast<std::size_t>(i)].add(x, v, t, a);
      continue;
    }
    tapes_[static_cast<std::size_t>(tape)](x, v, t, m_, extra_.data());
    for (int c = 0; c < m_; ++c) a[c] = a[c] + extra_[static_cast<std::size_t>(c)];
  }
}

template <class S>
void SceneAcceleration<S>::begin_frame(const S* x, const S* v, const S& t) {
  if (held_.empty()) return;
  for (S& k : kept_) k = rounded_number<S>(0);
  add(held_, x, v, t, kept_.data());
}

template <class S>
void SceneAcceleration<S>::operator()(const S* x, const S* v, const S& t, S* a) {
  if (held_.empty())
    for (int c = 0; c < m_; ++c) a[c] = S(0);
  else
    for (int c = 0; c < m_; ++c) a[c] = kept_[static_cast<std::size_t>(c)];
  add(free_, x, v, t, a);
}

template <class S>
void SceneAcceleration<S>::many(const S* x, const S* v, const S& t, S* a, std::size_t count) {
  for (std::size_t l = 0; l < count; ++l) a[l] = S(0);
  for (const int i : free_) {
    const int tape = tape_of_[static_cast<std::size_t>(i)];
    std::size_t l = 0;
    if (tape >= 0)
      for (S push[kTapeLanes]; l + kTapeLanes <= count; l += kTapeLanes) {
        tapes_[static_cast<std::size_t>(tape)].lanes(x + l, v + l, t, push);
        for (std::size_t k = 0; k < kTapeLanes; ++k) a[l + k] = a[l + k] + push[k];
      }
    for (; l < count; ++l) {
      if (tape < 0) {
        terms_[static_cast<std::size_t>(i)].add(x + l, v + l, t, a + l);
        continue;
      }
      tapes_[static_cast<std::size_t>(tape)](x + l, v + l, t, 1, extra_.data());
      a[l] = a[l] + extra_[0];
    }
  }
}

template class TapeValues<float>;
template class TapeValues<double>;
template class TapeValues<DoubleDouble>;
template class SceneAcceleration<float>;
template class SceneAcceleration<double>;
template class SceneAcceleration<DoubleDouble>;

}  // namespace shortfall
