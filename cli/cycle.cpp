// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/cycle.hpp"
#include "cli/float_question.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/cycle_text.hpp"

namespace shortfall::cli {

namespace {

struct CycleOptions : FloatOptions {
  std::string most = "1e9";
};

int cycle_command(const CycleOptions& o) {
  const FloatQuestion q = float_question(o);
  std::int64_t most = 0;
  if (const Rational n = quantity(o.most, Unit::none, "--most");
      !n.is_integer() || !n.fits_int64(most) || most < 1)
    throw BadInput("--most takes a number of steps, such as 1e9");
  std::string text;
  nlohmann::ordered_json json{{"schema", "shortfall.cycle/1"},
                              {"integrator", q.program.name},
                              {"force", q.force.text},
                              {"dt", q.h.str()},
                              {"cycles", nlohmann::ordered_json::array()}};
  bool all = true;
  for (const FloatFormat& format : float_formats(o.formats)) {
    CycleSearch search;
    {
      ProgressLine line;
      search = cycle(format, q, most, line.progress());
    }
    all = all && search.found.has_value();
    text += as_text(search, format, q);
    json["cycles"].push_back(as_json(search, format, q));
  }
  write_output(o.json ? json.dump(2) + "\n" : text, o.output);
  return all ? kDone : kNotDerivable;
}

}  // namespace

void add_cycle(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Floats", "cycle",
                  "When a floating-point run repeats itself, and what is then certain for all time.",
                  {"cycle symplectic-euler --force spring:k=1 --dt 1/8 --formats f32",
                   "cycle velocity-verlet --force spring:k=1 --dt 1/8 --formats f16,bf16,f32 --json"});
  auto o = std::make_shared<CycleOptions>();
  o->force = "spring:k=1";
  o->formats = "f32";
  add_float_options(*command, *o, "f16, bf16, f32, f64, each with +tozero");
  command->add_option("--most", o->most, "steps before giving up; memory does not grow with it")
      ->capture_default_str()
      ->type_name("N");
  command->callback([o, &code] { code = cycle_command(*o); });
}

}  // namespace shortfall::cli
