// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/version.hpp"
#include "analysis/stability/stability_claims.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "notebooks-export/code_class.hpp"

namespace shortfall::cli {

namespace {

/// What is said of a claim that is true. A decimal is compared with the decimals as printed.
std::string holding(const ClaimVerdict& v) {
  if (v.trees_up_to > 0)
    return "not contradicted by trees up to order " + std::to_string(v.trees_up_to) + ", and not proved";
  return v.digits == 0 ? "holds" : "holds to " + std::to_string(v.digits) + " digits";
}

int show_code(const Question& q, const std::string& word) {
  write_output(integrator_code(q.program(), q.values(), q.substeps(), language_of(word)), q.output);
  return kDone;
}

int show(const Question& q) {
  if (!q.parameters.empty() || q.substep_count)
    throw BadInput("--param and --substeps go with --lang: without it the file is shown as it is written");
  const Program program = q.program();
  const std::vector<ClaimVerdict> verdicts = all_claims(program);
  bool all_hold = true;
  for (const ClaimVerdict& v : verdicts) all_hold = all_hold && v.holds;
  if (q.json) {
    nlohmann::ordered_json json{{"schema", "shortfall.show/1"},       {"integrator", program.name},
                                {"description", program.description}, {"aliases", program.aliases},
                                {"sources", program.sources},         {"text", print(program)}};
    json["versions"] = nlohmann::json::array();
    for (const SoftwareVersion& v : versions(program)) json["versions"].push_back(v.text);
    json["claims"] = nlohmann::json::array();
    for (const ClaimVerdict& v : verdicts)
      json["claims"].push_back({{"claim", v.claim},
                                {"holds", v.holds},
                                {"found", v.found},
                                {"digits", v.digits},
                                {"proved", v.proved()}});
    write_output(json.dump(2) + "\n", q.output);
  } else {
    std::string text = print(program);
    if (!verdicts.empty())
      text += program.approximate()
                  ? "\n# What it claims, checked just now; " + about_printed_decimals(program) + ":\n"
                  : "\n# What it claims, proved just now:\n";
    for (const ClaimVerdict& v : verdicts)
      text += "#   " + v.claim + (v.holds ? ": " + holding(v) : ": REFUTED, found " + v.found) + "\n";
    write_output(text, q.output);
  }
  return all_hold ? kDone : kRefuted;
}

}  // namespace

void add_show(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Set-up", "show",
                  "One integrator: its file, and whether its claims hold; or as a class of another language.",
                  {"show symplectic-euler", "show velocity-verlet --lang csharp", "show rapier@0.21",
                   "show my-own.integrator"});
  auto q = std::make_shared<Question>();
  add_integrator(*command, *q);
  command->get_option("INTEGRATOR")->required();
  auto language = std::make_shared<std::string>();
  command
      ->add_option("--lang", *language,
                   "as a class that steps a body: csharp, cpp, gdscript, python, rust, javascript")
      ->type_name("L");
  add_parameters(*command, *q);
  add_json(*command, *q);
  add_output(*command, *q);
  command->callback([q, language, &code] { code = language->empty() ? show(*q) : show_code(*q, *language); });
}

}  // namespace shortfall::cli
