// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/extremes.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "notebooks-export/extremes_text.hpp"

namespace shortfall::cli {

namespace {

struct ExtremesOptions : Question {
  std::string formats = "f32,f64";
};

void extremes(const ExtremesOptions& o) {
  const Program program = o.program();
  if (o.substeps() > 1)
    throw BadInput(
        "the cases are about single steps; --substeps is for an integrator that counts its own (shortfall "
        "show " +
        program.name + ")");
  std::string text;
  nlohmann::ordered_json json{{"schema", "shortfall.extremes/1"},
                              {"integrator", program.name},
                              {"formats", nlohmann::ordered_json::array()}};
  for (const FloatFormat& format : float_formats(o.formats)) {
    std::vector<ExtremeCase> cases = extreme_sums(format);
    const std::vector<ExtremeCase> steps = extreme_steps(format, program, o.values());
    cases.insert(cases.end(), steps.begin(), steps.end());
    text += (text.empty() ? "" : "\n") + as_text(cases, format.words() + ", " + program.name);
    json["formats"].push_back({{"format", format.name()}, {"cases", as_json(cases)}});
  }
  write_output(o.json ? json.dump(2) + "\n" : text, o.output);
}

}  // namespace

void add_extremes(CLI::App& app, int&) {
  CLI::App* command = new_command(app, "Floats", "extremes",
                                  "Hard cases with known answers: what is exact, what a format gives, why.",
                                  {"extremes", "extremes velocity-verlet --formats f32"});
  auto o = std::make_shared<ExtremesOptions>();
  add_integrator(*command, *o);
  command->add_option("--formats", o->formats, "formats, with commas; see budget")
      ->capture_default_str()
      ->type_name("LIST");
  add_parameters(*command, *o);
  add_json(*command, *o);
  add_output(*command, *o);
  command->callback([o] { extremes(*o); });
}

}  // namespace shortfall::cli
