// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/print.hpp"
#include "cli/command.hpp"
#include "cli/correct.hpp"
#include "cli/correct_general.hpp"
#include "cli/force.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/code.hpp"
#include "notebooks-export/code_kit.hpp"
#include "notebooks-export/linear_code.hpp"
#include "notebooks-export/linear_text.hpp"
#include "notebooks-export/result_json.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall::cli {

std::string correction_code(const Question& q, const std::string& word, const std::string& height) {
  const Language language = language_of(word);
  if (is_force_class(q.force))
    throw Unable(
        "a launch for every force is given as a formula; code is printed for forces that have a formula of "
        "their own, such as --force constant, poly:D and spring");
  const Force asked = force_named(q.force);
  const Force force = with_own_equation(asked, q.program(), q.values());
  if (force.linear() && !(asked.degree == 0 && !asked.linear())) {
    if (!height.empty()) throw BadInput("--height goes with --lang and a constant force");
    return linear_kit_code(linear_kit(q.program(), asked, q.values(), q.substeps()),
                           linear_derivation(q.program(), asked, q.values(), q.substeps()), language);
  }
  const int degree = force_degree(q.force);
  if (degree == 0) {
    std::optional<Rational> aim;
    if (!height.empty()) aim = positive_quantity(height, Unit::length, "--height");
    try {
      return jump_code(Flight(q.program(), q.step(), q.substeps(), q.values()), q.gravity(), language, aim);
    } catch (const Undefined&) {
      // Where damping makes what is missing depend on the launch, the kit of the damped motion is the answer.
      if (!force.linear() || aim) throw;
      return linear_kit_code(linear_kit(q.program(), asked, q.values(), q.substeps()),
                             linear_derivation(q.program(), asked, q.values(), q.substeps()), language);
    }
  }
  if (!height.empty()) throw BadInput("--height goes with --lang and a constant force");
  const Derivation d = derivation(q.program(), degree, q.values(), q.substeps(), false);
  return kit_code(correction_kit(d), d, language);
}

namespace {

CorrectionAnswer correct_linear(const Question& q, const Program& program, const Force& force) {
  const LinearKit kit = linear_kit(program, force_named(q.force), q.values(), q.substeps());
  const Style style = q.ascii ? Style::language : Style::unicode;
  CorrectionAnswer result;
  // With numbers for the letters there are numbers to type in, too.
  std::optional<KitNumbers> numbers;
  std::string no_numbers;
  if (kit.exists && force.numeric()) {
    try {
      numbers = kit_numbers(kit, force, parameter_values(program, q.values()), q.step());
    } catch (const Unable& e) {
      no_numbers = e.what();
    }
  }
  if (q.json) {
    auto json = as_json(kit, linear_derivation(program, force_named(q.force), q.values(), q.substeps()));
    json["dt"] = q.step().str();
    json["numbers"] = numbers ? as_json(*numbers) : nlohmann::ordered_json(nullptr);
    json["numbers_obstruction"] =
        no_numbers.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(no_numbers);
    result.text = json.dump(2) + "\n";
  } else {
    std::string& text = result.text;
    text = program.name + ", force " + force.text;
    if (program.solves) text += ", the true motion with its own x'' = " + print(program.solves, style);
    text += "\n" + as_text(kit, style, q.full);
    if (numbers) text += as_text(*numbers, kit, q.step());
    if (!no_numbers.empty()) text += "  At dt = " + q.step().str() + " s none: " + no_numbers + "\n";
  }
  result.code = kit.exists && no_numbers.empty() ? kDone : kNotDerivable;
  return result;
}

}  // namespace

CorrectionAnswer correction_answer(const Question& q) {
  const Program program = q.program();
  const Force force = with_own_equation(force_named(q.force), program, q.values());
  if (force.linear()) return correct_linear(q, program, force);
  const Derivation d = derivation(program, force.degree, q.values(), q.substeps(), false);
  const CorrectionKit kit = correction_kit(d);
  CorrectionAnswer result;
  if (q.json) {
    result.text = as_json(kit, d).dump(2) + "\n";
  } else {
    const Style style = q.ascii ? Style::language : Style::unicode;
    result.text = d.integrator + ": " + line("shortfall x(t)-x_n", d.shortfall_position, style) + "\n" +
                  std::string(d.integrator.size() + 2, ' ') +
                  line("shortfall v(t)-v_n", d.shortfall_velocity, style) + "\n" + as_text(kit, d, style);
  }
  result.code = kit.needed && !kit.best() ? kNotDerivable : kDone;
  return result;
}

namespace {

int correct(const Question& q, int order) {
  if (is_force_class(q.force)) return correct_general(q, order);
  if (order != 0) throw BadInput("--order goes with --force general and other classes of forces");
  const CorrectionAnswer answer = correction_answer(q);
  write_output(answer.text, q.output);
  return answer.code;
}

}  // namespace

void add_correct(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Start here", "correct",
      "The correction kit alone: what to add to launch, read-out, force or step.",
      {"correct symplectic-euler --force constant", "correct symplectic-euler --force constant --lang csharp",
       "correct rapier --height 1.7 --lang rust", "correct explicit-euler --force poly:2 --json",
       "correct rk4 --force spring:k=4 --dt 1/10",
       "correct symplectic-euler --force damped-spring --lang cpp",
       "correct symplectic-euler --force general", "correct velocity-verlet --force general --order 4"});
  auto q = std::make_shared<Question>();
  auto language = std::make_shared<std::string>();
  auto height = std::make_shared<std::string>();
  auto order = std::make_shared<int>(0);
  add_integrator(*command, *q);
  add_force(*command, *q);
  add_parameters(*command, *q);
  command
      ->add_option("--lang", *language,
                   "as code: csharp, cpp, gdscript, python, rust, javascript; for a constant force, the "
                   "corrected jump; for springs, dampers and drag, a class with the kit")
      ->type_name("L");
  command
      ->add_option("--height", *height,
                   "with --lang: the height to which the printed code jumps when it checks itself")
      ->type_name("H");
  command
      ->add_option(
          "--order", *order,
          "with --force general: the effective order that is wanted, by launch and read-out, or with a "
          "corrected force")
      ->type_name("P")
      ->check(CLI::Range(2, 10));
  add_time_step(*command, *q);
  add_gravity(*command, *q);
  add_json(*command, *q);
  add_ascii(*command, *q);
  add_full(*command, *q);
  add_output(*command, *q);
  command->callback([q, language, height, order, &code] {
    if (language->empty() && !height->empty())
      throw BadInput("--height goes with --lang; how high a jump gets is told by: shortfall jump");
    if (language->empty())
      code = correct(*q, *order);
    else
      write_output(correction_code(*q, *language, *height), q->output);
  });
}

}  // namespace shortfall::cli
