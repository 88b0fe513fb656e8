// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/statement_reader.hpp"

namespace shortfall {

void StatementReader::begin(std::vector<Statement>& block, bool in_step) {
  blocks_ = {&block};
  in_step_ = in_step;
}

void StatementReader::read(TokenReader& in, const std::string& word) {
  if (in.at("}")) return close_braces(in);
  if (word == "solve") return read_solve(in);
  if (word == "substeps") return open_substeps(in);
  if (word == "when") return open_when(in);
  if (word == "limit") return read_limit(in);
  read_assignment(in);
}

void StatementReader::read_assignment(TokenReader& in) {
  const Token name = in.expect_name("a statement NAME = EXPRESSION");
  for (const char* sign : {"+", "-", "*", "/"})
    if (in.at(sign)) {
      in.take();
      if (in.at("=")) throw in.error("write it out: " + name.text + " = " + name.text + " " + sign + " ...");
      throw in.error("expected '=' after '" + name.text + "', found '" + sign + "'");
    }
  in.expect("=", "after '" + name.text + "'");
  if (in.at("=")) throw in.error("an assignment is written with one =");
  Statement s;
  s.name = name.text;
  s.place = name.place;
  s.value = in.expression();
  in.expect_end("the statement");
  blocks_.back()->push_back(std::move(s));
}

void StatementReader::read_solve(TokenReader& in) {
  Statement s;
  s.kind = Statement::Kind::solve;
  s.place = in.take().place;
  do {
    const Token name = in.expect_name("the name of the unknown after solve");
    if (!in.at(":")) {
      const bool first = s.unknowns.empty();
      throw in.error((first ? "an unknown has a dimension: solve " : "after & stands another unknown: ") +
                     name.text + " : L/T^2 = ...");
    }
    in.take();
    const Dimension dimension = in.dimension();
    in.expect("=", "after the dimension");
    s.unknowns.push_back({name.text, dimension, in.expression(), name.place});
  } while (in.take_if("&"));
  in.expect_end("the solve");
  blocks_.back()->push_back(std::move(s));
}

void StatementReader::open_substeps(TokenReader& in) {
  for (const Opened& outer : opened_)
    throw in.error(outer.word == "when" ? "substeps cannot stand inside when"
                                        : "substeps cannot stand inside substeps");
  if (!in_step_) throw in.error("substeps stands in the step block");
  Statement s;
  s.kind = Statement::Kind::substeps;
  s.place = in.take().place;
  s.value = in.expression();
  open_braces(std::move(s), in, "after the number of substeps");
}

/// when speed > S {
void StatementReader::open_when(TokenReader& in) {
  if (!opened_.empty() && opened_.back().word == "when") throw in.error("when cannot stand inside when");
  if (!in_step_) throw in.error("when stands in the step block");
  Statement s;
  s.kind = Statement::Kind::when;
  s.place = in.take().place;
  if (in.peek().text != "speed") throw in.error("what when compares is the speed: when speed > 0.01 {");
  in.take();
  in.expect(">", "after 'when speed'");
  s.value = in.expression();
  open_braces(std::move(s), in, "after the speed");
}

void StatementReader::read_limit(TokenReader& in) {
  if (!in_step_) throw in.error("limit stands in the step block");
  Statement s;
  s.place = in.take().place;
  const std::string& what = in.peek().text;
  if (what != "speed" && what != "move")
    throw in.error("what is limited is the speed or the move of a step: limit speed 500, limit move 2");
  s.kind = what == "speed" ? Statement::Kind::limit_speed : Statement::Kind::limit_move;
  in.take();
  s.value = in.expression();
  in.expect_end("the limit");
  blocks_.back()->push_back(std::move(s));
}

void StatementReader::open_braces(Statement s, TokenReader& in, const std::string& where) {
  in.expect("{", where);
  const std::string word = s.kind == Statement::Kind::when ? "when" : "substeps";
  opened_.push_back({s.place, word});
  blocks_.back()->push_back(std::move(s));
  blocks_.push_back(&blocks_.back()->back().body);
  if (!in.at_end()) throw in.error("what follows '{' stands on lines of its own");
}

void StatementReader::close_braces(TokenReader& in) {
  if (opened_.empty()) throw in.error("this } closes nothing");
  in.take();
  in.expect_end("'}'");
  blocks_.pop_back();
  opened_.pop_back();
}

}  // namespace shortfall
