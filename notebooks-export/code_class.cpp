// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_class.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/problems/first_steps.hpp"
#include "analysis/program/cpp_names.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"
#include "notebooks-export/code_step.hpp"
#include "notebooks-export/code_template.hpp"

namespace shortfall {

namespace {

using Lines = std::vector<std::string>;

std::string with_dt(const Expr& e) { return print(replace(e, "h", name("dt"))); }

/// What it gets wrong, in the letters of the code; nothing where that has no closed form.
void add_shortfall(const Program& program, const Values& given, Lines& about) {
  try {
    const Derivation d = derivation(program, 0, given, 1, false);
    const CorrectionKit kit = correction_kit(d);
    if (!kit.needed) {
      about.push_back("Under a constant acceleration a it is exact at every step (proved).");
      return;
    }
    about.push_back("Under a constant acceleration a, exact minus computed after a time t is " +
                    with_dt(d.shortfall_position) + " for x and " + with_dt(d.shortfall_velocity) +
                    " for v.");
    if (const CorrectionOption* best = kit.best())
      for (const Correction& c : best->corrections)
        about.push_back(std::string(kind_name(c.kind)) + ": " + with_dt(c.add) + " added to " + c.target +
                        " repairs it; " + c.reason + ".");
  } catch (const Error&) {  // a damping of its own, say: what it means by that is no constant acceleration
  }
}

Lines about(const Program& program, const Values& given, Language language) {
  Lines lines{program.name +
              ", one coordinate of a body; written by shortfall, and what it writes is yours."};
  for (std::size_t begin = 0; begin < program.description.size();) {
    const std::size_t end = std::min(program.description.find('\n', begin), program.description.size());
    lines.push_back(program.description.substr(begin, end - begin));
    begin = end + 1;
  }
  add_shortfall(program, given, lines);
  lines.push_back(std::string("Its numbers are ") + (is_binary32(language) ? "binary32" : "binary64") +
                  "; every operation rounds once, in the order of " + program.name + "'s file.");
  return lines;
}

bool calls(const Expr& e) { return e->op == Expression::Op::call || std::ranges::any_of(e->operands, calls); }

/// The parameters that occur, and those of which their defaults are made. A default is computed by its own
/// operations where the language computes constants.
Lines constants(std::set<std::string> needed, const Program& program, const Values& given,
                const Values& values, Language language) {
  for (auto p = program.parameters.rbegin(); p != program.parameters.rend(); ++p)
    for (const Parameter& other : program.parameters)
      if (needed.contains(p->name) && mentions(p->fallback, other.name)) needed.insert(other.name);
  std::map<std::string, std::string> names;
  Lines lines;
  for (const Parameter& p : program.parameters) {
    if (!needed.contains(p.name)) continue;
    const std::string left = names[p.name] = constant_identifier(p.name, language);
    const bool by_value = given.contains(p.name) || calls(p.fallback);
    const std::string right =
        by_value ? literal(values.at(p.name), language) : code(p.fallback, language, names);
    switch (language) {
      case Language::csharp:
        lines.push_back("private const float " + left + " = " + right + ";");
        break;
      case Language::cpp:
        lines.push_back("static constexpr float " + left + " = " + right + ";");
        break;
      case Language::gdscript:
        lines.push_back("const " + left + " := " + right);
        break;
      case Language::python:
        lines.push_back(left + " = " + right);
        break;
      case Language::rust:
        lines.push_back("const " + left + ": f32 = " + right + ";");
        break;
      case Language::javascript:
        lines.push_back("const " + left + " = " + right + ";");
        break;
    }
  }
  return lines;
}

/// The carried vectors as declarations of members, one a line.
Lines declarations(const Lines& states, Language language) {
  Lines lines;
  for (const std::string& s : states)
    lines.push_back(language == Language::cpp        ? "float " + s + "{};"
                    : language == Language::gdscript ? "var " + s + ": float"
                                                     : "pub " + s + ": f32,");
  return lines;
}

}  // namespace

std::string integrator_code(const Program& whole, const Values& given, int substeps, Language language) {
  Program program = substeps == 1 ? whole : substepped(whole, substeps);
  const Values values = parameter_values(program, given);
  const bool members =
      language == Language::csharp || language == Language::cpp || language == Language::gdscript;
  const CodeStep step = code_step_of_class(program, values, language, members);
  const FirstSteps check = first_steps(program, given, is_binary32(language), 3);
  Lines states, all{"x", "v"};
  for (const State& s : program.states) states.push_back(identifier(s.name, language));
  all.insert(all.end(), states.begin(), states.end());

  Lines pack, unpack;
  for (const std::string& s : all) {
    pack.push_back("self." + s + " = " + s + (language == Language::rust ? ";" : ""));
    unpack.push_back((language == Language::rust ? "let mut " : "") + s + " = self." + s +
                     (language == Language::rust ? ";" : ""));
  }
  Lines fields = all;
  if (language == Language::rust) fields = {"acceleration", "x", "v", "dt", "t"};
  if (language == Language::rust) fields.insert(fields.end(), states.begin(), states.end());
  Lines member_lines{comma_list(all) + ", dt, t"};
  if (language == Language::gdscript) member_lines = declarations(all, language);
  std::string function = program.name;
  for (char& c : function)
    if (c == '-') c = '_';
  return filled(code_template("class", language),
                {{"about", about(program, given, language)},
                 {"class", {cpp_class_name(program.name)}},
                 {"function", {function}},
                 {"constants", constants({step.parameters.begin(), step.parameters.end()}, program, given,
                                         values, language)},
                 {"members", member_lines},
                 {"states", declarations(states, language)},
                 {"fields", {comma_list(fields)}},
                 {"pack", pack},
                 {"unpack", unpack},
                 {"start", step.start},
                 {"step", step.step},
                 {"finish", step.finish},
                 {"position", {step.position}},
                 {"velocity", {step.velocity}},
                 {"x3", {decimal_literal(check.x.back(), language)}},
                 {"v3", {decimal_literal(check.v.back(), language)}}});
}

}  // namespace shortfall
