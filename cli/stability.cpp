// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/stability/stability.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/figure_stability.hpp"
#include "notebooks-export/stability_json.hpp"
#include "notebooks-export/stability_text.hpp"

namespace shortfall::cli {

namespace {

struct StabilityOptions : Question {
  std::string frame;
  std::string plot;
};

/// Of --dt, which here has no default: most steps are judged for every frame at once.
std::optional<Rational> frame(const StabilityOptions& o) {
  if (o.frame.empty()) return std::nullopt;
  return positive_quantity(o.frame, Unit::time, "--dt");
}

void stability(const StabilityOptions& o) {
  check_picture_name(o.plot);
  const Stability s = shortfall::stability(o.program(), o.values(), o.substeps(), frame(o));
  if (!o.plot.empty()) write_picture(stability_figure(s), o.plot);
  if (o.json)
    write_output(as_json(s).dump(2) + "\n", o.output);
  else
    write_output(as_text(s, o.ascii ? Style::language : Style::unicode), o.output);
}

}  // namespace

void add_stability(CLI::App& app, int&) {
  CLI::App* command = new_command(
      app, "Prove", "stability",
      "For which steps an oscillation stays bounded, exactly; what happens at the limit; A- and L-stability.",
      {"stability symplectic-euler", "stability newmark --param beta=0 --param gamma=1/2",
       "stability rk4 --plot rk4.svg", "stability velocity-verlet --substeps 4 --json",
       "stability cannon-es --param c=0.1 --dt 60Hz"});
  auto o = std::make_shared<StabilityOptions>();
  add_integrator(*command, *o);
  add_parameters(*command, *o);
  command
      ->add_option("--dt", o->frame,
                   "the frame, for an engine whose damping depends on it: 1/60, 60Hz; without it the answer "
                   "holds for every frame")
      ->type_name("DT");
  add_json(*command, *o);
  add_ascii(*command, *o);
  command
      ->add_option("--plot", o->plot,
                   "draw the eigenvalues and the stable region (needs gnuplot): a file that ends in .svg, "
                   ".png or .pdf")
      ->type_name("FILE");
  add_output(*command, *o);
  command->callback([o] { stability(*o); });
}

}  // namespace shortfall::cli
