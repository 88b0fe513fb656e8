// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_kit.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/code.hpp"

namespace shortfall {

namespace {

/// The names in an expression, as they come.
void collect(const Expr& e, std::vector<std::string>& names) {
  if (e->op == Expression::Op::name && std::ranges::find(names, e->name) == names.end())
    names.push_back(e->name);
  for (const Expr& operand : e->operands) collect(operand, names);
}

std::string target_words(const Correction& c) {
  switch (c.kind) {
    case Correction::Kind::launch:
      return "Add it to " + c.target + " once, before the first step.";
    case Correction::Kind::read_out:
      return "Add it to the " + std::string(c.target == "x" ? "position" : "velocity") +
             " that you show at time t; go on with the integrator's own.";
    case Correction::Kind::force:
      return "Add it to the force (divided by the mass) at time t.";
    case Correction::Kind::term:
      return "Add it to the " + std::string(c.target == "x" ? "position" : "velocity") +
             " at the end of the step that began at time t.";
  }
  return "";
}

std::string function_name(const Correction& c) {
  std::string name = kind_name(c.kind);
  std::ranges::replace(name, '-', '_');
  const bool x = c.target.starts_with("x");
  return name + (c.kind == Correction::Kind::force ? "_correction" : x ? "_position" : "_velocity");
}

}  // namespace

std::string kit_code(const CorrectionKit& kit, const Derivation& d, Language language) {
  const CorrectionOption* best = kit.best();
  if (!best)
    throw Undefined(kit.needed ? "there is no correction to write: " + kit.options.front().obstruction
                               : "there is nothing to correct: " + d.integrator + " is exact for this force");
  std::string text;
  for (const Correction& c : best->corrections) {
    CodeFunction function;
    function.name = function_name(c);
    function.about = {d.integrator + ", force f0 + f1*t + ... of degree " + std::to_string(d.degree) +
                          (d.substeps > 1 ? ", " + std::to_string(d.substeps) + " substeps" : "") + ": " +
                          c.series + ", exact for every step.",
                      target_words(c)};
    collect(c.add, function.arguments);
    std::ranges::stable_partition(function.arguments,
                                  [](const std::string& name) { return name != "h" && name != "t"; });
    function.value = c.add;
    text += (text.empty() ? "" : "\n") + code(function, language);
  }
  if (language != Language::csharp) return text;
  std::string wrapped = "public static class Correction\n{\n";
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    const std::string line = text.substr(begin, end - begin);
    wrapped += (line.empty() ? "" : line.starts_with("static ") ? "    public " : "    ") + line + "\n";
    begin = end + 1;
  }
  return wrapped + "}\n";
}

}  // namespace shortfall
