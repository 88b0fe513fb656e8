// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/motion/verify.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "cli/command.hpp"
#include "cli/force.hpp"
#include "cli/output.hpp"

namespace shortfall::cli {

namespace {

using Json = nlohmann::ordered_json;

Json as_json(const Verdict& v, const std::string& quantity, const Expr& claimed) {
  Json json{
      {"quantity", quantity}, {"claimed", print(claimed)}, {"proved", v.proved}, {"found", print(v.found)}};
  json["found_from"] = v.found_from;
  json["holds_from"] = v.holds_from ? Json(*v.holds_from) : Json(nullptr);
  json["undefined_at"] = Json::array();
  for (const Rational& n : v.gaps.counts) json["undefined_at"].push_back(n.str());
  json["counter_example"] = nullptr;
  if (v.counter_example) {
    Json values;
    for (const auto& [name, value] : v.counter_example->values) values[name] = value.str();
    json["counter_example"] = {{"n", v.counter_example->n},
                               {"values", values},
                               {"computed", v.counter_example->computed.str()},
                               {"claimed", v.counter_example->claimed.str()}};
  }
  return json;
}

/// " except n = 0, 3, where it divides by zero,"; empty when it does nowhere from there on.
std::string exceptions(const FormulaGaps& gaps, int from) {
  std::string text;
  for (const Rational& n : gaps.counts)
    if (n >= Rational(from)) text += (text.empty() ? " except n = " : ", ") + n.str();
  return text.empty() ? text : text + ", where it divides by zero,";
}

std::string as_text(const Verdict& v, const std::string& quantity, const Expr& claimed, Style style) {
  std::string text = quantity + " = " + print(claimed, style) + "\n";
  if (v.proved)
    return text + "  proved: it holds for every n >= 0" + exceptions(v.gaps, 0) +
           " and all values of the letters" +
           (v.gaps.of_letters ? " at which it does not divide by zero.\n" : ".\n");
  const CounterExample& c = *v.counter_example;
  text += "  refuted at n = " + std::to_string(c.n) + ":";
  std::string zero;
  for (const auto& [name, value] : c.values) {
    if (value.is_zero())
      zero += " " + name;
    else
      text += " " + name + " = " + value.str();
  }
  if (!zero.empty()) text += " (the rest 0)";
  text +=
      "\n    the integrator gives " + c.computed.str() + ", the formula " + c.claimed.str() + " (exact)\n";
  if (v.holds_from)
    return text + "  from n = " + std::to_string(*v.holds_from) + " on" + exceptions(v.gaps, *v.holds_from) +
           " it holds (proved): before that, the start is still felt\n";
  return text + "  right is: " + print(v.found, style) +
         (v.found_from > 0 ? ", for n >= " + std::to_string(v.found_from) : "") + "\n";
}

int verify(const Question& q, const std::string& x, const std::string& v) {
  if (x.empty() && v.empty())
    throw BadInput("verify takes a formula: --x \"x0 + v0*t + ...\" or --v \"v0 + a*t\"");
  const Program program = q.program();
  const Values values = q.values();
  // Of an integrator that damps itself the motion is asked for without a force -k x - c v besides.
  const Force force = without_own_equation(with_own_equation(force_named(q.force), program, values));
  const int degree = program.solves && !force.linear() ? std::max(force.degree, 0) : force_degree(q.force);
  const Names names = formula_names(program, degree);
  std::vector<std::tuple<std::string, Expr, bool>> claims;
  if (!x.empty()) claims.emplace_back("x_n", parse_formula(x, "--x", names, {Sort::vector, kLength}), true);
  if (!v.empty())
    claims.emplace_back("v_n", parse_formula(v, "--v", names, {Sort::vector, kVelocity}), false);
  const Derivation d = derivation(program, degree, values, q.substeps(), false);
  Json json{{"schema", "shortfall.verify/1"},
            {"integrator", d.integrator},
            {"force", q.force},
            {"verdicts", Json::array()}};
  std::string text;
  bool all = true;
  for (const auto& [quantity, claimed, position] : claims) {
    const Verdict found = verdict(d, program, values, claimed, position);
    all = all && found.proved;
    json["verdicts"].push_back(as_json(found, quantity, claimed));
    text += as_text(found, quantity, claimed, q.ascii ? Style::language : Style::unicode);
  }
  write_output(q.json ? json.dump(2) + "\n" : text, q.output);
  return all ? kDone : kRefuted;
}

}  // namespace

void add_verify(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Prove", "verify", "Proves or refutes a formula of yours for the motion after n steps.",
      {"verify symplectic-euler --force constant --x \"x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t\"",
       "verify rk4 --force poly:1 --v \"v0 + f0*t + 1/2*f1*t^2\""});
  auto q = std::make_shared<Question>();
  auto x = std::make_shared<std::string>();
  auto v = std::make_shared<std::string>();
  add_integrator(*command, *q);
  add_force(*command, *q);
  command->add_option("--x", *x, "the position after n steps, in x0, v0, a (or f0, f1, ...), h, t (= n h), n")
      ->type_name("FORMULA");
  command->add_option("--v", *v, "the velocity after n steps")->type_name("FORMULA");
  add_parameters(*command, *q);
  add_json(*command, *q);
  add_ascii(*command, *q);
  add_output(*command, *q);
  command->callback([q, x, v, &code] { code = verify(*q, *x, *v); });
}

}  // namespace shortfall::cli
