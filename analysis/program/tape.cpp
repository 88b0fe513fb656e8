// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tape.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/arithmetic.hpp"
#include "analysis/program/function.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/tape_source.hpp"

namespace shortfall {

using Op = Expression::Op;
using Kind = Instruction::Kind;

namespace {

Rational value_of(const Expr& e, const Values& values);

/// Of what is no sum, product or quotient.
Rational leaf_value(const Expr& e, const Values& values) {
  switch (e->op) {
    case Op::number:
      return e->value;
    case Op::name:
      return values.at(e->name);
    case Op::power: {
      std::int64_t exponent = 0;
      value_of(e->operands[1], values).fits_int64(exponent);
      return value_of(e->operands[0], values).pow(static_cast<int>(exponent));
    }
    default:
      break;
  }
  throw Error("a parameter's default is made of numbers and parameters");
}

Rational value_of(const Expr& e, const Values& values) {
  return arithmetic<Rational>(e, [&](const Expr& leaf) { return leaf_value(leaf, values); });
}

bool mentions_a_name(const Expr& e) {
  return e->op == Op::name || std::ranges::any_of(e->operands, mentions_a_name);
}

void collect_counts(const std::vector<Statement>& block, std::set<std::string>& names) {
  for (const Statement& s : block) {
    if (s.kind != Statement::Kind::substeps) continue;
    if (s.value->op == Op::name) names.insert(s.value->name);
    collect_counts(s.body, names);
  }
}

void collect_names(const Expr& e, std::set<std::string>& names) {
  if (e->op == Op::name) names.insert(e->name);
  for (const Expr& operand : e->operands) collect_names(operand, names);
}

/// The parameters that must be numbers even in symbolic problems: counts of substeps, and what their defaults
/// are made of.
std::set<std::string> needed_as_numbers(const Program& program) {
  std::set<std::string> names;
  collect_counts(program.step, names);
  for (std::size_t i = program.parameters.size(); i-- > 0;)
    if (names.contains(program.parameters[i].name)) collect_names(program.parameters[i].fallback, names);
  return names;
}

class Lowering {
 public:
  Lowering(const Program& program, const Values& given)
      : program_(program), values_(parameter_values(program, given)) {
    tape_.name = program.name;
    scalars_ = {{"h", Tape::kStep}, {"t", Tape::kTimeRegister}};
    tape_.scalar_registers = 2;
    const std::set<std::string> numbers = needed_as_numbers(program);
    tape_.scalar_registers +=
        static_cast<int>(program.parameters.size());  // temporaries of the defaults come after them
    for (const Parameter& p : program.parameters) {
      const int slot = 2 + static_cast<int>(tape_.parameters.size());
      Tape::ParameterSlot parameter{p.name, {}, mentions_a_name(p.fallback), {}};
      if (given.contains(p.name) || numbers.contains(p.name)) parameter.fixed = values_.at(p.name);
      block_ = &parameter.fallback;
      scalar_into(p.fallback, slot);
      scalars_[p.name] = slot;
      tape_.parameters.push_back(std::move(parameter));
    }
    block_ = &tape_.constants;
    for (const Root& r : program.roots) {
      tape_.roots.push_back(r.value);
      tape_.root_names.push_back(r.name);
      scalars_[r.name] = new_scalar();
      emit(Kind::root, scalars_[r.name], static_cast<int>(tape_.roots.size()) - 1);
    }
    for (const Approximation& a : program.approximations) {
      scalars_[a.name] = new_scalar();
      scalar_into(number(a.value), scalars_[a.name]);
    }
    for (const Assumption& a : program.assumptions) {
      Tape::AssumptionSlot slot{{}, new_scalar(), a.str()};
      block_ = &slot.body;
      scalar_into(a.positive(), slot.positive);
      tape_.assumptions.push_back(std::move(slot));
    }
    state("x", kLength);
    state("v", kVelocity);
    for (const State& s : program.states) state(s.name, s.dimension);
    if (program.impulse) tape_.impulse = vectors_[program.impulse->name] = new_vector();
  }

  /// param   source  is told where every instruction comes from, if there is one
  Tape tape(TapeSource* source = nullptr) {
    source_ = source;
    const auto scalars = scalars_;
    const auto vectors = vectors_;
    for (auto [from, to] : {std::pair{&program_.start, &tape_.start},
                            {&program_.step, &tape_.step},
                            {&program_.finish, &tape_.finish}}) {
      scalars_ = scalars;
      vectors_ = vectors;
      block_ = to;
      held_ = -1;
      statement_ = -1;
      if (program_.holds_force && to == &tape_.step) {
        const int out = new_vector();
        emit(Kind::force, out, Tape::kPosition, Tape::kVelocityRegister, Tape::kTimeRegister);
        held_ = out;
      }
      statements(*from);
      close(*to);
    }
    return std::move(tape_);
  }

