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
    check_constants();
    if (program_.tableau) check_tableau(*program_.tableau);
    if (program_.splitting) check_splitting(*program_.splitting);
    check_assumptions();
    check_equation();
    Names names = with_parameters();
    names.functions = Functions::of_programs;
    names.declare("h", kScalar(kTime));
    names.declare("t", kScalar(kTime));
    names.declare("x", kVector(kLength));
    names.declare("v", kVector(kVelocity));
    for (const State& state : program_.states) {
      refuse_taken(names, state.name, state.place);
      names.declare(state.name, kVector(state.dimension), false);
    }
    if (program_.impulse) {
      const State& impulse = *program_.impulse;
      refuse_taken(names, impulse.name, impulse.place);
      names.hints[impulse.name] = "the impulse '" + impulse.name + "' acts in the step block only";
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
    if (program_.impulse) at_step.declare(program_.impulse->name, kVector(kVelocity));
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
    for (const Root& r : program_.roots) names.declare(r.name, kScalar(kPure));
    for (const Approximation& a : program_.approximations) names.declare(a.name, kScalar(kPure));
    return names;
  }

  /// Roots and approximate coefficients: names of their own.
  void check_constants() const {
    Names taken;
    for (const Parameter& p : program_.parameters) taken.declare(p.name, kScalar(p.dimension));
    const auto add = [&](const std::string& name, Place place) {
      refuse_taken(taken, name, place);
      taken.declare(name, kScalar(kPure));
    };
    for (const Root& r : program_.roots) add(r.name, r.place);
    for (const Approximation& a : program_.approximations) add(a.name, a.place);
  }

  void check_splitting(const Splitting& splitting) const {
    Names names = of_coefficients("; a weight is made of numbers, parameters and roots");
    for (const Splitting::Part& part : splitting.parts) check_coefficient(part.weight, names, "a weight");
  }

  /// What the entries of tableaus and splittings may use.
  Names of_coefficients(const std::string& allowed) const {
    Names names = with_parameters();
    names.force = false;
    names.functions = Functions::of_programs;
    names.allowed = allowed;
    return names;
  }

  void check_coefficient(const Expr& entry, const Names& names, const std::string& what) const {
    const Type type = type_of(entry, names, source_);
    if (type.dimension != kPure)
      throw source_.error(beginning(entry), what + " has no dimension; found " + type.str());
  }

  void check_assumptions() const {
    Names names = of_coefficients("; an assumption may use numbers, h and the parameters");
    names.declare("h", kScalar(kTime));
    for (const Assumption& a : program_.assumptions) {
      const Type left = type_of(a.left, names, source_);
      const Type right = type_of(a.right, names, source_);
      if (!left.zero && !right.zero && !left.same_as(right))
        throw source_.error(
            a.place, "an assumption compares like with like, not " + left.str() + " with " + right.str());
    }
  }

  void check_equation() const {
    if (!program_.solves) return;
    Names names = with_parameters();
    names.functions = Functions::all;
    names.allowed = "; the equation may use a(x, v, t), x, v, t and the parameters";
    names.declare("x", kVector(kLength));
    names.declare("v", kVector(kVelocity));
    names.declare("t", kScalar(kTime));
    const Type type = type_of(program_.solves, names, source_);
    if (!type.zero && !type.same_as(kVector(kAcceleration)))
      throw source_.error(beginning(program_.solves),
                          "the equation is a " + kVector(kAcceleration).str() + ", found a " + type.str());
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
    const Names names = of_coefficients("; an entry of a tableau is made of numbers and parameters");
    const auto check_row = [&](const std::vector<Expr>& row) {
      for (const Expr& entry : row) check_coefficient(entry, names, "an entry of a tableau");
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
      switch (s.kind) {
        case Statement::Kind::assign:
          assign(s, names);
          break;
        case Statement::Kind::solve:
          check_solve(s, names);
          break;
        case Statement::Kind::substeps:
          check_count(s.value, names);
          check_statements(s.body, names);
          break;
        case Statement::Kind::limit_speed:
        case Statement::Kind::limit_move:
          check_limit(s, names);
          break;
        case Statement::Kind::when: {
          check_limit(s, names);
          Names inside = names;
          check_statements(s.body, inside);
          for (const auto& [name, entry] : inside.known)
            if (!names.known.contains(name))
              names.hints[name] = "'" + name + "' is assigned within when only; assign it before as well";
          break;
        }
      }
    }
  }

  /// A bare number is one in m/s or m.
  void check_limit(const Statement& s, const Names& names) const {
    const bool length = s.kind == Statement::Kind::limit_move;
    const Judgement size = judged(s.value, names, source_);
    const Type wanted = kScalar(length ? kLength : kVelocity);
    if (size.value && size.value->sign() <= 0)
      throw source_.error(beginning(s.value),
                          std::string("a ") + (length ? "length" : "speed") + " above 0 is expected here");
    if (!size.value && !size.type.same_as(wanted))
      throw source_.error(beginning(s.value), "expected a " + wanted.str() + ", found a " + size.type.str());
  }

  void refuse_unassignable(const std::string& name, Place place) const {
    const char* why = nullptr;
    if (name == "h") why = "; it is the length of the step";
    if (name == "t") why = "; t advances by h when the step ends";
    if (name == "a") why = "; it is the force, a(x, v, t)";
    if (name == "n") why = "; it is the number of steps";
    if (program_.parameter(name)) why = "; it is a parameter";
    if (program_.impulse && program_.impulse->name == name) why = "; it is the impulse";
    if (std::ranges::find(program_.roots, name, &Root::name) != program_.roots.end()) why = "; it is a root";
    if (std::ranges::find(program_.approximations, name, &Approximation::name) !=
        program_.approximations.end())
      why = "; it is a coefficient";
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

  void check_order_claim(const Claim& claim) const {
    constexpr int kHighest = 20;  // more trees than fit into any memory
    std::int64_t order = -1;
    if (!claim.value->value.fits_int64(order) || order < 0 || order > kHighest)
      throw source_.error(claim.value->place,
                          "an order is a whole number from 0 to " + std::to_string(kHighest));
    if (claim.word == "embedded-order" && (!program_.tableau || program_.tableau->embedded.empty()))
      throw source_.error(claim.place,
                          "an embedded order is that of a tableau's embedded row; there is none");
  }

  void check_claim(const Claim& claim) const {
    if (claim.word == "symplectic" || claim.word == "symmetric") return;
    if (claim.word == "order" || claim.word == "embedded-order") return check_order_claim(claim);
    if (claim.word == "exact") {
      std::int64_t degree = -1;
      if (claim.value->op != Op::number || !claim.value->value.fits_int64(degree) || degree > 1000)
        throw source_.error(beginning(claim.value),
                            "exact takes the degree of a polynomial, a whole number from 0 to 1000");
      return;
    }
    if (claim.word == "trace" || claim.word == "determinant" || claim.word == "limit")
      return check_stability_claim(claim);
    Names names = formula_names(program_, 0);
    names.allowed = "; a claim may use a, x0, v0, h, n, t and the parameters";
    const Type type = type_of(claim.value, names, source_);
    const Type wanted = kVector(claim.word == "shortfall" ? kLength : kVelocity);
    if (!type.zero && !type.same_as(wanted))
      throw source_.error(beginning(claim.value),
                          "a " + claim.word + " is a " + wanted.str() + ", found a " + type.str());
  }

  void check_stability_claim(const Claim& claim) const {
    Names names = with_parameters();
    names.force = false;
    names.functions = Functions::all;
    if (claim.word == "limit") {
      names.declare("infinity", kScalar(kPure));
      names.allowed = "; a limit is a number, such as 2 or 2*sqrt(2), or infinity";
    } else {
      names.declare("h", kScalar(kTime));
      names.declare("w", kScalar({0, -1}));
      names.declare("z", kScalar(kPure));
      names.allowed = "; a " + claim.word + " may use h, w, z (= h*w) and the parameters";
    }
    const Type type = type_of(claim.value, names, source_);
    if (!type.zero && !type.same_as(kScalar(kPure)))
      throw source_.error(beginning(claim.value),
                          "a " + claim.word + " is a " + kScalar(kPure).str() + ", found a " + type.str());
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
  for (const Root& r : program.roots) names.declare(r.name, kScalar(kPure));
  for (const Approximation& a : program.approximations) names.declare(a.name, kScalar(kPure));
  names.functions = Functions::of_programs;
  return names;
}

}  // namespace shortfall
