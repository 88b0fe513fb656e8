// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/damping_report.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/token_reader.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kDampingBits = 256;

/// v <- share v + push a, x <- x + drift v + fall a.
struct VelocityMap {
  Fraction share, push, drift;
};

VelocityMap velocity_map(const StepMap& map, const std::string& integrator) {
  const auto refuse = [&](const std::string& why) {
    throw Unable("the damping of '" + integrator + "' is no factor of the velocity alone: " + why);
  };
  const LinearForm& v = map.step[1];
  if (!v[0].is_zero()) refuse("it depends on the position");
  // A further carried vector is nothing when each step leaves it at 0.
  for (int s = 2; s < map.force.states; ++s)
    if (!v[s].is_zero() && !map.step[s].is_zero()) refuse("'" + map.states[s] + "' is carried along");
  const Fraction& push = v[map.force.force_column(0)];
  if (push.contains(kCount)) refuse("it depends on the time");
  if (!(map.velocity == LinearForm::column(1))) refuse("what is reported is not what is carried");
  return {v[1], push, map.step[0][1]};
}

std::map<std::string, Ball> letter_values(const StepMap& map, const Values& parameters, const Rational& h) {
  std::map<std::string, Ball> values{{"h", Ball(h, kDampingBits)}};
  for (const auto& [name, value] : parameters) values[name] = Ball(value, kDampingBits);
  for (const ExtraLetters::Extra& e : map.extras)
    if (e.root) values[e.name] = Ball(near(*e.root, 100), kDampingBits);
  return values;
}

DampingAtRate at_rate(const Program& program, const Values& parameters, const Rational& h, const Rational& g,
                      int substeps) {
  const StepMap map = [&] {
    try {
      return step_map(lower(substepped(program, substeps), parameters), 0, {}, {}, Fraction(h));
    } catch (const Undefined& e) {  // (1 - c)^h with c > 1
      throw BadInput("'" + program.name +
                     "' has no number for what these parameters leave of a velocity: " + e.what());
    }
  }();
  const NumberField field(map.generators);
  const VelocityMap m = velocity_map(map, program.name);
  const Wording w{map.letters, "n", false};
  const auto values = letter_values(map, parameters, h);
  const auto ball = [&](const Fraction& f) { return ball_value(formula(f, w), values, kDampingBits); };
  const Ball one(1, kDampingBits);
  DampingAtRate r{h, ball(m.share), {}, {}, {}, {}};
  if (!r.share.is_finite())
    throw BadInput("'" + program.name + "' has no number for what these parameters leave of a velocity");
  const Ball lost = one - r.share;
  if (m.share.is_one())
    throw BadInput("'" + program.name +
                   "' does not damp with these parameters; give a damping, as in --param c=0.5" +
                   (program.solves || program.parameter("c")
                        ? ""
                        : "; and it has no damping of its own: see derive --force drag"));
  if (lost.sign() == -1)
    throw BadInput("a damping is 0 or more: here '" + program.name + "' makes a velocity grow");
  r.terminal = Ball(g, kDampingBits) * ball(m.push) / lost;
  r.coast = ball(m.drift) / lost;
  if (r.share.sign() == 1) {
    const Ball log_share = log(r.share);
    r.rate = -log_share / Ball(h, kDampingBits);
    r.kept = exp(log_share / Ball(h, kDampingBits));
  } else {
    // Frames that stop a body, or turn it round: whole powers only.
    const Rational frames = (Rational(1) / h).floor();
    std::int64_t n = 0;
    frames.fits_int64(n);
    r.kept = pow(r.share, static_cast<int>(std::min<std::int64_t>(n, 1'000'000)));
  }
  return r;
}

Expr expression(const std::string& text) {
  const Source source("a formula", text);
  int line = 1;
  return TokenReader(source, tokens(source, line, 0)).expression();
}

}  // namespace

