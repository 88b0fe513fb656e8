// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/python_step.hpp"

#include "analysis/algebra/error.hpp"

#include <algorithm>
#include <set>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// Python's keywords, and what start, step and finish need.
const std::set<std::string> kTakenInPython{
    "False",    "None",   "True",  "and",  "as",     "assert",   "async",   "await",    "break", "class",
    "continue", "def",    "del",   "elif", "else",   "except",   "finally", "for",      "from",  "global",
    "if",       "import", "in",    "is",   "lambda", "nonlocal", "not",     "or",       "pass",  "raise",
    "return",   "try",    "while", "with", "yield",  "print",    "_",       "Fraction", "range", "solved",
    "stage",    "frame",  "begin", "a",    "t",      "h"};

/// What the cells call their own; parameters and carried vectors live among them.
const std::set<std::string> kTakenByCells{"Random",
                                          "Decimal",
                                          "localcontext",
                                          "sum",
                                          "zip",
                                          "len",
                                          "max",
                                          "next",
                                          "enumerate",
                                          "n",
                                          "k",
                                          "i",
                                          "c",
                                          "x0",
                                          "v0",
                                          "random",
                                          "some",
                                          "draws",
                                          "letters",
                                          "runs",
                                          "carried",
                                          "frames",
                                          "force",
                                          "start",
                                          "step",
                                          "finish",
                                          "stepped",
                                          "steps",
                                          "position",
                                          "velocity",
                                          "exact_position",
                                          "exact_velocity",
                                          "integral",
                                          "value",
                                          "shortfall_position",
                                          "shortfall_velocity",
                                          "FIRST",
                                          "LAST",
                                          "LONG",
                                          "x_out",
                                          "v_out",
                                          "g",
                                          "dt",
                                          "height",
                                          "decimal",
                                          "root",
                                          "rounded",
                                          "launch",
                                          "claims",
                                          "top",
                                          "reached",
                                          "short",
                                          "by_integrator",
                                          "between",
                                          "lost",
                                          "missed",
                                          "highest",
                                          "still_short",
                                          "plt",
                                          "count",
                                          "fine",
                                          "times",
                                          "fig",
                                          "axes"};

bool is_force_letter(const std::string& name) {
  return name.size() > 1 && name[0] == 'f' && name.find_first_not_of("0123456789", 1) == std::string::npos;
}

template <class Visit>
void each_expression(const std::vector<Statement>& body, const Visit& visit) {
  for (const Statement& s : body) {
    // How many substeps there are is written out as a number.
    const bool counts = s.kind == Statement::Kind::substeps && s.value->op == Expression::Op::name;
    if (s.value && !counts) visit(s.value);
    for (const Unknown& u : s.unknowns) visit(u.value);
    each_expression(s.body, visit);
  }
}

bool any_solve(const std::vector<Statement>& body) {
  return std::ranges::any_of(
      body, [](const Statement& s) { return s.kind == Statement::Kind::solve || any_solve(s.body); });
}

bool mentions_call(const Expr& e) {
  return e->op == Expression::Op::call || std::ranges::any_of(e->operands, mentions_call);
}

}  // namespace

constexpr int kRootDigits = 20;  // not used: irrational coefficients are refused below

