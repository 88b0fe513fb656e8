// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/check.hpp"

#include "analysis/program/suggest.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr Type kScalar(Dimension d) { return {Sort::scalar, d}; }
constexpr Type kVector(Dimension d) { return {Sort::vector, d}; }

class Typing {
 public:
  Typing(const Names& names, const Source& source) : names_(names), source_(source) {}

  Type of(const Expr& e) const {
    switch (e->op) {
      case Op::number: return {Sort::scalar, kPure, e->value.is_zero()};
      case Op::name: return of_name(e);
      case Op::negate: return of(e->operands[0]);
      case Op::add:
      case Op::subtract: return of_sum(e);
      case Op::multiply: return of_product(e);
      case Op::divide: return of_quotient(e);
      case Op::power: return of_power(e);
      case Op::force: return of_force(e);
      case Op::sum: break;
    }
    throw source_.error(e->place, "a sum cannot stand here");
  }

 private:
  Type of_name(const Expr& e) const {
    const auto found = names_.known.find(e->name);
    if (found != names_.known.end()) {
      if (!found->second.assigned) throw source_.error(e->place, "'" + e->name + "' is used before it is assigned");
      return found->second.type;
    }
    if (names_.later.contains(e->name)) throw source_.error(e->place, "'" + e->name + "' is used before it is assigned");
    if (e->name == "a" && names_.force)
      throw source_.error(e->place, "a is the force: write a(x, v, t), the acceleration at a position, velocity and time");
    std::vector<std::string> candidates;
    for (const auto& [name, entry] : names_.known)
      if (entry.assigned) candidates.push_back(name);
    if (names_.force) candidates.push_back("a(x, v, t)");
    throw source_.error(e->place, "unknown name '" + e->name + "'" + did_you_mean(e->name, candidates));
  }

  Type of_sum(const Expr& e) const {
    const Type left = of(e->operands[0]);
    const Type right = of(e->operands[1]);
    if (left.zero) return right;
    if (right.zero || left.same_as(right)) return left;
    if (e->op == Op::add)
      throw source_.error(e->place, "cannot add " + left.str() + " and " + right.str());
    throw source_.error(e->place, "cannot subtract " + right.str() + " from " + left.str());
  }

  Type of_product(const Expr& e) const {
    const Type left = of(e->operands[0]);
    const Type right = of(e->operands[1]);
    if (left.sort == Sort::vector && right.sort == Sort::vector)
      throw source_.error(e->place, "cannot multiply two vectors, " + left.str() + " and " + right.str());
    const Sort sort = left.sort == Sort::vector || right.sort == Sort::vector ? Sort::vector : Sort::scalar;
    return {sort, left.dimension * right.dimension, left.zero || right.zero};
  }

  Type of_quotient(const Expr& e) const {
    const Type left = of(e->operands[0]);
    const Type right = of(e->operands[1]);
    if (right.zero) throw source_.error(e->place, "division by zero");
    if (right.sort == Sort::vector)
      throw source_.error(e->place, "cannot divide by a vector, " + right.str());
    return {left.sort, left.dimension / right.dimension, left.zero};
  }

  Type of_power(const Expr& e) const {
    const Type base = of(e->operands[0]);
    if (base.sort == Sort::vector) throw source_.error(e->place, "a vector has no powers");
    const Expr& exponent = e->operands[1];
    std::int64_t value = 0;
    const bool minus = exponent->op == Op::negate;
    const Expr& digits = minus ? exponent->operands[0] : exponent;
    if (digits->op == Op::number && digits->value.fits_int64(value) && value <= 1000) {
      if (minus && base.zero) throw source_.error(e->place, "division by zero: a negative power of 0");
      return kScalar(base.dimension.pow(static_cast<int>(minus ? -value : value)));
    }
    if (names_.symbolic_powers && base.dimension == kPure && of(exponent).same_as(kScalar(kPure))) return base;
    throw source_.error(exponent->place, "an exponent is a whole number of at most 1000");
  }

