// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/head.hpp"

#include "analysis/program/algebraic_root.hpp"

namespace shortfall {

namespace {

void read_parameter(Program& program, TokenReader& in) {
  const Token name = in.expect_name("the name of a parameter");
  const bool typed = in.take_if(":");
  const Dimension dimension = typed ? in.dimension() : kPure;
  if (!in.at("=")) throw in.error("a parameter has a default: param " + name.text + " = 1/4");
  in.take();
  program.parameters.push_back({name.text, dimension, in.expression(), name.place});
  in.expect_end("the default");
}

void read_state(Program& program, TokenReader& in) {
  const Token name = in.expect_name("the name of a state");
  if (!in.take_if(":")) throw in.error("a state has a dimension: state " + name.text + " : L/T^2");
  program.states.push_back({name.text, in.dimension(), name.place});
  if (in.at("="))
    throw in.error("the first value of a state stands in a start block: " + name.text + " = ...");
  in.expect_end("the dimension");
}

void read_root(Program& program, TokenReader& in) {
  Root root;
  const Token name = in.expect_name("the name of a root");
  root.name = name.text;
  root.place = name.place;
  const std::string example = "a root is written: root " + name.text + " of " + name.text + "^3 = 2";
  if (in.peek().text != "of") throw in.error(example);
  in.take();
  root.left = in.expression();
  if (!in.at("=")) throw in.error(example);
  in.take();
  root.right = in.expression();
  if (in.peek().kind == Token::Kind::name && in.peek().text == "near") {
    in.take();
    root.near = in.signed_number("the number that the root is near to").value;
  }
  in.expect_end("the equation of a root");
  root.value = chosen_root(root, in);
  program.roots.push_back(std::move(root));
}

void read_approximation(Program& program, TokenReader& in) {
  const Token name = in.expect_name("the name of a coefficient");
  if (!in.at("="))
    throw in.error("a coefficient known to some digits is written: approx " + name.text +
                   " = 0.1786178958448091");
  in.take();
  const auto decimal = in.signed_number("a decimal, with all the digits that are known");
  if (decimal.text.find('.') == std::string::npos)
    throw in.error(decimal.place,
                   "the number is exact; approx takes a decimal with the digits that are known");
  in.expect_end("the decimal");
  program.approximations.push_back({name.text, decimal.value, decimal.text, name.place});
}

void read_impulse(Program& program, TokenReader& in) {
  const Token name = in.expect_name("the name of the impulse");
  if (program.impulse)
    throw in.error(name.place, "there is already an impulse, '" + program.impulse->name + "'");
  if (!in.take_if(":")) throw in.error("an impulse is divided by the mass: impulse " + name.text + " : L/T");
  const Place place = in.peek().place;
  const Dimension dimension = in.dimension();
  if (dimension != kVelocity)
    throw in.error(place, "an impulse divided by the mass is a velocity, L/T, not " + dimension.str());
  in.expect_end("the dimension");
  program.impulse = State{name.text, dimension, name.place};
}

void read_assumption(Program& program, TokenReader& in, Place place) {
  Assumption assumption;
  assumption.place = place;
  assumption.left = in.expression();
  if (!in.at(">") && !in.at("<")) throw in.error("an assumption compares two values: assume 1 - c*h > 0");
  assumption.less = in.take().text == "<";
  assumption.right = in.expression();
  in.expect_end("the assumption");
  program.assumptions.push_back(std::move(assumption));
}

}  // namespace

const std::vector<std::string>& head_words() {
  static const std::vector<std::string> words{"alias", "source",  "param", "root",   "approx",
                                              "state", "impulse", "hold",  "assume", "solves"};
  return words;
}

void read_declaration(Program& program, const std::string& word, TokenReader& in, Place place) {
  if (word == "param") return read_parameter(program, in);
  if (word == "state") return read_state(program, in);
  if (word == "root") return read_root(program, in);
  if (word == "approx") return read_approximation(program, in);
  if (word == "impulse") return read_impulse(program, in);
  if (word == "assume") return read_assumption(program, in, place);
  if (word == "hold") {
    if (in.peek().text != "a") throw in.error("what is held over a step is the force: hold a");
    in.take();
    in.expect_end("hold a");
    if (program.holds_force) throw in.error(place, "the force is already held");
    program.holds_force = true;
    return;
  }
  if (program.solves) throw in.error(place, "there is already another equation");
  program.solves = in.expression();
  in.expect_end("the acceleration");
}

}  // namespace shortfall
