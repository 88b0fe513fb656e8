// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/traced.hpp"

#include <algorithm>
#include <unordered_set>

#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/traced_lines.hpp"

namespace shortfall {

namespace {

/// Names that mean something in the language.
const std::set<std::string>& reserved() {
  static const std::set<std::string> words{
      "a",      "x",        "v",        "h",     "t",     "n",      "integrator", "alias",
      "source", "param",    "root",     "of",    "near",  "approx", "state",      "impulse",
      "hold",   "assume",   "solves",   "start", "step",  "finish", "tableau",    "splitting",
      "expect", "solve",    "substeps", "limit", "speed", "move",   "when",       "kick",
      "drift",  "embedded", "sqrt",     "exp",   "pow",   "max",    "min",        "log",
      "sin",    "cos",      "sinh",     "cosh",  "acos",  "acosh",  "atan",       "sum"};
  return words;
}

/// Whether a name occurs that does not belong to this call.
bool is_foreign(const Expr& top, const std::unordered_set<const Expression*>& own) {
  std::unordered_set<const Expression*> seen;
  std::vector<const Expression*> stack{top.get()};
  while (!stack.empty()) {
    const Expression* const e = stack.back();
    stack.pop_back();
    if (!seen.insert(e).second) continue;
    if (e->op == Expression::Op::name && !own.contains(e)) return true;
    for (const Expr& operand : e->operands) stack.push_back(operand.get());
  }
  return false;
}

bool same_lines(const std::vector<Statement>& a, const std::vector<Statement>& b) {
  return std::ranges::equal(a, b, [](const Statement& p, const Statement& q) {
    return p.name == q.name && same(p.value, q.value);
  });
}

}  // namespace

TracedVector& Carried::vector(const std::string& name) {
  for (auto& [known, value] : vectors_)
    if (known == name) return value;
  throw BadInput("the step asks for the vector '" + name + "', which was not declared by state()");
}

TracedScalar Carried::number(const std::string& name) const {
  for (const auto& [known, value] : numbers_)
    if (known == name) return value;
  throw BadInput("the step asks for the number '" + name + "', which was not declared by parameter()");
}

Tracing& Tracing::state(const std::string& name, const std::string& dimension) {
  states_.push_back({name, "  state " + name + " : " + dimension + "\n"});
  return *this;
}

Tracing& Tracing::parameter(const std::string& name, const Rational& value, const std::string& dimension) {
  parameters_.push_back({name, "  param " + name + " : " + dimension + " = " + value.str() + "\n"});
  return *this;
}

Tracing& Tracing::assume(const std::string& text) {
  head_ += "  assume " + text + "\n";
  return *this;
}

Tracing& Tracing::solves(const std::string& text) {
  head_ += "  solves " + text + "\n";
  return *this;
}

std::vector<Statement> Tracing::block(const Step& f, const std::string& word) const {
  std::unordered_set<const Expression*> own;
  std::vector<Expr> letters;  // which keeps them alive
  const auto letter = [&](const std::string& name) {
    letters.push_back(shortfall::name(name));
    own.insert(letters.back().get());
    return letters.back();
  };
  TracedVector x(letter("x")), v(letter("v"));
  const TracedScalar t(letter("t")), h(letter("h"));
  Carried carried;
  const bool has_values = word != "start";
  for (const Declaration& s : states_)
    carried.vectors_.emplace_back(s.name, has_values ? TracedVector(letter(s.name)) : TracedVector());
  for (const Declaration& p : parameters_)
    carried.numbers_.emplace_back(p.name, TracedScalar(letter(p.name)));
  f(x, v, t, h, TracedForce(), carried);

  std::vector<Target> targets{{"x", x.expression()}, {"v", v.expression()}};
  for (const auto& [name, value] : carried.vectors_) {
    if (word == "finish" && own.contains(value.expression().get())) continue;
    targets.emplace_back(name, value.expression());
  }
  std::set<std::string> taken = reserved();
  for (const Declaration& s : states_) taken.insert(s.name);
  for (const Declaration& p : parameters_) taken.insert(p.name);
  for (const Target& target : targets)
    if (is_foreign(target.second, own))
      throw BadInput("the " + word +
                     " uses a value that it kept from an earlier call; what is carried from step to "
                     "step is declared: Tracing(name).state(\"a0\", \"L/T^2\")");
  return traced_lines(targets, taken);
}

Program Tracing::program(const Step& step) const {
  if (!states_.empty() && !start_)
    throw BadInput("the state '" + states_.front().name + "' needs a first value: give Tracing a start");
  std::string text = "integrator " + name_ + "\n";
  for (const Declaration& p : parameters_) text += p.line;
  for (const Declaration& s : states_) text += s.line;
  text += head_;
  Program lines;  // printed block by block
  for (const auto& [word, f, block_of] : {std::tuple("start", &start_, &lines.start),
                                          {"step", &step, &lines.step},
                                          {"finish", &finish_, &lines.finish}}) {
    if (!*f) continue;
    *block_of = block(*f, word);
    if (!same_lines(*block_of, block(*f, word)))
      throw BadInput(std::string("the ") + word +
                     " does something else when it is called again: it reads what changes "
                     "outside of it; an integrator does the same every step");
  }
  lines.name = name_;
  const std::string printed = print(lines);
  return parse(text + printed.substr(printed.find('\n') + 1), name_ + " (traced)");
}

}  // namespace shortfall