  Type of_force(const Expr& e) const {
    if (!names_.force) throw source_.error(e->place, "the force cannot be called here");
    static const Type wanted[] = {kVector(kLength), kVector(kVelocity), kScalar(kTime)};
    static const char* const what[] = {"position", "velocity", "time"};
    for (int i = 0; i < 3; ++i) {
      const Type given = of(e->operands[i]);
      if (!given.zero && !given.same_as(wanted[i]))
        throw source_.error(e->operands[i]->place, std::string("a takes a ") + what[i] + " here, " + wanted[i].str() +
                                                       "; found " + given.str());
    }
    return kVector(kAcceleration);
  }

  const Names& names_;
  const Source& source_;
};

class Checker {
 public:
  Checker(const Program& program, const Source& source) : program_(program), source_(source) {}

  void check_all() {
    check_parameters();
    Names names = with_parameters();
    names.declare("h", kScalar(kTime));
    names.declare("t", kScalar(kTime));
    names.declare("x", kVector(kLength));
    names.declare("v", kVector(kVelocity));
    for (const State& state : program_.states) {
      refuse_taken(names, state.name, state.place);
      names.declare(state.name, kVector(state.dimension), false);
    }
    Names at_start = names;
    check_statements(program_.start, at_start);
    for (const State& state : program_.states) {
      if (!at_start.known[state.name].assigned)
        throw source_.error(state.place, "state '" + state.name + "' has no first value: assign it in a start block");
      names.known[state.name].assigned = true;
    }
    Names at_step = names;
    moves_x_ = false;
    check_statements(program_.step, at_step);
    if (!moves_x_)
      throw source_.error(program_.step.empty() ? Place{1, 1} : program_.step.front().place,
                          "the step never assigns x: the body would not move");
    check_statements(program_.finish, names);
    for (const Claim& claim : program_.claims) check_claim(claim);
  }

 private:
  Names with_parameters() const {
    Names names;
    for (const Parameter& p : program_.parameters) names.declare(p.name, kScalar(p.dimension));
    return names;
  }

  void refuse_taken(const Names& names, const std::string& name, Place place) const {
    if (name == "a" || name == "n") throw source_.error(place, "'" + name + "' has a meaning of its own; choose another name");
    if (names.known.contains(name)) throw source_.error(place, "the name '" + name + "' is already taken");
  }

  void check_parameters() const {
    Names names;
    names.force = false;
    for (const Parameter& p : program_.parameters) {
      if (p.name == "x" || p.name == "v" || p.name == "h" || p.name == "t" || p.name == "x0" || p.name == "v0")
        throw source_.error(p.place, "'" + p.name + "' has a meaning of its own; choose another name");
      refuse_taken(names, p.name, p.place);
      const Type type = Typing(names, source_).of(p.fallback);
      // A plain number takes the declared dimension: `param c : 1/T = 0.5`.
      const bool bare = type.same_as(kScalar(kPure)) && names_in(p.fallback) == 0;
      if (!bare && !type.same_as(kScalar(p.dimension)))
        throw source_.error(p.fallback->place, "parameter '" + p.name + "' is a scalar " + p.dimension.bracketed() +
                                                   ", its default is a " + type.str());
      names.declare(p.name, kScalar(p.dimension));
    }
  }

  static int names_in(const Expr& e) {
    int count = e->op == Op::name ? 1 : 0;
    for (const Expr& operand : e->operands) count += names_in(operand);
    return count;
  }

  void check_statements(const std::vector<Statement>& statements, Names& names) {
    for (const Statement& s : statements)
      if (s.kind == Statement::Kind::assign) names.later.insert(s.name);
    for (const Statement& s : statements) {
      if (s.kind == Statement::Kind::assign) {
        assign(s.name, s.place, Typing(names, source_).of(s.value), names);
      } else if (s.kind == Statement::Kind::solve) {
        check_solve(s, names);
      } else {
        check_count(s.value, names);
        check_statements(s.body, names);
      }
    }
  }

