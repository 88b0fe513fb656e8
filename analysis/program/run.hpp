// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/function.hpp"
#include "analysis/program/quickened.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// Runs a tape, unchanged, in any problem.
///
/// A problem says what the values are and what the force is. It has types Scalar and Vector with the usual
/// operators and
///   Scalar number(const Rational&)
///   std::optional<Scalar> parameter(int index, bool derived)
///   Vector zero()
///   Vector acceleration(const Vector& x, const Vector& v, const Scalar& t)
///   void solve(std::vector<Vector>& unknowns, F&& f)
///   Scalar function(Function, const Scalar& a, const Scalar& b)
///   Scalar root(const RealRoot&, const std::string& name)
///   bool longer(const Vector& measured, const Scalar& size, bool assumed)
///   Vector shortened(const Vector& v, const Vector& measured, const Scalar& size)
/// where the unknowns of `solve` hold a first guess, then satisfy unknowns = f(unknowns); `longer` compares a
/// length with a size, and returns what is assumed where lengths have no values (a problem that can use the
/// head's assumptions has assume(Scalar positive, std::string) too); `shortened` is v scaled by size over the
/// length of what is measured.
///
/// A type of values may offer results in place: set_sum(out, a, b), set_difference, set_product, set_quotient
/// and set_negative(out, a), where `out` may be an operand; they are then used instead of the operators. A
/// problem may offer accelerate(out, x, v, t) beside `acceleration`, and reads_time(): where it says no, t
/// stands still. Values that are plain memory run quickened instructions (quickened.hpp), bit for bit the
/// same.
template <class Problem>
class Run {
 public:
  using Scalar = typename Problem::Scalar;
  using Vector = typename Problem::Vector;

  Run(const Tape& tape, Problem& problem, Scalar h)
      : tape_(tape),
        problem_(problem),
        scalars_(tape.scalar_registers),
        vectors_(tape.vector_registers, problem.zero()) {
    scalars_[Tape::kStep] = std::move(h);
    scalars_[Tape::kTimeRegister] = problem_.number(0);
    for (const Rational& n : tape.numbers) numbers_.push_back(problem_.number(n));
    for (std::size_t i = 0; i < tape.parameters.size(); ++i) {
      const Tape::ParameterSlot& p = tape.parameters[i];
      std::optional<Scalar> value;
      if (p.fixed)
        value = problem_.number(*p.fixed);
      else
        value = problem_.parameter(static_cast<int>(i), p.derived);
      if (value)
        scalars_[2 + i] = std::move(*value);
      else
        execute(p.fallback);
    }
    execute(tape.constants);
    if constexpr (kQuick) {
      quick_step_ = quickened(tape.step);
      for (const Tape::Repeat& r : tape.repeats) quick_repeats_.push_back(quickened(r.body));
    }
    if constexpr (requires(Scalar s) { problem.assume(s, std::string()); })
      for (const Tape::AssumptionSlot& a : tape.assumptions) {
        execute(a.body);
        problem.assume(scalars_[a.positive], a.text);
      }
  }

  /// A `limit` that acted, or a `when` that did not hold: closed forms take it that neither happens.
  struct Deviation {
    std::int64_t step = 0;  ///< the first such step, counted from 1
    std::string text;       ///< "limit speed 500"
  };
  const std::optional<Deviation>& deviation() const { return deviation_; }

  /// Gives the body an impulse (divided by its mass), which acts in the next step only.
  ///
  /// throws  BadInput  when the integrator reads none
  void give_impulse(Vector j) {
    if (tape_.impulse < 0) throw BadInput(tape_.name + " knows no impulse");
    vectors_[tape_.impulse] = std::move(j);
  }

  /// Nobody looks.
  struct Unwatched {
    void operator()(const Instruction&, const Vector&) const {}
  };

  /// Puts the body at x0, v0 at a time and runs `start`.
  ///
  /// param   watch  is shown every vector that is made, with the instruction that made it; the inside of a
  /// solve
  ///                is not shown, its unknowns are
  template <class Watch = Unwatched>
  void begin(Vector x0, Vector v0, Scalar t0, const Watch& watch = {}) {
    vectors_[Tape::kPosition] = std::move(x0);
    vectors_[Tape::kVelocityRegister] = std::move(v0);
    scalars_[Tape::kTimeRegister] = std::move(t0);
    if (tape_.impulse >= 0) vectors_[tape_.impulse] = problem_.zero();
    steps_ = 0;
    deviation_.reset();
    execute(tape_.start, watch);
  }

  /// One step; t has advanced by h when it returns.
  template <class Watch = Unwatched>
  void step(const Watch& watch = {}) {
    ++steps_;
    execute(kQuick && kUnwatched<Watch> ? quick_step_ : tape_.step, watch);
    if (tape_.impulse >= 0) vectors_[tape_.impulse] = problem_.zero();
    advance_time();
  }

