// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "analysis/program/print.hpp"

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

bool same_tableaus(const std::optional<Tableau>& a, const std::optional<Tableau>& b) {
  if (!a || !b) return !a && !b;
  return same_rows(a->c, b->c) && std::ranges::equal(a->a, b->a, same_rows) && same_rows(a->b, b->b) &&
         same_rows(a->embedded, b->embedded);
}

}  // namespace

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
  for (const State& state : p.states) text += "  state  " + state.name + " : " + state.dimension.str() + "\n";
  if (!p.start.empty()) text += "\nstart\n" + statements(p.start, "  ");
  text += p.tableau ? tableau_block(*p.tableau) : "\nstep\n" + statements(p.step, "  ");
  if (!p.finish.empty()) text += "\nfinish\n" + statements(p.finish, "  ");
  if (!p.claims.empty()) text += "\nexpect\n";
  for (const Claim& claim : p.claims) text += "  " + claim.word + " " + print_decimals(claim.value) + "\n";
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
    return p.word == q.word && same(p.value, q.value);
  };
  return a.name == b.name && a.description == b.description && a.aliases == b.aliases &&
         a.sources == b.sources && std::ranges::equal(a.parameters, b.parameters, same_parameter) &&
         std::ranges::equal(a.states, b.states, same_state) && same_statements(a.start, b.start) &&
         same_statements(a.step, b.step) && same_statements(a.finish, b.finish) &&
         same_tableaus(a.tableau, b.tableau) && std::ranges::equal(a.claims, b.claims, same_claim);
}

}  // namespace shortfall
