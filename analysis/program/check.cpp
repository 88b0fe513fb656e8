// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/check.hpp"

#include <algorithm>

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr Type kScalar(Dimension d) { return {Sort::scalar, d}; }
constexpr Type kVector(Dimension d) { return {Sort::vector, d}; }

class Checker {
 public:
  Checker(const Program& program, const Source& source) : program_(program), source_(source) {}

  void check_all() {
    check_parameters();
    if (program_.tableau) check_tableau(*program_.tableau);
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
        throw source_.error(state.place,
                            "state '" + state.name + "' has no first value: assign it in a start block");
      names.known[state.name].assigned = true;
    }
    leave_hints(names, at_start, "start");
    Names at_step = names;
    moves_x_ = false;
    check_statements(program_.step, at_step);
    if (!moves_x_)
      throw source_.error(program_.step.empty() ? Place{1, 1} : program_.step.front().place,
                          "the step never assigns x: the body would not move");
    leave_hints(names, at_step, "step");
    check_statements(program_.finish, names);
    for (const Claim& claim : program_.claims) check_claim(claim);
  }

 private:
  Names with_parameters() const {
    Names names;
    for (const Parameter& p : program_.parameters) names.declare(p.name, kScalar(p.dimension));
    return names;
  }

  /// What the blocks below a block say of its locals.
  static void leave_hints(Names& names, const Names& after, const std::string& block) {
    for (const auto& [name, entry] : after.known)
      if (!names.known.contains(name))
        names.hints[name] = "'" + name + "' is a local of the " + block + " block" +
                            (entry.type.sort == Sort::vector ? "; what is kept is declared: state " + name +
                                                                   " : " + entry.type.dimension.str()
                                                             : "");
  }

  void refuse_taken(const Names& names, const std::string& name, Place place) const {
    if (name == "a" || name == "n" || is_of_formulas(name))
      throw source_.error(place, "'" + name + "' has a meaning of its own; choose another name");
    if (names.known.contains(name)) throw source_.error(place, "the name '" + name + "' is already taken");
  }

  /// Whether a formula about n steps knows the name already.
  static bool is_of_formulas(const std::string& name) {
    static const std::set<std::string> words{"x", "v", "h", "t", "x0", "v0"};
    return words.contains(name) || (name.size() > 1 && name[0] == 'f' &&
                                    name.find_first_not_of("0123456789", 1) == std::string::npos);
  }

  void check_parameters() const {
    Names names;
    names.force = false;
    names.allowed = "; a default may use numbers and the parameters declared above it";
    for (const Parameter& p : program_.parameters) {
      if (is_of_formulas(p.name))
        throw source_.error(p.place, "'" + p.name + "' has a meaning of its own; choose another name");
      refuse_taken(names, p.name, p.place);
      const Judgement fallback = judged(p.fallback, names, source_);
      // A plain number takes the declared dimension: `param c : 1/T = 0.5`.
      const bool bare = fallback.type.same_as(kScalar(kPure)) && names_in(p.fallback) == 0;
      if (!bare && !fallback.type.same_as(kScalar(p.dimension)))
        throw source_.error(beginning(p.fallback), "parameter '" + p.name + "' is a " +
                                                       kScalar(p.dimension).str() + ", its default is a " +
                                                       fallback.type.str());
      names.known[p.name] = {kScalar(p.dimension), true, 1, fallback.value};
    }
  }

  void check_tableau(const Tableau& tableau) const {
    Names names = with_parameters();
    names.force = false;
    names.allowed = "; an entry of a tableau is made of numbers and parameters";
    const auto check_row = [&](const std::vector<Expr>& row) {
      for (const Expr& entry : row) {
        const Type type = type_of(entry, names, source_);
        if (type.dimension != kPure)
          throw source_.error(beginning(entry),
                              "an entry of a tableau has no dimension; found " + type.str());
      }
    };
    check_row(tableau.c);
    for (const auto& row : tableau.a) check_row(row);
    check_row(tableau.b);
    check_row(tableau.embedded);
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
        assign(s, names);
      } else if (s.kind == Statement::Kind::solve) {
        check_solve(s, names);
      } else {
        check_count(s.value, names);
        check_statements(s.body, names);
      }
    }
  }

  void refuse_unassignable(const std::string& name, Place place) const {
    const char* why = nullptr;
    if (name == "h") why = "; it is the length of the step";
    if (name == "t") why = "; t advances by h when the step ends";
    if (name == "a") why = "; it is the force, a(x, v, t)";
    if (name == "n") why = "; it is the number of steps";
    if (program_.parameter(name)) why = "; it is a parameter";
    if (why) throw source_.error(place, "'" + name + "' cannot be assigned" + why);
  }

  void assign(const Statement& s, Names& names) {
    refuse_unassignable(s.name, s.place);
    Judgement value = judged(s.value, names, source_);
    if (s.name == "x") moves_x_ = true;
    const auto found = names.known.find(s.name);
    if (found != names.known.end() && !value.type.zero && !value.type.same_as(found->second.type))
      throw source_.error(s.place, "'" + s.name + "' is a " + found->second.type.str() +
                                       ", but is assigned a " + value.type.str());
    if (found != names.known.end()) value.type = found->second.type;
    value.type.zero = false;
    names.known[s.name] = {value.type, true, std::max(1, value.growth), {}};
  }

  void check_solve(const Statement& s, Names& names) {
    Names inside = names;
    for (const Unknown& u : s.unknowns) {
      if (inside.known.contains(u.name) || u.name == "a" || u.name == "n")
        throw source_.error(u.place,
                            "the name '" + u.name + "' is already taken; an unknown needs a new one");
      inside.declare(u.name, kVector(u.dimension));
    }
    for (const Unknown& u : s.unknowns) {
      const Type type = type_of(u.value, inside, source_);
      if (!type.zero && !type.same_as(kVector(u.dimension)))
        throw source_.error(u.place, "unknown '" + u.name + "' is declared a " + kVector(u.dimension).str() +
                                         ", but equals a " + type.str());
    }
    for (const Unknown& u : s.unknowns) names.declare(u.name, kVector(u.dimension));
  }

  void check_count(const Expr& count, const Names& names) const {
    std::int64_t value = 0;
    if (count->op == Op::number && count->value.fits_int64(value) && value >= 1 && value <= 10'000) return;
    const bool is_parameter = count->op == Op::name && program_.parameter(count->name);
    if (!is_parameter)
      throw source_.error(
          beginning(count),
          "substeps takes a whole number from 1 to 10000 or a parameter" +
              (count->op == Op::name ? "; '" + count->name + "' is no parameter" : std::string()));
    if (type_of(count, names, source_).dimension != kPure)
      throw source_.error(count->place, "a number of substeps has no dimension");
  }

  void check_claim(const Claim& claim) const {
    if (claim.word == "exact") {
      std::int64_t degree = -1;
      if (claim.value->op != Op::number || !claim.value->value.fits_int64(degree) || degree > 1000)
        throw source_.error(beginning(claim.value),
                            "exact takes the degree of a polynomial, a whole number from 0 to 1000");
      return;
    }
    Names names = formula_names(program_, 0);
    names.allowed = "; a claim may use a, x0, v0, h, n, t and the parameters";
    const Type type = type_of(claim.value, names, source_);
    const Type wanted = kVector(claim.word == "shortfall" ? kLength : kVelocity);
    if (!type.zero && !type.same_as(wanted))
      throw source_.error(beginning(claim.value),
                          "a " + claim.word + " is a " + wanted.str() + ", found a " + type.str());
  }

  const Program& program_;
  const Source& source_;
  bool moves_x_ = false;
};

}  // namespace

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
