// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "analysis/program/print.hpp"
#include "analysis/program/tape_source.hpp"

namespace shortfall {

namespace {

std::string statements(const std::vector<Statement>& block, const std::string& indent) {
  std::string text;
  for (const Statement& s : block) {
    switch (s.kind) {
      case Statement::Kind::assign:
        text += indent + s.name + " = " + print_decimals(s.value) + "\n";
        break;
      case Statement::Kind::solve: {
        text += indent + "solve ";
        for (std::size_t i = 0; i < s.unknowns.size(); ++i) {
          const Unknown& u = s.unknowns[i];
          text += (i ? " &\n" + indent + "      " : "") + u.name + " : " + u.dimension.str() + " = " +
                  print_decimals(u.value);
        }
        text += "\n";
        break;
      }
      case Statement::Kind::substeps:
        text += indent + "substeps " + print_decimals(s.value) + " {\n" + statements(s.body, indent + "  ") +
                indent + "}\n";
        break;
      case Statement::Kind::limit_speed:
      case Statement::Kind::limit_move:
        text += indent + (s.kind == Statement::Kind::limit_move ? "limit move " : "limit speed ") +
                print_decimals(s.value) + "\n";
        break;
      case Statement::Kind::when:
        text += indent + "when speed > " + print_decimals(s.value) + " {\n" +
                statements(s.body, indent + "  ") + indent + "}\n";
        break;
    }
  }
  return text;
}

/// An entry of a tableau has no blanks.
std::string entry(const Expr& e) {
  std::string text = print_decimals(e);
  std::erase(text, ' ');
  return text;
}

std::string row(const std::string& head, const std::vector<Expr>& entries) {
  std::string text = "  " + head + " |";
  for (const Expr& e : entries) text += " " + entry(e);
  return text + "\n";
}

std::string tableau_block(const Tableau& tableau) {
  std::string text = "\ntableau\n";
  for (std::size_t i = 0; i < tableau.c.size(); ++i) text += row(entry(tableau.c[i]), tableau.a[i]);
  text += row("b", tableau.b);
  if (!tableau.embedded.empty()) text += row("embedded", tableau.embedded);
  return text;
}

std::string splitting_block(const Splitting& splitting) {
  std::string text = "\nsplitting\n";
  for (const Splitting::Part& part : splitting.parts)
    text += (part.kick ? "  kick  " : "  drift ") + print_decimals(part.weight) + "\n";
  return text;
}

/// The declarations of the second half of the head.
std::string declarations(const Program& p) {
  std::string text;
  for (const Root& root : p.roots) {
    text += "  root   " + root.name + " of " + print_decimals(root.left) + " = " + print_decimals(root.right);
    if (root.near) text += " near " + print_decimals(number(*root.near));
    text += "\n";
  }
  for (const Approximation& a : p.approximations) text += "  approx " + a.name + " = " + a.text + "\n";
  for (const State& state : p.states) text += "  state  " + state.name + " : " + state.dimension.str() + "\n";
  if (p.impulse) text += "  impulse " + p.impulse->name + " : " + p.impulse->dimension.str() + "\n";
  if (p.holds_force) text += "  hold   a\n";
  for (const Assumption& a : p.assumptions) text += "  assume " + a.str() + "\n";
  if (p.solves) text += "  solves " + print_decimals(p.solves) + "\n";
  return text;
}

bool same_rows(const std::vector<Expr>& a, const std::vector<Expr>& b) {
  return std::ranges::equal(a, b, [](const Expr& p, const Expr& q) { return same(p, q); });
}

bool same_statements(const std::vector<Statement>& a, const std::vector<Statement>& b) {
  const auto same_value = [](const Expr& p, const Expr& q) { return p && q ? same(p, q) : !p && !q; };
  const auto same_unknown = [](const Unknown& p, const Unknown& q) {
    return p.name == q.name && p.dimension == q.dimension && same(p.value, q.value);
  };
  return std::ranges::equal(a, b, [&](const Statement& p, const Statement& q) {
    return p.kind == q.kind && p.name == q.name && same_value(p.value, q.value) &&
           std::ranges::equal(p.unknowns, q.unknowns, same_unknown) && same_statements(p.body, q.body);
  });
}

bool same_splittings(const std::optional<Splitting>& a, const std::optional<Splitting>& b) {
  if (!a || !b) return !a && !b;
  return std::ranges::equal(a->parts, b->parts, [](const Splitting::Part& p, const Splitting::Part& q) {
    return p.kick == q.kick && same(p.weight, q.weight);
  });
}

bool same_declarations(const Program& a, const Program& b) {
  const auto same_root = [](const Root& p, const Root& q) {
    return p.name == q.name && same(p.left, q.left) && same(p.right, q.right) && p.near == q.near;
  };
  const auto same_approximation = [](const Approximation& p, const Approximation& q) {
    return p.name == q.name && p.text == q.text;
  };
  const auto same_assumption = [](const Assumption& p, const Assumption& q) {
    return p.less == q.less && same(p.left, q.left) && same(p.right, q.right);
  };
  const bool same_impulse =
      a.impulse && b.impulse ? a.impulse->name == b.impulse->name : !a.impulse && !b.impulse;
  return std::ranges::equal(a.roots, b.roots, same_root) &&
         std::ranges::equal(a.approximations, b.approximations, same_approximation) && same_impulse &&
         a.holds_force == b.holds_force &&
         std::ranges::equal(a.assumptions, b.assumptions, same_assumption) &&
         (a.solves && b.solves ? same(a.solves, b.solves) : !a.solves && !b.solves);
}

bool same_tableaus(const std::optional<Tableau>& a, const std::optional<Tableau>& b) {
  if (!a || !b) return !a && !b;
  return same_rows(a->c, b->c) && std::ranges::equal(a->a, b->a, same_rows) && same_rows(a->b, b->b) &&
         same_rows(a->embedded, b->embedded);
}

}  // namespace

Expr Assumption::positive() const {
  return less ? binary(Expression::Op::subtract, right, left) : binary(Expression::Op::subtract, left, right);
}

std::string Assumption::str() const {
  return print_decimals(left) + (less ? " < " : " > ") + print_decimals(right);
}

std::string print(const Statement& s) {
  std::string text = statements({s}, "");
  for (std::size_t end; (end = text.find('\n')) != std::string::npos;) {
    std::size_t next = text.find_first_not_of(" \n", end);
    if (next == std::string::npos) next = text.size();
    text.replace(end, next - end, next == text.size() ? "" : " ");
  }
  if (const std::size_t brace = text.find(" {"); brace != std::string::npos) text.resize(brace);
  return text;
}

std::string print(const Program& p) {
  std::string text;
  for (std::size_t begin = 0; begin < p.description.size();) {
    std::size_t end = p.description.find('\n', begin);
    if (end == std::string::npos) end = p.description.size();
    text += (end == begin ? "#" : "# ") + p.description.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  text += "integrator " + p.name + "\n";
  for (const std::string& alias : p.aliases) text += "  alias  " + alias + "\n";
  for (const std::string& source : p.sources) text += "  source " + source + "\n";
  for (const Parameter& parameter : p.parameters)
    text += "  param  " + parameter.name +
            (parameter.dimension == kPure ? "" : " : " + parameter.dimension.str()) + " = " +
            print_decimals(parameter.fallback) + "\n";
  text += declarations(p);
  if (!p.start.empty()) text += "\nstart\n" + statements(p.start, "  ");
  text += p.tableau     ? tableau_block(*p.tableau)
          : p.splitting ? splitting_block(*p.splitting)
                        : "\nstep\n" + statements(p.step, "  ");
  if (!p.finish.empty()) text += "\nfinish\n" + statements(p.finish, "  ");
  if (!p.claims.empty()) text += "\nexpect\n";
  for (const Claim& claim : p.claims) text += "  " + claim.str() + "\n";
  return text;
}

bool same(const Program& a, const Program& b) {
  const auto same_parameter = [](const Parameter& p, const Parameter& q) {
    return p.name == q.name && p.dimension == q.dimension && same(p.fallback, q.fallback);
  };
  const auto same_state = [](const State& p, const State& q) {
    return p.name == q.name && p.dimension == q.dimension;
  };
  const auto same_claim = [](const Claim& p, const Claim& q) {
    return p.word == q.word && p.forces == q.forces && !p.value == !q.value &&
           (!p.value || same(p.value, q.value));
  };
  return a.name == b.name && a.description == b.description && a.aliases == b.aliases &&
         a.sources == b.sources && std::ranges::equal(a.parameters, b.parameters, same_parameter) &&
         std::ranges::equal(a.states, b.states, same_state) && same_statements(a.start, b.start) &&
         same_statements(a.step, b.step) && same_statements(a.finish, b.finish) &&
         same_tableaus(a.tableau, b.tableau) && same_splittings(a.splitting, b.splitting) &&
         same_declarations(a, b) && std::ranges::equal(a.claims, b.claims, same_claim);
}

std::string Claim::str() const {
  return word + (value ? " " + print_decimals(value) : "") + (forces.empty() ? "" : " if " + forces);
}

}  // namespace shortfall
