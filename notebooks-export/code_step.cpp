// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_step.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// What is left of statements: assignments, and repetitions of such.
struct Line {
  std::string name;  ///< assigned; empty for a repetition
  Expr value;
  int times = 0;
  std::vector<Line> body;
};
using StepLines = std::vector<Line>;

/// The force as code has it: a number that is known, or a call.
Expr with_force(const Expr& e, ForceInCode force) {
  if (e->op == Expression::Op::force && force == ForceInCode::constant) return name("a");
  if (e->operands.empty()) return e;
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = with_force(operand, force);
  if (e->op == Expression::Op::force) return call(kCalledForce, copy->operands);
  return copy;
}

/// Unknowns in an order in which each is known when it is needed.
void settle(const Statement& solve, StepLines& lines, ForceInCode force) {
  std::vector<const Unknown*> left;
  for (const Unknown& u : solve.unknowns) left.push_back(&u);
  while (!left.empty()) {
    const auto ready = std::ranges::find_if(left, [&](const Unknown* u) {
      return std::ranges::none_of(
          left, [&](const Unknown* other) { return mentions(with_force(u->value, force), other->name); });
    });
    if (ready == left.end())
      throw Unable("the stage '" + left.front()->name + "' stays implicit; we cannot write its step");
    lines.push_back({(*ready)->name, with_force((*ready)->value, force), 0, {}});
    left.erase(ready);
  }
}

StepLines lines_of(const std::vector<Statement>& block, const Values& parameters, ForceInCode force) {
  StepLines lines;
  for (const Statement& s : block) {
    switch (s.kind) {
      case Statement::Kind::assign:
        if (s.value->op == Expression::Op::name && s.value->name == s.name) break;  // an impulse taken out
        lines.push_back({s.name, with_force(s.value, force), 0, {}});
        break;
      case Statement::Kind::solve:
        settle(s, lines, force);
        break;
      case Statement::Kind::substeps: {
        std::int64_t times = 0;
        (s.value->op == Expression::Op::name ? parameters.at(s.value->name) : s.value->value)
            .fits_int64(times);
        lines.push_back({"", {}, static_cast<int>(times), lines_of(s.body, parameters, force)});
        break;
      }
      default:
        throw Error("limits are not taken out");  // see undisturbed
    }
  }
  return lines;
}

bool reads(const StepLines& lines, const std::string& name) {
  return std::ranges::any_of(
      lines, [&](const Line& l) { return l.name.empty() ? reads(l.body, name) : mentions(l.value, name); });
}

/// Removes assignments to names that nobody reads, until there is none; `kept` are read from outside.
bool pruned(StepLines& lines, const std::function<bool(const std::string&)>& is_read) {
  bool changed = false;
  for (Line& l : lines)
    if (l.name.empty()) changed |= pruned(l.body, is_read);
  changed |= std::erase_if(lines, [&](const Line& l) {
               return l.name.empty() ? l.body.empty() : !is_read(l.name);
             }) > 0;
  return changed;
}

/// `finish` may assign x and v, but only for the reader: what it assigns gets names of its own.
std::pair<std::string, std::string> rename_finish(StepLines& finish, const std::set<std::string>& carried) {
  std::map<std::string, std::string> seen;
  for (Line& l : finish) {
    if (l.name.empty()) throw Unable("substeps in `finish` cannot be written as code");
    for (const auto& [from, to] : seen) l.value = replace(l.value, from, name(to));
    if (carried.contains(l.name)) {
      seen[l.name] = l.name + "_seen";
      l.name += "_seen";
    }
  }
  return {seen.contains("x") ? seen["x"] : "x", seen.contains("v") ? seen["v"] : "v"};
}

/// Keeps of statements without repetitions only what is needed after them: such a name, or what leads to one.
void keep_for(std::set<std::string> needed, StepLines& lines) {
  for (auto l = lines.end(); l != lines.begin();) {
    --l;
    if (!l->name.empty() && !needed.contains(l->name)) {
      l = lines.erase(l);
      continue;
    }
    for (const Line& other : lines)
      if (reads({*l}, other.name)) needed.insert(other.name);
  }
}

class Printer {
 public:
  Printer(Language language, ForceInCode force, bool in_binary64)
      : language_(language), force_(force), in_binary64_(in_binary64) {}

