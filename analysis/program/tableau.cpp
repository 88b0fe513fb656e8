// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tableau.hpp"

#include <string_view>

#include "analysis/program/counted.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

/// One entry, a run of characters without blanks, as an expression.
Expr entry(const Source& source, int line, std::size_t begin, std::size_t end) {
  TokenReader in(source, tokens_between(source, line, begin, end));
  Expr e = in.expression();
  in.expect_end("an entry of the tableau");
  return e;
}

/// base + h*(w_1 u_1 + w_2 u_2 ...), zero weights left out.
Expr increment(Expr base, const std::vector<Expr>& weights, const std::vector<Expr>& slopes, Place place) {
  Expr total;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (is_number(weights[j], 0)) continue;
    Expr term =
        is_number(weights[j], 1) ? slopes[j] : binary(Expression::Op::multiply, weights[j], slopes[j], place);
    total = total ? binary(Expression::Op::add, total, term, place) : term;
  }
  if (!total) return base;
  return binary(Expression::Op::add, std::move(base),
                binary(Expression::Op::multiply, name("h", place), total, place), place);
}

}  // namespace

void read_tableau_row(Tableau& tableau, const Source& source, int& line, std::size_t byte,
                      const std::string& first) {
  const std::string& text = source.line(line);
  std::size_t limit = text.find('#', byte);
  if (limit == std::string::npos) limit = text.size();
  const std::size_t bar = text.find('|', byte);
  if (bar == std::string::npos || bar >= limit)
    throw source.error(
        source.place(line, byte),
        text.find('=', byte) < limit
            ? "a tableau holds rows only; it is the whole step, and start and finish stand below it"
            : "a row of a tableau is written: c | entries, b | weights or embedded | weights");
  std::vector<Expr> entries;
  for (std::size_t i = bar + 1; i < limit;) {
    if (text[i] == ' ' || text[i] == '\t') {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < limit && text[end] != ' ' && text[end] != '\t') ++end;
    entries.push_back(entry(source, line, i, end));
    i = end;
  }
  const Place place = source.place(line, byte);
  if (first == "b" || first == "embedded") {
    std::vector<Expr>& row = first == "b" ? tableau.b : tableau.embedded;
    if (!row.empty()) throw source.error(place, "there is already a row '" + first + "'");
    if (entries.empty()) throw source.error(place, "the row '" + first + "' is empty");
    row = std::move(entries);
    return;
  }
  if (!tableau.b.empty()) throw source.error(place, "a stage cannot follow the row 'b'");
  std::size_t end = bar;
  while (end > byte && (text[end - 1] == ' ' || text[end - 1] == '\t')) --end;
  if (end == byte) throw source.error(place, "a stage begins with its time c, as in: 1/2 | 1/2");
  tableau.c.push_back(entry(source, line, byte, end));
  tableau.a.push_back(std::move(entries));
}

void lower_tableau(Program& program, const Source& source) {
  Tableau& tableau = *program.tableau;
  const std::size_t stages = tableau.c.size();
  const Place place = tableau.place;
  const auto check_size = [&](const std::vector<Expr>& row, const std::string& what, bool whole) {
    if (row.size() <= stages && !(whole && row.size() < stages)) return;
    const Place culprit = beginning(row.size() > stages ? row[stages] : row.back());
    throw source.error(culprit, what + " has " + counted(row.size(), "entry", "entries") +
                                    ", but the tableau has " + counted(stages, "stage", "stages"));
  };
  if (stages == 0) throw source.error(place, "the tableau has no stages");
  if (stages > 64) throw source.error(place, "the tableau has more than 64 stages");
  if (tableau.b.empty()) throw source.error(place, "the tableau has no row 'b'");
  check_size(tableau.b, "row b", true);
  if (!tableau.embedded.empty()) check_size(tableau.embedded, "row embedded", true);
  for (std::size_t i = 0; i < stages; ++i) check_size(tableau.a[i], "row " + std::to_string(i + 1), false);
  // A parameter or state called k1 or v2 would be captured by the stages' names.
  const auto check_name = [&](const std::string& word, Place where) {
    for (std::size_t i = 1; i <= stages; ++i)
      if (word == "k" + std::to_string(i) || word == "v" + std::to_string(i))
        throw source.error(where, "the name '" + word + "' is taken by a stage of the tableau");
  };
  for (const Parameter& p : program.parameters) check_name(p.name, p.place);
  for (const State& s : program.states) check_name(s.name, s.place);
  std::vector<Expr> k;
  std::vector<Expr> u;
  for (std::size_t i = 1; i <= stages; ++i) {
    k.push_back(name("k" + std::to_string(i), place));
    u.push_back(name("v" + std::to_string(i), place));
  }
  // A group of stages is solved together when one of them reaches beyond itself.
  for (std::size_t begin = 0; begin < stages;) {
    std::size_t end = begin;
    bool implicit = false;
    for (std::size_t i = begin; i <= end; ++i)
      for (std::size_t j = begin; j < tableau.a[i].size(); ++j)
        if (j >= i && !is_number(tableau.a[i][j], 0)) {
          end = std::max(end, j);
          implicit = true;
        }
    Statement solve;
    solve.kind = Statement::Kind::solve;
    solve.place = place;
    for (std::size_t i = begin; i <= end; ++i) {
      const std::string index = std::to_string(i + 1);
      const Expr velocity = increment(name("v", place), tableau.a[i], k, place);
      std::vector<Expr> speeds;
      for (std::size_t j = 0; j < tableau.a[i].size(); ++j)
        // In an implicit group the stage velocities are not known yet: they are written out in the unknown
        // accelerations.
        speeds.push_back(implicit && j >= begin ? increment(name("v", place), tableau.a[j], k, place) : u[j]);
      const Expr position = increment(name("x", place), tableau.a[i], speeds, place);
      const Expr time =
          is_number(tableau.c[i], 0)
              ? name("t", place)
              : binary(Expression::Op::add, name("t", place),
                       is_number(tableau.c[i], 1)
                           ? name("h", place)
                           : binary(Expression::Op::multiply, tableau.c[i], name("h", place), place),
                       place);
      if (implicit) {
        solve.unknowns.push_back({"k" + index, kAcceleration, force(position, velocity, time, place), place});
      } else {
        program.step.push_back({Statement::Kind::assign, "v" + index, velocity, {}, {}, place});
        program.step.push_back(
            {Statement::Kind::assign, "k" + index, force(position, u[i], time, place), {}, {}, place});
      }
    }
    if (implicit) {
      program.step.push_back(solve);
      for (std::size_t i = begin; i <= end; ++i)
        program.step.push_back({Statement::Kind::assign,
                                "v" + std::to_string(i + 1),
                                increment(name("v", place), tableau.a[i], k, place),
                                {},
                                {},
                                place});
    }
    begin = end + 1;
  }
  program.step.push_back(
      {Statement::Kind::assign, "x", increment(name("x", place), tableau.b, u, place), {}, {}, place});
  program.step.push_back(
      {Statement::Kind::assign, "v", increment(name("v", place), tableau.b, k, place), {}, {}, place});
}

}  // namespace shortfall