  void assign(const std::string& name, Place place, Type type, Names& names) {
    if (name == "h" || name == "t" || name == "a" || name == "n" || program_.parameter(name))
      throw source_.error(place, "'" + name + "' cannot be assigned" +
                                     (name == "t" ? "; t advances by h when the step ends" : ""));
    if (name == "x") moves_x_ = true;
    auto found = names.known.find(name);
    if (found == names.known.end()) {
      type.zero = false;
      names.declare(name, type);
      return;
    }
    if (!type.zero && !type.same_as(found->second.type))
      throw source_.error(place, "'" + name + "' is a " + found->second.type.str() + ", but is assigned a " + type.str());
    found->second.assigned = true;
  }

  void check_solve(const Statement& s, Names& names) {
    Names inside = names;
    for (const Unknown& u : s.unknowns) {
      if (inside.known.contains(u.name) || u.name == "a" || u.name == "n")
        throw source_.error(u.place, "the name '" + u.name + "' is already taken; an unknown needs a new one");
      inside.declare(u.name, kVector(u.dimension));
    }
    for (const Unknown& u : s.unknowns) {
      const Type type = Typing(inside, source_).of(u.value);
      if (!type.zero && !type.same_as(kVector(u.dimension)))
        throw source_.error(u.place, "unknown '" + u.name + "' is a vector " + u.dimension.bracketed() +
                                         ", but equals a " + type.str());
    }
    for (const Unknown& u : s.unknowns) names.declare(u.name, kVector(u.dimension));
  }

  void check_count(const Expr& count, const Names& names) const {
    std::int64_t value = 0;
    if (count->op == Op::number && count->value.fits_int64(value) && value >= 1 && value <= 10'000) return;
    if (count->op == Op::name && program_.parameter(count->name)) {
      if (Typing(names, source_).of(count).dimension != kPure)
        throw source_.error(count->place, "a number of substeps has no dimension");
      return;
    }
    throw source_.error(count->place, "substeps takes a whole number from 1 to 10000 or a parameter");
  }

  void check_claim(const Claim& claim) const {
    if (claim.word == "exact") {
      std::int64_t degree = -1;
      if (claim.value->op != Op::number || !claim.value->value.fits_int64(degree) || degree > 1000)
        throw source_.error(claim.value->place, "exact takes the degree of a polynomial, a whole number from 0 to 1000");
      return;
    }
    Names names = formula_names(program_, 0);
    const Type type = Typing(names, source_).of(claim.value);
    const Type wanted = kVector(claim.word == "shortfall" ? kLength : kVelocity);
    if (!type.zero && !type.same_as(wanted))
      throw source_.error(claim.value->place, claim.word + " is a " + wanted.str() + ", found a " + type.str());
  }

  const Program& program_;
  const Source& source_;
  bool moves_x_ = false;
};

}  // namespace

Type type_of(const Expr& e, const Names& names, const Source& source) { return Typing(names, source).of(e); }

void check(const Program& program, const Source& source) { Checker(program, source).check_all(); }

Names formula_names(const Program& program, int degree) {
  Names names;
  names.force = false;
  names.symbolic_powers = true;
  names.declare("x0", kVector(kLength));
  names.declare("v0", kVector(kVelocity));
  names.declare("h", kScalar(kTime));
  names.declare("t", kScalar(kTime));
  names.declare("n", kScalar(kPure));
  if (degree == 0) names.declare("a", kVector(kAcceleration));
  for (int d = 0; d <= degree; ++d)
    names.declare("f" + std::to_string(d), kVector(kAcceleration / Dimension{0, d}));
  for (const Parameter& p : program.parameters) names.declare(p.name, kScalar(p.dimension));
  return names;
}

}  // namespace shortfall