  static int assignments(const StepLines& lines, const std::string& name) {
    int count = 0;
    for (const Line& l : lines) count += l.name.empty() ? assignments(l.body, name) : l.name == name;
    return count;
  }

  std::map<std::string, std::string> names{{"h", "dt"}};
  std::set<std::string> declared;

  void print(const StepLines& lines, const StepLines& whole, int depth, std::vector<std::string>& out) {
    for (const Line& l : lines) {
      if (l.name.empty()) {
        repeat(l, whole, depth, out);
        continue;
      }
      const bool again = declared.contains(l.name) || assignments(whole, l.name) > 1;
      out.push_back(indent(depth) + assignment(l.name, written(l.value), again));
    }
  }

  /// param   again  whether it is assigned once more
  std::string assignment(const std::string& name, const std::string& value, bool again) {
    const std::string target = identifier(name, language_);
    if (declared.insert(name).second) return declaration(target, value, again);
    const bool semicolon = language_ != Language::gdscript && language_ != Language::python;
    return target + " = " + value + (semicolon ? ";" : "");
  }

 private:
  std::string written(const Expr& e) const {
    return in_binary64_ ? code_in_binary64(e, language_, names) : code(e, language_, names);
  }

  std::string declaration(const std::string& target, const std::string& value, bool again) const {
    const bool vectors = force_ == ForceInCode::called;  // of what type they are is the caller's
    switch (language_) {
      case Language::csharp:
        if (vectors) return "var " + target + " = " + value + ";";
        return "float " + target + " = " + value + ";";
      case Language::cpp:
        if (vectors) return (again ? "auto " : "const auto ") + target + " = " + value + ";";
        return (again ? "float " : "const float ") + target + " = " + value + ";";
      case Language::gdscript:
        // What a force of the caller's returns may have no type to infer; nor have max and min in Godot 4.
        return "var " + target +
               (vectors                                            ? " = "
                : value.find("max(") + 1 || value.find("min(") + 1 ? ": float = "
                                                                   : " := ") +
               value;
      case Language::python:
        return target + " = " + value;
      case Language::rust:
        if (vectors) return (again ? "let mut " : "let ") + target + " = " + value + ";";
        return (again ? "let mut " : "let ") + target + ": f32 = " + value + ";";
      case Language::javascript:
        return (again ? "let " : "const ") + target + " = " + value + ";";
    }
    return {};
  }

  static bool occurs_outside(const Line& loop, const StepLines& lines, const std::string& name) {
    return std::ranges::any_of(lines, [&](const Line& l) {
      if (&l == &loop) return false;
      return l.name.empty() ? occurs_outside(loop, l.body, name) : l.name == name || mentions(l.value, name);
    });
  }

  std::string indent(int depth) const {
    if (language_ == Language::gdscript) return std::string(static_cast<std::size_t>(depth), '\t');
    const bool two = language_ == Language::cpp || language_ == Language::javascript;
    return std::string(static_cast<std::size_t>(depth) * (two ? 2 : 4), ' ');
  }

  void repeat(const Line& loop, const StepLines& whole, int depth, std::vector<std::string>& out) {
    for (const Line& l : loop.body)  // a local that lives on after the loop is declared before it
      if (!l.name.empty() && !declared.contains(l.name) && occurs_outside(loop, whole, l.name))
        out.push_back(indent(depth) + assignment(l.name, written(number(0)), true));
    const std::set<std::string> outside = declared;
    const std::string count = std::to_string(loop.times);
    const std::string number = ++blocks_ == 1 ? "" : std::to_string(blocks_);
    const std::string short_step = "substep" + number, counter = "i" + number;
    const std::string outer = names["h"], outer_time = names.try_emplace("t", "t").first->second;
    const std::string time = "time" + number;
    const bool clock = reads(loop.body, "t");  // inside, it is that of the substep
    if (clock) {
      out.push_back(indent(depth) + declaration(time, outer_time, true));
      names["t"] = time;
    }
    out.push_back(indent(depth) +
                  declaration(short_step, outer + " / " + written(shortfall::number(loop.times)), false));
    switch (language_) {
      case Language::csharp:
      case Language::cpp:
        out.push_back(indent(depth) + "for (int " + counter + " = 0; " + counter + " < " + count + "; ++" +
                      counter + ") {");
        break;
      case Language::javascript:
        out.push_back(indent(depth) + "for (let " + counter + " = 0; " + counter + " < " + count + "; ++" +
                      counter + ") {");
        break;
      case Language::rust:
        out.push_back(indent(depth) + "for _ in 0.." + count + " {");
        break;
      case Language::gdscript:
        out.push_back(indent(depth) + "for _" + counter + " in range(" + count + "):");
        break;
      case Language::python:
        out.push_back(indent(depth) + "for _ in range(" + count + "):");
        break;
    }
    names["h"] = short_step;
    print(loop.body, whole, depth + 1, out);
    if (clock)
      out.push_back(indent(depth + 1) + time + " = " + time + " + " + short_step +
                    (language_ == Language::gdscript || language_ == Language::python ? "" : ";"));
    names["h"] = outer;
    names["t"] = outer_time;
    declared = outside;
    if (language_ != Language::gdscript && language_ != Language::python) out.push_back(indent(depth) + "}");
  }