DampingReport damping_report(const Program& program, const Values& given, const Rational& h,
                             const Rational& g, int substeps) {
  DampingReport report;
  report.integrator = program.name;
  report.parameters = parameter_values(program, given);
  report.substeps = substeps;
  report.g = g;
  report.solves = program.solves;
  for (const auto& [name, value] : given)
    if (value.sign() < 0 && program.parameter(name))
      throw BadInput("--param " + name + "=" + value.str() + ": a damping is 0 or more");
  report.here = at_rate(program, report.parameters, h, g, substeps);
  for (const int hertz : {30, 60, 120, 144})
    report.rates.push_back(at_rate(program, report.parameters, Rational(1, hertz), g, substeps));

  // The formulas, with the parameters that have to be numbers as these numbers.
  Values fixed;
  const Tape tape = lower(substepped(program, substeps));
  for (const Tape::ParameterSlot& p : tape.parameters)
    if (p.fixed) fixed[p.name] = report.parameters.at(p.name);
  const StepMap map = step_map(lower(substepped(program, substeps), fixed), 0);
  const NumberField field(map.generators);
  const VelocityMap m = velocity_map(map, program.name);
  const Wording w{map.letters, "n", false};
  report.share = formula(m.share, w);
  report.terminal = formula(m.push / (Fraction(1) - m.share), name("g"), w);
  report.coast = formula(m.drift / (Fraction(1) - m.share), w);
  for (const std::string& text : map.assumed)
    if (text.find("impulse") == std::string::npos) report.assumptions.push_back(text);
  auto values = letter_values(map, report.parameters, h);
  const Ball share = ball_value(report.share, values, kDampingBits);
  report.assumed_hold = share.overlaps(report.here.share);

  if (program.solves) {
    ExtraLetters extras(letter_names(lower(program, fixed)));
    const OwnEquation own = own_equation(program, fixed, extras);
    const Expr rate = formula(own.damping, {extras.names(), "n", false});
    report.true_rate = ball_value(rate, values, kDampingBits);
    if (report.true_rate->sign() == 1) report.true_terminal = Ball(g, kDampingBits) / *report.true_rate;
  }
  return report;
}

std::string name_of(DampingConvention convention) {
  static const char* const names[] = {"linear", "implicit", "power", "exponential", "per-frame"};
  return names[static_cast<int>(convention)];
}

Expr share_of(DampingConvention convention) {
  static const char* const shares[] = {"1 - c*h", "1/(1 + c*h)", "pow(1 - c, h)", "exp(-c*h)", "1 - c"};
  return expression(shares[static_cast<int>(convention)]);
}

Expr damping_from_share(DampingConvention to) {
  static const char* const numbers[] = {"(1 - s)/h", "(1/s - 1)/h", "1 - pow(s, 1/h)", "-log(s)/h", "1 - s"};
  return expression(numbers[static_cast<int>(to)]);
}

Ball damping_number(DampingConvention to, const Ball& share, const Rational& h) {
  return ball_value(damping_from_share(to), {{"s", share}, {"h", Ball(h, kDampingBits)}}, kDampingBits);
}

Expr converted_damping(DampingConvention from, DampingConvention to) {
  // Rows: from; columns: to. Each entry is damping_from_share(to) at share_of(from), simplified by hand and
  // tested against that.
  static const char* const table[kDampingConventions][kDampingConventions] = {
      {"c", "c/(1 - c*h)", "1 - pow(1 - c*h, 1/h)", "-log(1 - c*h)/h", "c*h"},
      {"c/(1 + c*h)", "c", "1 - pow(1 + c*h, -1/h)", "log(1 + c*h)/h", "c*h/(1 + c*h)"},
      {"(1 - pow(1 - c, h))/h", "(pow(1 - c, -h) - 1)/h", "c", "-log(1 - c)", "1 - pow(1 - c, h)"},
      {"(1 - exp(-c*h))/h", "(exp(c*h) - 1)/h", "1 - exp(-c)", "c", "1 - exp(-c*h)"},
      {"c/h", "c/(h*(1 - c))", "1 - pow(1 - c, 1/h)", "-log(1 - c)/h", "c"},
  };
  return expression(table[static_cast<int>(from)][static_cast<int>(to)]);
}

}  // namespace shortfall
