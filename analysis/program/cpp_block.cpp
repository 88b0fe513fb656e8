// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/cpp_block.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/program/code_writer.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr const char* kForce = "force_";

/// Names are written as they are: they have been translated before.
class CppWriter : public CodeWriter {
  Piece of_number(const Rational& value) const override { return {"number(\"" + value.str() + "\")", kAtom}; }
  std::string of_name(const std::string& name) const override { return name; }
  std::string function(const std::string& name) const override {
    if (name == "max") return "larger";
    if (name == "min") return "smaller";
    return name == "sqrt" || name == "exp" || name == "pow" || name == kForce ? name : "";
  }
  std::string title() const override { return "C++"; }
};

bool is_exponent(const Expr& power, const Expr& operand) {
  return power->op == Op::power && operand == power->operands[1];
}

std::string written(const Expr& e) { return CppWriter().text(e); }

template <class Change>
Expr with_operands(const Expr& e, const Change& change) {
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = change(operand);
  return copy;
}

}  // namespace

int assignments(const std::vector<Statement>& block, const std::string& name) {
  int count = 0;
  for (const Statement& s : block) {
    count += s.kind == Statement::Kind::assign && s.name == name;
    count += static_cast<int>(std::ranges::count(s.unknowns, name, &Unknown::name));
    count += assignments(s.body, name);
  }
  return count;
}

bool occurs(const std::vector<Statement>& block, const std::string& name) {
  return std::ranges::any_of(block, [&](const Statement& s) {
    return (s.kind == Statement::Kind::assign && s.name == name) || (s.value && mentions(s.value, name)) ||
           std::ranges::any_of(s.unknowns,
                               [&](const Unknown& u) { return u.name == name || mentions(u.value, name); }) ||
           occurs(s.body, name);
  });
}

std::string CppConstants::member(const std::string& code, const std::string& meaning) {
  const auto found = known_.find(code);
  if (found != known_.end()) return found->second;
  const std::string member = names_.fresh("c");
  add(member, code, meaning);
  return known_[code] = member;
}

void CppConstants::add(const std::string& member, const std::string& code, const std::string& meaning) {
  lines_.push_back({member, code, meaning});
}

std::string cpp_scalar(const Expr& e, const std::map<std::string, std::string>& names) {
  const auto translated = [&](auto&& self, const Expr& f) -> Expr {
    if (f->op == Op::name) return name(names.at(f->name));
    return with_operands(f, [&](const Expr& o) { return is_exponent(f, o) ? o : self(self, o); });
  };
  return written(translated(translated, e));
}

std::vector<std::string> CppBlock::lines(const std::vector<Statement>& block, bool is_step, int indentation) {
  whole_ = &block;
  depth_ = static_cast<std::size_t>(indentation);
  vectors_ = {"x", "v"};
  for (const State& s : program_.states) vectors_.insert(s.name);
  if (program_.impulse) vectors_.insert(program_.impulse->name);
  local_ = vectors_;
  held_ = is_step && program_.holds_force;
  if (held_) line("[[maybe_unused]] const V held = " + std::string(kForce) + "(x, v, t);");
  statements(block, {names_("h"), names_("t")});
  return std::move(out_);
}

void CppBlock::line(const std::string& text) { out_.push_back(std::string(2 * depth_, ' ') + text); }

void CppBlock::statements(const std::vector<Statement>& block, const Clock& clock) {
  for (const Statement& s : block) switch (s.kind) {
      case Statement::Kind::assign:
        assign(s, clock);
        break;
      case Statement::Kind::solve:
        solve(s, clock);
        break;
      case Statement::Kind::substeps:
        substeps(s, clock);
        break;
      case Statement::Kind::limit_speed:
      case Statement::Kind::limit_move:
        limit(s, clock);
        break;
      case Statement::Kind::when:
        when(s, clock);
        break;
    }
}

void CppBlock::assign(const Statement& s, const Clock& clock) {
  if (vectors_.contains(s.name) || is_vector(s.value)) {
    declare(s.name, true, vector_text(s.value, clock));
    vectors_.insert(s.name);
    return;
  }
  if (assignments(*whole_, s.name) == 1 && is_constant(s.value)) {
    known_[s.name] = constants_.member(constant(s.value, clock)->name, s.name);
    return;
  }
  declare(s.name, false, scalar_text(s.value, clock));
  scalars_.insert(s.name);
}

