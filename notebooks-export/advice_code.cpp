// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/advice_code.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "notebooks-export/code_step.hpp"
#include "notebooks-export/trade_text.hpp"

namespace shortfall {

namespace {

class Snippet {
 public:
  Snippet(Language language, bool in_binary64) : language_(language), in_binary64_(in_binary64) {}

  void comment(const std::string& text) {
    const bool hash = language_ == Language::python || language_ == Language::gdscript;
    text_ += (hash ? "# " : "// ") + text + "\n";
  }
  void lines(const std::vector<std::string>& all) {
    for (const std::string& l : all) text_ += l + "\n";
  }
  /// What is added to x and v: code where it is a kick by the force itself, a formula for what needs
  /// derivatives.
  void terms(const std::vector<FieldTerm>& all) {
    const bool semicolon = language_ != Language::python && language_ != Language::gdscript;
    for (const FieldTerm& t : all) {
      const std::string target = identifier(t.component, language_);
      if (t.tree != "a" && t.tree != "v" && t.tree != "v[a]") {
        comment(t.component + " += " + t.coefficient.constant().str() + "*dt^" + std::to_string(t.power) +
                " * (" + t.differential + "), all of it at the old x and v");
        continue;
      }
      Expr weight = number(t.coefficient.constant());
      for (int k = 0; k < t.power; ++k) weight = weight * name("dt");
      const Expr what = t.tree == "v" ? name("v") : call(kCalledForce, {name("x"), name("v"), name("t")});
      const Expr added = weight * what;
      const std::map<std::string, std::string> names{{"dt", "dt"}};
      text_ += target + " = " + target + " + " +
               (in_binary64_ ? code_in_binary64(added, language_, names) : code(added, language_, names)) +
               (semicolon ? ";" : "") + "\n";
    }
  }
  std::string text() const { return text_; }

 private:
  Language language_;
  bool in_binary64_;
  std::string text_;
};

}  // namespace

std::string advice_code(const Advice& advice, Language language) {
  if (!advice.best) throw Unable("nothing is advised, so there is no code for it");
  const StepChoice& choice = advice.best->choice;
  const Program program = find_integrator(choice.integrator);
  Values parameters = parameter_values(program, choice.parameters);
  const bool in_binary64 = choice.format == "f64";
  const CodeStep step = code_step(program, parameters, language, ForceInCode::called, in_binary64);
  std::string kept;
  for (const ForceEffect& e : advice.effects)
    if (!e.dropped) kept += (kept.empty() ? "" : " + ") + e.name;
  Snippet s(language, in_binary64);
  s.comment(program.name + " for: " + (advice.scene.title.empty() ? advice.scene.name : advice.scene.title));
  s.comment("acceleration(x, v, t) is yours: " + kept +
            ". x, v and what it returns are vectors, or one coordinate, of " + (in_binary64 ? "f64" : "f32") +
            " numbers.");
  s.comment(
      "dt = " + short_number(choice.frame / Rational(choice.substeps)) + " " + advice.scene.units.time +
      (choice.substeps > 1 ? ", " + std::to_string(choice.substeps) + " steps a frame" : std::string()) +
      "; after every step t grows by dt.");
  for (const std::string& p : step.parameters)
    s.comment(constant_identifier(p, language) + " = " + parameters.at(p).str());
  if (!step.start.empty() || choice.launch) s.comment("Once, before the first step:");
  if (choice.launch) s.terms(choice.launch->launch);
  s.lines(step.start);
  s.comment("Every step:");
  s.lines(step.step);
  if (step.position != identifier("x", language)) s.comment("The position to show is " + step.position + ".");
  if (choice.launch && !choice.launch->read_out.empty()) {
    s.comment("For what is shown only; the steps go on from the old x and v:");
    s.terms(choice.launch->read_out);
  }
  return s.text();
}

}  // namespace shortfall