 private:
  void state(const std::string& name, Dimension dimension) {
    vectors_[name] = tape_.vector_registers++;
    tape_.states.push_back(name);
    tape_.state_dimensions.push_back(dimension);
  }

  void emit(Kind kind, int out, int a = 0, int b = 0, int c = 0) {
    block_->push_back({kind, out, a, b, c});
    // Blocks are moved afterwards, never copied: their instructions stay where they are once all are there.
    if (source_) pending_[block_].push_back(statement_);
  }

  /// All instructions of a block are there.
  void close(const Block& block) {
    if (source_) source_->note(block, std::exchange(pending_[&block], {}));
  }

  bool is_vector(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return false;
      case Op::name:
        return vectors_.contains(e->name);
      case Op::force:
        return true;
      case Op::power:
      case Op::call:
        return false;
      default:
        return std::ranges::any_of(e->operands, [&](const Expr& o) { return is_vector(o); });
    }
  }

  int new_scalar() { return tape_.scalar_registers++; }
  int new_vector() { return tape_.vector_registers++; }

  int scalar(const Expr& e) {
    if (e->op == Op::name) return scalars_.at(e->name);
    const int out = new_scalar();
    scalar_into(e, out);
    return out;
  }

  void scalar_into(const Expr& e, int out) {
    switch (e->op) {
      case Op::number:
        tape_.numbers.push_back(e->value);
        return emit(Kind::number, out, static_cast<int>(tape_.numbers.size()) - 1);
      case Op::name:
        return emit(Kind::scalar_copy, out, scalars_.at(e->name));
      case Op::negate:
        return emit(Kind::scalar_negate, out, scalar(e->operands[0]));
      case Op::power: {
        const int base = scalar(e->operands[0]);
        std::int64_t exponent = 0;
        value_of(e->operands[1], {}).fits_int64(exponent);
        return emit(Kind::scalar_power, out, base, static_cast<int>(exponent));
      }
      case Op::call: {
        const int a = scalar(e->operands[0]);
        const int b = e->operands.size() > 1 ? scalar(e->operands[1]) : a;
        return emit(Kind::function, out, a, b, static_cast<int>(*function_named(e->name)));
      }
      default:
        break;
    }
    static const std::map<Op, Kind> kinds{{Op::add, Kind::scalar_add},
                                          {Op::subtract, Kind::scalar_subtract},
                                          {Op::multiply, Kind::scalar_multiply},
                                          {Op::divide, Kind::scalar_divide}};
    const int a = scalar(e->operands[0]);
    const int b = scalar(e->operands[1]);
    emit(kinds.at(e->op), out, a, b);
  }

  int vector(const Expr& e) {
    if (e->op == Op::name && vectors_.contains(e->name)) return vectors_.at(e->name);
    const int out = new_vector();
    vector_into(e, out);
    return out;
  }

  void vector_into(const Expr& e, int out) {
    if (!is_vector(e)) return emit(Kind::zero, out);  // the checker lets only 0 through
    const auto& o = e->operands;
    switch (e->op) {
      case Op::name:
        return emit(Kind::vector_copy, out, vectors_.at(e->name));
      case Op::negate:
        return emit(Kind::vector_negate, out, vector(o[0]));
      case Op::add:
      case Op::subtract: {
        const int a = vector(o[0]);
        const int b = vector(o[1]);
        return emit(e->op == Op::add ? Kind::vector_add : Kind::vector_subtract, out, a, b);
      }
      case Op::multiply: {
        const bool left = is_vector(o[0]);
        const int factor = scalar(o[left ? 1 : 0]);
        return emit(Kind::scale, out, factor, vector(o[left ? 0 : 1]));
      }
      case Op::divide: {
        const int a = vector(o[0]);
        return emit(Kind::vector_divide, out, a, scalar(o[1]));
      }
      case Op::force: {
        if (held_ >= 0) return emit(Kind::vector_copy, out, held_);
        const int x = vector(o[0]);
        const int v = vector(o[1]);
        return emit(Kind::force, out, x, v, scalar(o[2]));
      }
      default:
        throw Error("not a vector expression");
    }
  }

  void statements(const std::vector<Statement>& block) {
    for (const Statement& s : block) {
      if (source_) statement_ = source_->add(s);
      switch (s.kind) {
        case Statement::Kind::assign:
          assign(s);
          break;
        case Statement::Kind::solve:
          solve(s);
          break;
        case Statement::Kind::substeps:
          repeat(s);
          break;
        case Statement::Kind::limit_speed:
        case Statement::Kind::limit_move:
          limit(s);
          break;
        case Statement::Kind::when:
          when(s);
          break;
      }
    }
  }

