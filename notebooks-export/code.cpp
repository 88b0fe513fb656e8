// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code.hpp"

#include <algorithm>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump_launch.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/code_step.hpp"
#include "notebooks-export/code_template.hpp"

namespace shortfall {

namespace {

using Lines = std::vector<std::string>;

/// A number for a comment: short where it is exact, six digits otherwise.
std::string in_words(const Rational& value) {
  for (int places = 0; places <= 8; ++places)
    if (std::string text = value.decimal(places); Rational::parse(text) == value) return text;
  return "about " + value.significant(6);
}

Lines about(const Flight& flight, const Rational& g, const LaunchCorrection& correction) {
  const std::string name = flight.program().name;
  const std::string frame =
      flight.substeps() == 1 ? "" : ", " + std::to_string(flight.substeps()) + " substeps a frame,";
  Lines lines{"Launch velocities for a jump of a body that is moved by " + name + frame +
              " under constant gravity."};
  const std::string formula = print(
      replace(replace(correction.formula, "g", shortfall::name("gravity")), "h", shortfall::name("dt")));
  const Rational value = correction.value(g);
  const std::string at = " m/s at gravity = " + in_words(g) + " m/s^2, dt = " + in_words(flight.dt()) + " s";
  if (value.is_zero()) {
    lines.push_back(
        "With sqrt(2*gravity*height) every frame is on the exact parabola (proved): there is nothing to "
        "correct.");
  } else {
    lines.push_back("With sqrt(2*gravity*height) alone it is, after a time t, too " +
                    std::string(value.sign() > 0 ? "low" : "high") + " by t times " + in_words(value.abs()) +
                    at + ".");
    lines.push_back("The correction " + formula +
                    " is added to the launch; then every frame is on the exact parabola (proved).");
  }
  lines.push_back(
      "Set the velocity, or give impulse = mass * velocity. Metres, seconds; gravity is positive and points "
      "down.");
  lines.push_back("Written by shortfall. What it writes is yours.");
  return lines;
}

Lines constants(const std::set<std::string>& names, const Flight& flight, Language language) {
  Lines lines;
  for (const Parameter& p : flight.program().parameters) {
    if (!names.contains(p.name)) continue;
    const std::string constant = constant_identifier(p.name, language);
    const std::string value = literal(flight.parameters().at(p.name), language);
    switch (language) {
      case Language::csharp:
        lines.push_back("const float " + constant + " = " + value + ";");
        break;
      case Language::cpp:
        lines.push_back("constexpr float " + constant + " = " + value + ";");
        break;
      case Language::gdscript:
        lines.push_back("const " + constant + " := " + value);
        break;
      case Language::python:
        lines.push_back(constant + " = " + value);
        break;
      case Language::rust:
        lines.push_back("const " + constant + ": f32 = " + value + ";");
        break;
      case Language::javascript:
        lines.push_back("const " + constant + " = " + value + ";");
        break;
    }
  }
  if (!lines.empty()) lines.insert(language == Language::csharp ? lines.end() : lines.begin(), "");
  return lines;
}

std::string correction_line(const std::string& value, Language language) {
  switch (language) {
    case Language::csharp:
      return "float correction = " + value + ";";
    case Language::cpp:
      return "const float correction = " + value + ";";
    case Language::gdscript:
      return "var correction := " + value;
    case Language::python:
      return "correction = " + value;
    case Language::rust:
      return "let correction: f32 = " + value + ";";
    case Language::javascript:
      return "const correction = " + value + ";";
  }
  return {};
}

std::string dt_parameter(Language language, const std::string& dt) {
  switch (language) {
    case Language::csharp:
    case Language::cpp:
      return ", float dt = " + dt;
    case Language::gdscript:
      return ", dt: float = " + dt;
    case Language::python:
      return ", dt=" + dt;
    case Language::rust:
      return ", dt: f32";
    case Language::javascript:
      return ", dt = " + dt;
  }
  return {};
}

}  // namespace

std::string jump_code(const Flight& flight, const Rational& g, Language language,
                      const std::optional<Rational>& height) {
  const LaunchCorrection correction = launch_correction(flight);
  if (!correction.exists)
    throw Undefined("there is no launch correction of " + flight.program().name +
                    ", and so no code for it: " + correction.reason +
                    ". The launch for one height stands in `shortfall jump`");
  const CodeStep step = code_step(flight.program(), flight.parameters(), language);
  std::set<std::string> parameters(step.parameters.begin(), step.parameters.end());
  std::map<std::string, std::string> names{{"h", "dt"}, {"g", "gravity"}};
  for (const Parameter& p : flight.program().parameters) {
    names[p.name] = constant_identifier(p.name, language);
    if (mentions(correction.formula, p.name)) parameters.insert(p.name);
  }
  const bool uses_dt = mentions(correction.formula, "h");
  const std::string dt = literal(flight.dt(), language);
  std::string heights;
  std::vector<Rational> checked{Rational(2, 5), Rational(17, 10), Rational(10)};
  if (height) checked = {*height};
  for (const Rational& h : checked) heights += (heights.empty() ? "" : ", ") + literal(h, language);
  Lines correction_lines;
  const bool needed = !is_number(correction.formula, 0);
  if (needed)
    correction_lines.push_back(correction_line(code(correction.formula, language, names), language));
  const char* tolerance = !is_binary32(language) ? "1e-9" : language == Language::rust ? "1e-4" : "1e-4f";
  const bool exponential =
      std::ranges::any_of(step.step, [](const std::string& line) { return line.find("exp(") != line.npos; });
  return filled(code_template("jump", language),
                {{"exp", {exponential ? ", exp" : ""}},
                 {"about", about(flight, g, correction)},
                 {"constants", constants(parameters, flight, language)},
                 {"correction", correction_lines},
                 {"plus_correction", {needed ? " + correction" : ""}},
                 {"g", {literal(g, language)}},
                 {"dt", {dt}},
                 {"dt_parameter", {uses_dt ? dt_parameter(language, dt) : ""}},
                 {"dt_argument", {uses_dt ? ", dt" : ""}},
                 {"start", step.start},
                 {"step", step.step},
                 {"mut", {step.velocity_changes ? "mut " : ""}},
                 {"position", {step.position}},
                 {"heights", {heights}},
                 {"tolerance", {tolerance}}});
}

std::string code_name(const CodeFunction& function, Language language) {
  if (language == Language::csharp) return constant_identifier(function.name, language);
  return language == Language::javascript ? identifier(function.name, language) : function.name;
}

std::string code(const CodeFunction& function, Language language) {
  const std::map<std::string, std::string> names{{"h", "dt"}};
  const std::string comment = language == Language::python || language == Language::gdscript ? "# " : "// ";
  std::string text;
  for (const std::string& line : function.about) text += comment + line + "\n";
  const std::string name = code_name(function, language);
  std::string arguments;
  for (const std::string& letter : function.arguments) {
    const std::string argument = letter == "h" ? "dt" : identifier(letter, language);
    if (!arguments.empty()) arguments += ", ";
    switch (language) {
      case Language::csharp:
      case Language::cpp:
        arguments += "float " + argument;
        break;
      case Language::gdscript:
        arguments += argument + ": float";
        break;
      case Language::rust:
        arguments += argument + ": f32";
        break;
      case Language::python:
      case Language::javascript:
        arguments += argument;
        break;
    }
  }
  const std::string value = code(function.value, language, names);
  switch (language) {
    case Language::csharp:
      return text + "static float " + name + "(" + arguments + ")\n{\n    return " + value + ";\n}\n";
    case Language::cpp:
      return text + "inline float " + name + "(" + arguments + ") {\n  return " + value + ";\n}\n";
    case Language::gdscript:
      return text + "static func " + name + "(" + arguments + ") -> float:\n\treturn " + value + "\n";
    case Language::python:
      return text + "def " + name + "(" + arguments + "):\n    return " + value + "\n";
    case Language::rust:
      return text + "pub fn " + name + "(" + arguments + ") -> f32 {\n    " + value + "\n}\n";
    case Language::javascript:
      return text + "function " + name + "(" + arguments + ") {\n  return " + value + ";\n}\n";
  }
  return {};
}

}  // namespace shortfall