  /// Position and velocity as `finish` reports them; the state stays as it is.
  template <class Watch = Unwatched>
  std::pair<Vector, Vector> read_out(const Watch& watch = {}) {
    if (tape_.finish.empty()) return {state(0), state(1)};
    const std::vector<Vector> kept(vectors_.begin(),
                                   vectors_.begin() + static_cast<long>(tape_.states.size()));
    execute(tape_.finish, watch);
    std::pair<Vector, Vector> result{state(0), state(1)};
    std::copy(kept.begin(), kept.end(), vectors_.begin());
    return result;
  }

  /// The carried vectors: 0 is x, 1 is v, then the program's own states.
  const Vector& state(int index) const { return vectors_[index]; }
  void set_state(int index, Vector value) { vectors_[index] = std::move(value); }
  const Scalar& time() const { return scalars_[Tape::kTimeRegister]; }
  void set_time(Scalar t) { scalars_[Tape::kTimeRegister] = std::move(t); }
  void set_step(Scalar h) { scalars_[Tape::kStep] = std::move(h); }

 private:
  /// Numbers that fit into registers gain from quickened instructions; for others a copy is not worth it.
  static constexpr bool kQuick = std::is_trivially_copyable_v<Vector>;
  template <class Watch>
  static constexpr bool kUnwatched = std::is_same_v<Watch, Unwatched>;

  template <class Watch = Unwatched>
  void execute(const Block& block, const Watch& watch = {}) {
    for (const Instruction *i = block.data(), *end = i + block.size(); i != end; ++i) {
      execute(*i, watch);
      if constexpr (!kUnwatched<Watch>) show(*i, watch);
      if constexpr (kQuick && kUnwatched<Watch>)
        if (i->kind >= Instruction::Kind::scale_then_add) ++i;  // the next one is done
    }
  }

  template <class Watch>
  void show(const Instruction& i, const Watch& watch) {
    using Kind = Instruction::Kind;
    if (i.kind == Kind::solve)
      for (int unknown : tape_.solves[i.a].unknowns) watch(i, vectors_[unknown]);
    else if (i.kind == Kind::limit)
      watch(i, state(1));
    else if (i.kind >= Kind::zero && i.kind <= Kind::force)
      watch(i, vectors_[i.out]);
  }

  void advance_time() {
    if constexpr (requires { problem_.reads_time(); })
      if (!problem_.reads_time()) return;
    Scalar& t = scalars_[Tape::kTimeRegister];
    put_sum(t, t, scalars_[Tape::kStep]);
  }

  // Results in place where the values offer that; a new value otherwise.
  template <class T>
  static void put_sum(T& out, const T& a, const T& b) {
    if constexpr (requires { set_sum(out, a, b); })
      set_sum(out, a, b);
    else
      out = a + b;
  }
  template <class T>
  static void put_difference(T& out, const T& a, const T& b) {
    if constexpr (requires { set_difference(out, a, b); })
      set_difference(out, a, b);
    else
      out = a - b;
  }
  template <class T, class A>
  static void put_product(T& out, const A& a, const T& b) {
    if constexpr (requires { set_product(out, a, b); })
      set_product(out, a, b);
    else
      out = a * b;
  }
  template <class T, class B>
  static void put_quotient(T& out, const T& a, const B& b) {
    if constexpr (requires { set_quotient(out, a, b); })
      set_quotient(out, a, b);
    else
      out = a / b;
  }
  template <class T>
  static void put_negative(T& out, const T& a) {
    if constexpr (requires { set_negative(out, a); })
      set_negative(out, a);
    else
      out = -a;
  }

  template <class Watch>
  void execute(const Instruction& i, const Watch& watch) {
    using Kind = Instruction::Kind;
    auto& s = scalars_;
    auto& v = vectors_;
    switch (i.kind) {
      case Kind::number:
        s[i.out] = numbers_[i.a];
        break;
      case Kind::scalar_copy:
        s[i.out] = s[i.a];
        break;
      case Kind::scalar_negate:
        put_negative(s[i.out], s[i.a]);
        break;
      case Kind::scalar_add:
        put_sum(s[i.out], s[i.a], s[i.b]);
        break;
      case Kind::scalar_subtract:
        put_difference(s[i.out], s[i.a], s[i.b]);
        break;
      case Kind::scalar_multiply:
        put_product(s[i.out], s[i.a], s[i.b]);
        break;
      case Kind::scalar_divide:
        put_quotient(s[i.out], s[i.a], s[i.b]);
        break;
      case Kind::scalar_power:
        s[i.out] = powered(s[i.a], i.b);
        break;
      case Kind::zero:
        v[i.out] = problem_.zero();
        break;
      case Kind::vector_copy:
        v[i.out] = v[i.a];
        break;
      case Kind::vector_negate:
        put_negative(v[i.out], v[i.a]);
        break;
      case Kind::vector_add:
        put_sum(v[i.out], v[i.a], v[i.b]);
        break;
      case Kind::vector_subtract:
        put_difference(v[i.out], v[i.a], v[i.b]);
        break;
      case Kind::scale:
        put_product(v[i.out], s[i.a], v[i.b]);
        break;
      case Kind::vector_divide:
        put_quotient(v[i.out], v[i.a], s[i.b]);
        break;
      case Kind::force:
        if constexpr (requires { problem_.accelerate(v[i.out], v[i.a], v[i.b], s[i.c]); })
          problem_.accelerate(v[i.out], v[i.a], v[i.b], s[i.c]);
        else
          v[i.out] = problem_.acceleration(v[i.a], v[i.b], s[i.c]);
        break;
      case Kind::solve:
        solve(tape_.solves[i.a]);
        break;
      case Kind::repeat:
        repeat(static_cast<std::size_t>(i.a), watch);
        break;
      case Kind::function:
        s[i.out] = problem_.function(static_cast<Function>(i.c), s[i.a], s[i.b]);
        break;
      case Kind::root:
        s[i.out] = problem_.root(*tape_.roots[i.a], tape_.root_names[i.a]);
        break;
      case Kind::limit:
        limit(tape_.limits[i.a]);
        break;
      case Kind::when:
        when(tape_.whens[i.a], watch);
        break;
      case Kind::scale_then_add:
      case Kind::scale_then_added:
      case Kind::scale_then_subtract:
        if constexpr (kQuick) scale_and_next(i, (&i)[1]);
        break;
    }
  }

