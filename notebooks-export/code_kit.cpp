// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_kit.hpp"

#include <algorithm>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/code.hpp"

namespace shortfall {

namespace {

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

/// What a check gives to the argument with this number: short in binary, none of them alike.
Rational sample(std::size_t argument) { return Rational(static_cast<long>(2 * argument) + 3, 8); }

/// A call with the samples, and what it has to be; none for a formula of more than sums, products and
/// quotients.
std::optional<std::pair<std::string, std::string>> checked_call(const CodeFunction& f, Language language) {
  Expr at = f.value;
  std::string arguments;
  for (std::size_t i = 0; i < f.arguments.size(); ++i) {
    at = replace(at, f.arguments[i], number(sample(i)));
    arguments += (i ? ", " : "") + literal(sample(i), language);
  }
  const std::optional<Rational> expected = literal_value(at);
  if (!expected) return std::nullopt;
  return std::pair(code_name(f, language) + "(" + arguments + ")",
                   decimal_literal(expected->to_double(), language));
}

/// A function that says whether all the others give what they gave here.
std::string self_check(const std::vector<CodeFunction>& functions, Language language) {
  std::vector<std::pair<std::string, std::string>> calls;
  for (const CodeFunction& f : functions)
    if (auto call = checked_call(f, language)) calls.push_back(std::move(*call));
  if (calls.empty()) return {};
  const char* about = "Whether the functions above give what they gave in shortfall.";
  std::string text =
      std::string(language == Language::python || language == Language::gdscript ? "\n# " : "\n// ") + about +
      "\n";
  const auto listed = [&](const std::string& open, const std::string& close, const std::string& indent) {
    std::string list;
    for (const auto& [call, expected] : calls) list += indent + open + call + ", " + expected + close + ",\n";
    return list;
  };
  const auto all = [&](const std::string& near) {
    std::string list;
    for (const auto& [call, expected] : calls)
      list += (list.empty() ? "" : "\n        && ") + near + "(" + call + ", " + expected + ")";
    return list;
  };
  switch (language) {
    case Language::python:
      return text + "def self_check():\n    pairs = [\n" + listed("(", ")", "        ") +
             "    ]\n    return all(abs(value - expected) <= 1e-13 * (1 + abs(expected)) for value, expected "
             "in pairs)\n\n\n"
             "if __name__ == \"__main__\":\n    assert self_check()\n";
    case Language::gdscript:
      return text + "static func self_check() -> bool:\n\tvar pairs := [\n" + listed("[", "]", "\t\t") +
             "\t]\n\tfor pair in pairs:\n\t\tif abs(pair[0] - pair[1]) > 1e-6 * (1.0 + "
             "abs(pair[1])):\n\t\t\treturn false\n"
             "\treturn true\n";
    case Language::rust:
      return text + "pub fn self_check() -> bool {\n    let pairs: [(f32, f32); " +
             std::to_string(calls.size()) + "] = [\n" + listed("(", ")", "        ") +
             "    ];\n    pairs.iter().all(|(value, expected)| (value - expected).abs() <= 1e-5 * (1.0 + "
             "expected.abs()))\n}\n\n"
             "#[cfg(test)]\nmod tests {\n    #[test]\n    fn functions_give_what_they_should() {\n"
             "        assert!(super::self_check());\n    }\n}\n";
    case Language::javascript:
      return text + "function selfCheck() {\n  const pairs = [\n" + listed("[", "]", "    ") +
             "  ];\n  return pairs.every(([value, expected]) => Math.abs(value - expected) <= 1e-13 * (1 + "
             "Math.abs(expected)));\n}\n";
    case Language::cpp:
      return text +
             "inline bool self_check() {\n  const auto near = [](float value, float expected) {\n"
             "    const float off = value - expected, size = expected < 0 ? -expected : expected;\n"
             "    return (off < 0 ? -off : off) <= 1e-5f * (1 + size);\n  };\n  return " +
             all("near") + ";\n}\n";
    case Language::csharp:
      return text + "static bool SelfCheck()\n{\n    return " + all("Near") +
             ";\n}\n\nstatic bool Near(float value, float expected)\n{\n    float off = value - expected, "
             "size = expected < 0 ? "
             "-expected : expected;\n    return (off < 0 ? -off : off) <= 1e-5f * (1 + size);\n}\n";
  }
  return {};
}

}  // namespace

std::string kit_code(const CorrectionKit& kit, const Derivation& d, Language language) {
  const CorrectionOption* best = kit.best();
  if (!best)
    throw Undefined(kit.needed ? "there is no correction to write: " + kit.options.front().obstruction
                               : "there is nothing to correct: " + d.integrator + " is exact for this force");
  std::string text;
  std::vector<CodeFunction> functions;
  for (const Correction& c : best->corrections) {
    CodeFunction function;
    function.name = function_name(c);
    function.about = {
        d.integrator + ", force f0 + f1*t + ... of degree " + std::to_string(d.degree) +
            (d.substeps > 1 ? ", " + std::to_string(d.substeps) + " substeps" : "") + ": " + c.series +
            ", exact for every step.",
        target_words(c) + (c.kind == Correction::Kind::read_out && c.target == "x" && mentions(c.add, "v")
                               ? " Here v is the corrected velocity."
                               : "")};
    collect_names(c.add, function.arguments);
    std::stable_partition(function.arguments.begin(), function.arguments.end(),
                          [](const std::string& name) { return name != "h" && name != "t"; });
    function.value = c.add;
    text += (text.empty() ? "" : "\n") + code(function, language);
    functions.push_back(std::move(function));
  }
  text += self_check(functions, language);
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