  Language language_;
  ForceInCode force_;
  bool in_binary64_;
  int blocks_ = 0;
};

}  // namespace

namespace {

enum class Shape { loop, locals, members };

CodeStep shaped(const Program& whole, const Values& parameters, Language language, ForceInCode force,
                Shape shape, bool in_binary64) {
  constexpr int kDigits = 20;  // more than any of these languages' numbers hold
  const Program program = with_numbers(undisturbed(whole), kDigits);
  StepLines start = lines_of(program.start, parameters, force);
  StepLines step = lines_of(program.step, parameters, force);
  StepLines finish = lines_of(program.finish, parameters, force);
  std::set<std::string> carried{"x", "v"};
  for (const State& s : program.states) carried.insert(s.name);
  const bool loop = shape == Shape::loop;
  const auto [position, velocity] = rename_finish(finish, carried);

  keep_for(loop ? std::set<std::string>{position} : std::set<std::string>{position, velocity}, finish);
  const auto read_by_frame = [&, position = position](const std::string& n) {
    return n == "x" || n == position || (!loop && carried.contains(n)) || reads(step, n) || reads(finish, n);
  };
  while (pruned(step, read_by_frame)) {
  }
  std::set<std::string> needed;
  for (const Line& l : start)
    if (read_by_frame(l.name)) needed.insert(l.name);
  keep_for(needed, start);

  for (const StepLines* lines : {&start, &step, &finish})
    if (force == ForceInCode::constant && reads(*lines, "t"))
      throw Unable("the step of " + program.name + " reads the clock; we cannot write it as code yet");

  CodeStep result;
  Printer printer(language, force, in_binary64);
  for (const Parameter& p : program.parameters) {
    if (!reads(start, p.name) && !read_by_frame(p.name)) continue;
    printer.names[p.name] = constant_identifier(p.name, language);
    result.parameters.push_back(p.name);
  }
  // Carried vectors and what `start` assigns live outside the loop over frames.
  printer.declared = {"x", "v"};
  if (shape == Shape::members) printer.declared = carried;
  StepLines carried_lines = start;
  for (const StepLines* lines : {&step, &finish})
    carried_lines.insert(carried_lines.end(), lines->begin(), lines->end());
  for (const State& s : program.states) {
    Line twice{s.name, number(0), 0, {}};
    carried_lines.insert(carried_lines.end(), {twice, twice});
  }
  printer.print(start, carried_lines, 0, result.start);
  if (!loop) printer.declared.clear();  // a local of `start` is another one's
  printer.declared.insert(carried.begin(), carried.end());
  StepLines frame = step;
  if (loop) frame.insert(frame.end(), finish.begin(), finish.end());
  printer.print(frame, frame, 0, result.step);
  if (!loop) {
    printer.declared = carried;
    printer.print(finish, finish, 0, result.finish);
  }
  result.velocity_changes = Printer::assignments(start, "v") + Printer::assignments(step, "v") > 0;
  result.position = identifier(position, language);
  result.velocity = identifier(velocity, language);
  return result;
}

}  // namespace

CodeStep code_step(const Program& program, const Values& parameters, Language language, ForceInCode force,
                   bool in_binary64) {
  return shaped(program, parameters, language, force, Shape::loop, in_binary64);
}

CodeStep code_step_of_class(const Program& program, const Values& parameters, Language language,
                            bool members) {
  return shaped(program, parameters, language, ForceInCode::called, members ? Shape::members : Shape::locals,
                false);
}

}  // namespace shortfall