PythonStep::PythonStep(const Program& program, const Values& given, int substeps, PythonUse use)
    : program_(with_numbers(undisturbed(substepped(program, substeps)), kRootDigits)),
      values_(parameter_values(program, given)),
      substeps_(substeps),
      use_(use) {
  for (const auto* block : {&program_.start, &program_.step, &program_.finish})
    each_expression(*block, [&](const Expr& e) {
      if (use == PythonUse::derivation && mentions_call(e))
        throw Unable("a notebook computes with fractions, and the step of " + program.name +
                     " calls a function: " + print(e));
    });
  if (program.approximate())
    throw Unable("a notebook asserts exact equalities, and coefficients of " + program.name +
                 " are known to some digits only");
  if (!program.roots.empty())
    throw Unable("a notebook computes with fractions, and '" + program.roots.front().name + "' of " +
                 program.name + " is irrational");
  carried_ = {"x", "v"};
  for (const State& s : program_.states) carried_.push_back(s.name);
  name_everything();
  wording_.name = [this](const std::string& word) { return this->name(word); };

  std::set<std::string> needed;
  const auto visit = [&](const Expr& e) {
    for (const Parameter& p : program_.parameters)
      if (mentions(e, p.name)) needed.insert(p.name);
  };
  for (const auto* block : {&program_.start, &program_.step, &program_.finish})
    each_expression(*block, visit);
  const Tape tape = lower(program_, given);
  for (std::size_t i = tape.parameters.size(); i-- > 0;)
    if (needed.contains(tape.parameters[i].name) && !tape.parameters[i].fixed && tape.parameters[i].derived)
      visit(program_.parameters[i].fallback);
  for (const Tape::ParameterSlot& slot : tape.parameters) {
    if (!needed.contains(slot.name)) continue;
    if (slot.fixed)
      fixed_[slot.name] = *slot.fixed;
    else if (slot.derived)
      derived_.push_back(slot.name);
    else
      parameters_.emplace_back(slot.name, values_.at(slot.name));
  }
}

void PythonStep::add_name(const std::string& name, bool local) {
  if (name == "x" || name == "v" || names_.contains(name)) return;
  const auto is_used = [&](const std::string& text) {
    return kTakenInPython.contains(text) ||
           (!local && (kTakenByCells.contains(text) || is_force_letter(text))) ||
           std::ranges::any_of(names_, [&](const auto& entry) { return entry.second == text; });
  };
  std::string text = name;
  while (is_used(text)) text += "_";
  names_[name] = text;
}

void PythonStep::name_everything() {
  const auto add_assigned = [this](const std::vector<Statement>& body, const auto& self) -> void {
    for (const Statement& s : body) {
      if (s.kind == Statement::Kind::assign) add_name(s.name, true);
      for (const Unknown& u : s.unknowns) add_name(u.name, true);
      self(s.body, self);
    }
  };
  const bool alone = use_ == PythonUse::alone;
  for (const Parameter& p : program_.parameters) add_name(p.name, alone);
  for (const State& s : program_.states) add_name(s.name, alone);
  for (const auto* block : {&program_.start, &program_.step, &program_.finish})
    add_assigned(*block, add_assigned);
}

std::string PythonStep::name(const std::string& name) const {
  const auto found = names_.find(name);
  return found == names_.end() ? name : found->second;
}

bool PythonStep::has_solve() const {
  return any_solve(program_.start) || any_solve(program_.step) || any_solve(program_.finish);
}

std::string PythonStep::state() const {
  std::vector<std::string> words;
  for (const std::string& c : carried_) words.push_back(name(c));
  return comma_list(words);
}

std::string PythonStep::more() const {
  std::string text;
  for (const auto& [parameter, value] : parameters_) text += ", " + name(parameter);
  return text;
}

std::string PythonStep::assignment(int indent, const std::string& target, const Expr& value) const {
  const std::string head = name(target) + " = ";
  if (is_whole(value, wording_))
    return wrapped(indent, head, "Fraction(" + python(value, wording_) + ")") + "\n";
  return wrapped_call(indent, head, value, wording_) + "\n";
}

void PythonStep::write_solve(const Statement& solve, int indent, std::string& text) const {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  std::vector<std::string> unknowns;
  for (const Unknown& u : solve.unknowns) unknowns.push_back(name(u.name));
  text += "\n" + blanks + "def stage(" + comma_list(unknowns) + "):\n" + blanks + "    return [\n";
  for (const Unknown& u : solve.unknowns) text += wrapped_call(indent + 8, "", u.value, wording_) + ",\n";
  text += blanks + "    ]\n\n" + blanks + "[" + comma_list(unknowns) + "] = solved(stage, " +
          std::to_string(unknowns.size()) + ")\n";
}

