// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/tableau_numbers.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/arithmetic.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

constexpr int kRootDigits = 70;

template <class K>
K sum(const std::vector<K>& row) {
  K total(0);
  for (const K& k : row) total += k;
  return total;
}

template <class K>
void put_row_sums(Method<K>& m) {
  m.c.clear();
  for (const auto& row : m.a) m.c.push_back(sum(row));
}

/// The expressions of a program's tableau, rows filled with zeros.
Method<Expr> expressions(const Program& program) {
  const Tableau& t = *program.tableau;
  Method<Expr> m;
  for (const auto& row : t.a) {
    m.a.push_back(row);
    while (m.a.back().size() < t.b.size()) m.a.back().push_back(number(0));
  }
  m.b = t.b;
  m.c = t.c;
  m.embedded = t.embedded;
  return m;
}

Method<TableauEntry> entries(const TableauFile& file) {
  Method<TableauEntry> m;
  m.nystroem = file.nystroem;
  m.a = file.a;
  m.b = file.b;
  m.embedded = file.embedded;
  m.b_position = file.b_position;
  m.embedded_position = file.embedded_position;
  m.c = file.c;
  return m;
}

/// The kind of number, and the numbers themselves, from expressions.
void fill(AuditedTableau& t, const Method<Expr>& expressions, const Values& given) {
  const Values values = parameter_values(t.program, given);
  const auto as_ball = [&](const Expr& e) { return known_value(e, t.program, values); };
  t.nystroem = expressions.nystroem;
  if (t.program.approximate()) {
    t.numbers = AuditedTableau::Numbers::digits;
    t.digits = converted<KnownDigits>(expressions, as_ball);
    if (!t.c_given) put_row_sums(t.digits);
    return;
  }
  t.field = std::make_shared<NumberField>();
  t.extras = std::make_shared<ExtraLetters>(letter_names(lower(t.program, given)));
  const FormulaScalars scalars = formula_scalars(t.program, values, t.extras.get());
  const auto exact = converted<Fraction>(
      expressions, [&](const Expr& e) { return scalar_value(e, scalars, t.extras.get()); });
  const std::vector<Cell> all = cells(exact);
  if (std::ranges::all_of(all, [&](const Cell& cell) { return exact.at(cell).is_constant(); })) {
    t.rational = converted<Rational>(exact, [](const Fraction& f) { return f.constant(); });
    t.digits = converted<KnownDigits>(t.rational, [](const Rational& r) { return KnownDigits(r); });
    return;
  }
  t.numbers = AuditedTableau::Numbers::roots;
  t.roots = exact;
  t.digits = converted<KnownDigits>(exact, [&](const Fraction& f) { return t.near(f); });
}

}  // namespace

namespace {

/// What is no sum, product or quotient.
KnownDigits known_leaf(const Expr& e, const Program& program, const Values& values) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t i) { return known_value(e->operands[i], program, values); };
  switch (e->op) {
    case Op::number:
      return KnownDigits(e->value);
    case Op::name:
      for (const Approximation& a : program.approximations)
        if (a.name == e->name) return KnownDigits::printed(a.text);
      for (const Root& r : program.roots)
        if (r.name == e->name) return KnownDigits(ball(*r.value, KnownDigits::kBits));
      if (const auto found = values.find(e->name); found != values.end()) return KnownDigits(found->second);
      break;
    case Op::power:
      if (const auto exponent = literal_value(e->operands[1])) {
        std::int64_t n = 0;
        if (exponent->fits_int64(n) && n >= -64 && n <= 64)
          return KnownDigits(pow(operand(0).ball(), static_cast<int>(n)));
      }
      break;
    case Op::call:
      if (e->name == "sqrt") return KnownDigits(sqrt(operand(0).ball()));
      break;
    default:
      break;
  }
  throw Unable("an entry of the tableau is no number: " + print(e));
}

}  // namespace

KnownDigits known_value(const Expr& e, const Program& program, const Values& values) {
  return arithmetic<KnownDigits>(e, [&](const Expr& leaf) { return known_leaf(leaf, program, values); });
}

AuditedTableau::AuditedTableau(const TableauFile& file)
    : name(file.name),
      nystroem(file.nystroem),
      c_given(file.c_given),
      claims(file.claims),
      program(file.program) {
  const Method<TableauEntry> all = entries(file);
  texts = converted<std::string>(all, [](const TableauEntry& e) { return e.text; });
  places = converted<int>(all, [](const TableauEntry& e) { return e.digits.value_or(0); });
  const auto is_rational = [&](const Cell& cell) { return all.at(cell).exact.has_value(); };
  const std::vector<Cell> where = cells(all);
  if (file.exact() && std::ranges::all_of(where, is_rational)) {
    rational = converted<Rational>(all, [](const TableauEntry& e) { return *e.exact; });
    digits = converted<KnownDigits>(rational, [](const Rational& r) { return KnownDigits(r); });
    return;
  }
  fill(*this, converted<Expr>(all, [](const TableauEntry& e) { return e.value; }), {});
}

AuditedTableau::AuditedTableau(const Program& given_program, const Values& given)
    : name(given_program.name), program(given_program) {
  const Method<Expr> all = expressions(program);
  texts = converted<std::string>(all, [](const Expr& e) { return print(e); });
  places = converted<int>(all, [&](const Expr& e) {
    for (const Approximation& a : program.approximations)
      if (e->op == Expression::Op::name && e->name == a.name)
        return static_cast<int>(a.text.size() - a.text.find('.') - 1);
    return 0;
  });
  fill(*this, all, given);
}

std::string AuditedTableau::formula(const Fraction& f) const {
  return f.is_constant() ? f.constant().str() : print(shortfall::formula(f, Wording{extras->names()}));
}

KnownDigits AuditedTableau::near(const Fraction& f) const {
  if (f.is_constant()) return KnownDigits(f.constant());
  std::map<Letter, Rational> values;
  for (const ExtraLetters::Extra& e : extras->all()) {
    if (!e.root) throw Unable("an entry of the tableau calls " + e.name);
    const RealRoot fine = e.root->refined(Rational(1) / Rational(10).pow(kRootDigits + 10));
    values[e.letter] = (fine.low() + fine.high()) / Rational(2);
  }
  // Ten digits more than are kept make up for what the formula loses.
  const Rational value = f.evaluate(values), width = Rational(1) / Rational(10).pow(kRootDigits);
  return KnownDigits(hull(Ball(value - width, KnownDigits::kBits), Ball(value + width, KnownDigits::kBits)));
}

std::string cell_name(const Cell& cell, bool nystroem) {
  using Part = Cell::Part;
  const auto index = [](std::size_t i) { return "[" + std::to_string(i + 1) + "]"; };
  switch (cell.part) {
    case Part::a:
      return (nystroem ? "Abar" : "A") + index(cell.i) + index(cell.j);
    case Part::b:
      return "b" + index(cell.i);
    case Part::embedded:
      return "bhat" + index(cell.i);
    case Part::b_position:
      return "bbar" + index(cell.i);
    case Part::embedded_position:
      return "bbarhat" + index(cell.i);
    case Part::c:
      return "c" + index(cell.i);
  }
  return "";
}

}  // namespace shortfall