  /// The product stays in a register for the sum that waits for it.
  void scale_and_next(const Instruction& i, const Instruction& next) {
    using Kind = Instruction::Kind;
    auto& v = vectors_;
    const Vector product = scalars_[i.a] * v[i.b];
    v[i.out] = product;
    if (i.kind == Kind::scale_then_add)
      v[next.out] = v[next.a] + product;
    else if (i.kind == Kind::scale_then_added)
      v[next.out] = product + v[next.b];
    else
      v[next.out] = v[next.a] - product;
  }

  /// By multiplications from the left, ((h*h)*h)*h, as the writers of code print it; a negative exponent
  /// divides 1 at the end.
  Scalar powered(const Scalar& base, int exponent) {
    if (exponent == 0) return problem_.number(1);
    Scalar result = base;
    for (int k = 1; k < std::abs(exponent); ++k) result = result * base;
    return exponent > 0 ? result : problem_.number(1) / result;
  }

  void solve(const Tape::Solve& solve) {
    std::vector<Vector> unknowns;
    for (const Dimension& d : solve.dimensions)  // a position begins at x, a velocity at v
      unknowns.push_back(d == kLength ? state(0) : d == kVelocity ? state(1) : problem_.zero());
    problem_.solve(unknowns, [&](const std::vector<Vector>& guess) {
      for (std::size_t k = 0; k < guess.size(); ++k) vectors_[solve.unknowns[k]] = guess[k];
      execute(solve.body);
      std::vector<Vector> values;
      for (int result : solve.results) values.push_back(vectors_[result]);
      return values;
    });
    for (std::size_t k = 0; k < unknowns.size(); ++k) vectors_[solve.unknowns[k]] = std::move(unknowns[k]);
  }

  template <class Watch>
  void repeat(std::size_t which, const Watch& watch) {
    const Tape::Repeat& repeat = tape_.repeats[which];
    const Block& body = kQuick && kUnwatched<Watch> ? quick_repeats_[which] : repeat.body;
    const Scalar h = scalars_[Tape::kStep];
    const Scalar t = scalars_[Tape::kTimeRegister];
    scalars_[Tape::kStep] = h / problem_.number(repeat.count);
    for (int k = 0; k < repeat.count; ++k) {
      execute(body, watch);
      if (repeat.whole_steps && tape_.impulse >= 0) vectors_[tape_.impulse] = problem_.zero();
      advance_time();
    }
    scalars_[Tape::kStep] = h;
    scalars_[Tape::kTimeRegister] = t;
  }

  void limit(const Tape::Limit& limit) {
    Vector& v = vectors_[Tape::kVelocityRegister];
    const Scalar& size = scalars_[limit.size];
    if (!limit.move) {
      if (!problem_.longer(v, size, false)) return;
      v = problem_.shortened(v, v, size);
    } else {
      const Vector move = scalars_[Tape::kStep] * v;
      if (!problem_.longer(move, size, false)) return;
      v = problem_.shortened(v, move, size);
    }
    deviate(limit.text);
  }

  template <class Watch>
  void when(const Tape::When& when, const Watch& watch) {
    if (problem_.longer(vectors_[Tape::kVelocityRegister], scalars_[when.speed], true))
      execute(when.body, watch);
    else
      deviate(when.text);
  }

  void deviate(const std::string& text) {
    if (!deviation_) deviation_ = Deviation{steps_, text};
  }

  const Tape& tape_;
  Problem& problem_;
  std::int64_t steps_ = 0;
  std::optional<Deviation> deviation_;
  Block quick_step_;
  std::vector<Block> quick_repeats_;
  std::vector<Scalar> numbers_;
  std::vector<Scalar> scalars_;
  std::vector<Vector> vectors_;
};

}  // namespace shortfall