void PythonStep::write_substeps(const Statement& loop, bool last, int indent, int depth,
                                std::string& text) const {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  const std::string count = loop.value->op == Expression::Op::name ? values_.at(loop.value->name).str()
                                                                   : python(loop.value, wording_);
  const std::string number = depth == 0 ? "" : std::to_string(depth + 1);
  if (!last) text += blanks + "frame" + number + ", begin" + number + " = h, t\n";
  text += blanks + "h = h / " + count + "\n" + blanks + "for _ in range(" + count + "):\n";
  write(loop.body, indent + 4, depth + 1, text);
  text += blanks + "    t = t + h\n";
  if (!last) text += blanks + "h, t = frame" + number + ", begin" + number + "\n";
}

void PythonStep::write(const std::vector<Statement>& body, int indent, int depth, std::string& text) const {
  for (const Statement& s : body) {
    switch (s.kind) {
      case Statement::Kind::assign:
        if (s.value->op == Expression::Op::name && s.value->name == s.name) break;  // v = v + j without j
        text += assignment(indent, s.name, s.value);
        break;
      case Statement::Kind::solve:
        write_solve(s, indent, text);
        break;
      case Statement::Kind::substeps:
        write_substeps(s, depth == 0 && &s == &body.back(), indent, depth, text);
        break;
      default:
        throw Error("limits are not taken out");  // see undisturbed
    }
  }
}

std::string PythonStep::parameter_lines(const std::vector<Statement>& body) const {
  std::set<std::string> needed;
  each_expression(body, [&](const Expr& e) {
    for (const Parameter& p : program_.parameters)
      if (mentions(e, p.name)) needed.insert(p.name);
  });
  for (std::size_t i = program_.parameters.size(); i-- > 0;) {
    const Parameter& p = program_.parameters[i];
    if (!needed.contains(p.name) || std::ranges::find(derived_, p.name) == derived_.end()) continue;
    for (const Parameter& q : program_.parameters)
      if (mentions(p.fallback, q.name)) needed.insert(q.name);
  }
  std::string text;
  for (const Parameter& p : program_.parameters) {
    if (!needed.contains(p.name)) continue;
    if (const auto found = fixed_.find(p.name); found != fixed_.end())
      text += assignment(4, p.name, number(found->second));
    else if (std::ranges::find(derived_, p.name) != derived_.end())
      text += assignment(4, p.name, p.fallback);
  }
  return text;
}

std::string PythonStep::function(const std::string& name, const std::string& what,
                                 const std::vector<Statement>& body, const std::string& result) const {
  const std::string vectors = name == "start" ? "x, v" : state();
  std::string text =
      "def " + name + "(" + vectors + ", t, h, a" + more() + "):\n    \"\"\"" + what + "\"\"\"\n";
  text += parameter_lines(body);
  write(body, 4, 0, text);
  return text + "    return " + result + "\n";
}

std::string PythonStep::functions() const {
  std::string text;
  if (has_start())
    text += function("start", "What is carried from step to step, at the launch.", program_.start, state()) +
            "\n\n";
  const std::string n = std::to_string(substeps_);
  text += function("step",
                   substeps_ == 1 ? "One step of length h, from t to t + h."
                                  : "One frame of length h: " + n + " steps of h / " + n + ".",
                   program_.step, state());
  if (has_finish())
    text +=
        "\n\n" + function("finish", "What is read out: position and velocity at t.", program_.finish, "x, v");
  return text;
}

std::string PythonStep::solver() const {
  if (!has_solve()) return "";
  return R"py(def solved(stage, count):
    """The u with u = stage(u), exactly. The stage is affine in u: probing it at 0 and at the unit
    vectors gives its linear system, which elimination solves."""
    base = stage(*[Fraction(0)] * count)
    columns = []
    for j in range(count):
        probe = stage(*[Fraction(i == j) for i in range(count)])
        columns.append([p - b for p, b in zip(probe, base)])
    rows = [
        [Fraction(i == j) - columns[j][i] for j in range(count)] + [base[i]] for i in range(count)
    ]
    for i in range(count):
        pivot = next(r for r in range(i, count) if rows[r][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [entry / rows[i][i] for entry in rows[i]]
        for r in range(count):
            if r != i:
                rows[r] = [p - rows[r][i] * q for p, q in zip(rows[r], rows[i])]
    u = [row[count] for row in rows]
    assert stage(*u) == u
    return u
)py";
}

}  // namespace shortfall