void CppBlock::declare(const std::string& name, bool vector, const std::string& value) {
  const std::string type = vector ? "V " : "S ";
  if (!local_.insert(name).second) return line(names_(name) + " = " + value + ";");
  const bool once = assignments(*whole_, name) == 1;
  line((once ? "[[maybe_unused]] const " : "[[maybe_unused]] ") + type + names_(name) + " = " + value + ";");
}

void CppBlock::solve(const Statement& s, const Clock& clock) {
  const std::string unknowns = names_.fresh("unknowns");
  const std::string type = "std::array<V, " + std::to_string(s.unknowns.size()) + ">";
  std::string guesses, values;
  for (const Unknown& u : s.unknowns) {  // a position begins at x, a velocity at v
    const std::string guess = u.dimension == kLength     ? names_("x")
                              : u.dimension == kVelocity ? names_("v")
                                                         : "zero_";
    guesses += (guesses.empty() ? "" : ", ") + guess;
    vectors_.insert(u.name);
  }
  for (const Unknown& u : s.unknowns) values += (values.empty() ? "" : ", ") + vector_text(u.value, clock);
  const auto shared = [&](int value) { return "k_." + constants_.member(written(number(value)), ""); };
  line(type + " " + unknowns + "{" + guesses + "};");
  line("solve_stages(");
  line("    " + unknowns + ",");
  line("    [&](const " + type + "& guess) {");
  for (std::size_t k = 0; k < s.unknowns.size(); ++k)
    line("      [[maybe_unused]] const V& " + names_(s.unknowns[k].name) + " = guess[" + std::to_string(k) +
         "];");
  line("      return " + type + "{" + values + "};");
  line("    },");
  line("    " + shared(0) + ", " + shared(1) + ");");
  for (std::size_t k = 0; k < s.unknowns.size(); ++k)
    declare(s.unknowns[k].name, true, unknowns + "[" + std::to_string(k) + "]");
}

void CppBlock::declare_before(const Statement& loop) {
  const auto names_of = [](auto&& self, const std::vector<Statement>& block,
                           std::vector<std::pair<std::string, const Expr*>>& names) -> void {
    for (const Statement& s : block) {
      if (s.kind == Statement::Kind::assign) names.emplace_back(s.name, &s.value);
      for (const Unknown& u : s.unknowns) names.emplace_back(u.name, nullptr);
      if (s.kind == Statement::Kind::substeps) self(self, s.body, names);
    }
  };
  std::vector<std::pair<std::string, const Expr*>> names;
  names_of(names_of, loop.body, names);
  const auto outside = [&](auto&& self, const std::vector<Statement>& block,
                           const std::string& name) -> bool {
    return std::ranges::any_of(block, [&](const Statement& s) {
      if (&s == &loop) return false;
      if (s.kind == Statement::Kind::substeps) return self(self, s.body, name);
      return occurs({s}, name);
    });
  };
  for (const auto& [name, value] : names) {
    if (local_.contains(name) || known_.contains(name) || !outside(outside, *whole_, name)) continue;
    const bool vector = !value || is_vector(*value);
    if (!vector && is_constant(*value) && assignments(*whole_, name) == 1) continue;
    local_.insert(name);
    (vector ? vectors_ : scalars_).insert(name);
    line(vector ? "V " + names_(name) + " = zero_;" : "S " + names_(name) + "{};");
  }
}

void CppBlock::substeps(const Statement& s, const Clock& clock) {
  declare_before(s);
  const bool named = s.value->op == Op::name;
  const std::string shorter = constants_.member(
      clock.step + " / " + (named ? known_.at(s.value->name) : written(s.value)), "the substep");
  const std::string time = names_.fresh("time"), counter = names_.fresh("i");
  const std::string count = named ? "k_." + names_(s.value->name) + "_times" : s.value->value.str();
  const std::set<std::string> outside = local_;
  line("{");
  ++depth_;
  line("S " + time + " = " + clock.time + ";");
  line("for (int " + counter + " = 0; " + counter + " < " + count + "; ++" + counter + ") {");
  ++depth_;
  statements(s.body, {shorter, time});
  if (s.whole_steps && program_.impulse) line(names_(program_.impulse->name) + " = zero_;");
  line(time + " = " + time + " + k_." + shorter + ";");
  for (int closed = 0; closed < 2; ++closed) {
    --depth_;
    line("}");
  }
  local_ = outside;
}