  void assign(const Statement& s) {
    const bool known_vector = vectors_.contains(s.name);
    if (known_vector || is_vector(s.value)) {
      // The right-hand side is read before the name changes, so it may be computed straight into its
      // register.
      if (!known_vector) {
        const int out = new_vector();
        vector_into(s.value, out);
        vectors_[s.name] = out;
      } else {
        vector_into(s.value, vectors_.at(s.name));
      }
    } else if (scalars_.contains(s.name)) {
      scalar_into(s.value, scalars_.at(s.name));
    } else {
      const int out = new_scalar();
      scalar_into(s.value, out);
      scalars_[s.name] = out;
    }
  }

  void solve(const Statement& s) {
    Tape::Solve solve;
    for (const Unknown& u : s.unknowns) {
      solve.unknowns.push_back(new_vector());
      solve.dimensions.push_back(u.dimension);
      vectors_[u.name] = solve.unknowns.back();
    }
    Block* outer = block_;
    block_ = &solve.body;
    for (const Unknown& u : s.unknowns) {
      const int out = new_vector();
      vector_into(u.value, out);
      solve.results.push_back(out);
    }
    if (source_) pending_.erase(&solve.body);
    block_ = outer;
    tape_.solves.push_back(std::move(solve));
    emit(Kind::solve, 0, static_cast<int>(tape_.solves.size()) - 1);
  }

  void repeat(const Statement& s) {
    std::int64_t count = 0;
    const Rational value = value_of(s.value, values_);
    if (!value.fits_int64(count) || count < 1 || count > 10'000)
      throw BadInput("a number of substeps is a whole number from 1 to 10000, not " + value.str());
    Tape::Repeat repeat{static_cast<int>(count), s.whole_steps, {}};
    Block* outer = block_;
    block_ = &repeat.body;
    statements(s.body);
    close(repeat.body);
    block_ = outer;
    tape_.repeats.push_back(std::move(repeat));
    emit(Kind::repeat, 0, static_cast<int>(tape_.repeats.size()) - 1);
  }

  void limit(const Statement& s) {
    const bool move = s.kind == Statement::Kind::limit_move;
    tape_.limits.push_back(
        {move, scalar(s.value), (move ? "limit move " : "limit speed ") + print_decimals(s.value)});
    emit(Kind::limit, 0, static_cast<int>(tape_.limits.size()) - 1);
  }

  void when(const Statement& s) {
    Tape::When when{scalar(s.value), {}, "when speed > " + print_decimals(s.value)};
    const auto scalars = scalars_;
    const auto vectors = vectors_;
    Block* outer = block_;
    block_ = &when.body;
    statements(s.body);
    close(when.body);
    block_ = outer;
    scalars_ = scalars;  // names made within are gone after it
    vectors_ = vectors;
    tape_.whens.push_back(std::move(when));
    emit(Kind::when, 0, static_cast<int>(tape_.whens.size()) - 1);
  }

  const Program& program_;
  Values values_;
  Tape tape_;
  int held_ = -1;  ///< register of the force where it is held; -1 where it is evaluated
  std::map<std::string, int> scalars_;
  std::map<std::string, int> vectors_;
  Block* block_ = nullptr;
  TapeSource* source_ = nullptr;
  int statement_ = -1;                                ///< of the source, that is being lowered
  std::map<const Block*, std::vector<int>> pending_;  ///< of blocks that are being made: a statement each
};

}  // namespace

Tape lower(const Program& program, const Values& given) { return Lowering(program, given).tape(); }

std::pair<Tape, TapeSource> lower_with_source(const Program& program, const Values& given) {
  std::pair<Tape, TapeSource> result;
  result.first = Lowering(program, given).tape(&result.second);
  return result;
}

Values parameter_values(const Program& program, const Values& given) {
  std::vector<std::string> names;
  for (const Parameter& p : program.parameters) names.push_back(p.name);
  for (const auto& [name, value] : given)
    if (!program.parameter(name))
      throw BadInput(program.name + " has no parameter '" + name + "'" +
                     (names.empty() ? "; it has none" : did_you_mean(name, names)));
  Values values;
  for (const Parameter& p : program.parameters) {
    const auto found = given.find(p.name);
    try {
      values[p.name] = found != given.end() ? found->second : value_of(p.fallback, values);
    } catch (const Undefined& e) {
      throw Undefined(program.name + ": the default " + p.name + " = " + print(p.fallback) +
                      " has no value: " + e.what());
    }
  }
  return values;
}

}  // namespace shortfall