void CppBlock::limit(const Statement& s, const Clock& clock) {
  const std::string size = scalar_text(s.value, clock);
  const bool move = s.kind == Statement::Kind::limit_move;
  line("v = limited(v, " + (move ? "V(k_." + clock.step + " * v)" : std::string("v")) + ", " + size + ");");
}

void CppBlock::when(const Statement& s, const Clock& clock) {
  const std::string faster = names_.fresh("faster");
  const auto vectors = vectors_;
  const auto scalars = scalars_;
  const auto local = local_;
  line("if (const auto " + faster + " = longer(v, " + scalar_text(s.value, clock) + "); any(" + faster +
       ")) {");
  ++depth_;
  std::map<std::string, std::string> before;
  for (const std::string& name : local) {
    if (assignments(s.body, name) == 0) continue;
    if (!vectors.contains(name))
      throw Unable(program_.name + " changes the scalar '" + name +
                   "' only when v is fast: many trajectories at once would need one for each");
    before[name] = names_.fresh("before");
    line("const V " + before[name] + " = " + names_(name) + ";");
  }
  statements(s.body, clock);
  for (const auto& [name, kept] : before)
    line(names_(name) + " = chosen(" + faster + ", " + names_(name) + ", " + kept + ");");
  --depth_;
  line("}");
  vectors_ = vectors;  // names made within are gone after it
  scalars_ = scalars;
  local_ = local;
}

bool CppBlock::is_vector(const Expr& e) const {
  switch (e->op) {
    case Op::number:
    case Op::power:
    case Op::call:
      return false;
    case Op::name:
      return vectors_.contains(e->name);
    case Op::force:
      return true;
    default:
      return std::ranges::any_of(e->operands, [&](const Expr& o) { return is_vector(o); });
  }
}

bool CppBlock::is_constant(const Expr& e) const {
  if (e->op == Op::name) return e->name == "h" || known_.contains(e->name);
  if (e->op == Op::force) return false;
  return std::ranges::all_of(e->operands, [&](const Expr& o) { return is_constant(o); });
}

Expr CppBlock::constant(const Expr& e, const Clock& clock) {
  std::map<std::string, std::string> names = known_;
  names["h"] = clock.step;
  const std::string code = cpp_scalar(e, names);
  return name(e->op == Op::name ? code : constants_.member(code, print_decimals(e)));
}

Expr CppBlock::scalar(const Expr& e, const Clock& clock) {
  if (is_constant(e)) return name("k_." + constant(e, clock)->name);
  if (e->op == Op::name) return name(e->name == "t" ? clock.time : names_(e->name));
  return with_operands(e, [&](const Expr& o) { return is_exponent(e, o) ? o : scalar(o, clock); });
}

Expr CppBlock::vector(const Expr& e, const Clock& clock) {
  if (!is_vector(e)) return name("zero_");  // the checker lets only 0 through
  const auto& o = e->operands;
  switch (e->op) {
    case Op::name:
      return name(names_(e->name));
    case Op::force:
      if (held_) return name("held");
      return call(kForce, {vector(o[0], clock), vector(o[1], clock), scalar(o[2], clock)});
    case Op::multiply: {  // the scalar stands on the left
      const bool left = is_vector(o[0]);
      return binary(Op::multiply, scalar(o[left ? 1 : 0], clock), vector(o[left ? 0 : 1], clock));
    }
    case Op::divide:
      return binary(Op::divide, vector(o[0], clock), scalar(o[1], clock));
    default:
      return with_operands(e, [&](const Expr& operand) { return vector(operand, clock); });
  }
}

std::string CppBlock::scalar_text(const Expr& e, const Clock& clock) { return written(scalar(e, clock)); }
std::string CppBlock::vector_text(const Expr& e, const Clock& clock) { return written(vector(e, clock)); }

}  // namespace shortfall
