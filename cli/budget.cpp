// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget.hpp"
#include "cli/float_question.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/budget_text.hpp"
#include "notebooks-export/figure_gnuplot.hpp"

namespace shortfall::cli {

namespace {

struct BudgetOptions : FloatOptions {
  std::string height, steps, until, plot;
};

std::int64_t step_count(const BudgetOptions& o, const Rational& h) {
  if (o.steps.empty() == o.until.empty())
    throw BadInput("a budget needs --height H, or --steps N, or --until TIME");
  const Rational n = o.steps.empty() ? quantity(o.until, Unit::time, "--until") / h
                                     : quantity(o.steps, Unit::none, "--steps");
  std::int64_t whole = 0;
  if (!n.is_integer() || n.sign() <= 0)
    throw BadInput(o.steps.empty() ? "--until " + o.until.substr(0, 40) + " is no whole number of steps"
                                   : "--steps " + o.steps.substr(0, 40) +
                                         ": a number of steps is a whole number, 1 or more");
  if (!n.fits_int64(whole)) whole = kMostFloatSteps + 1;  // refused with the reason
  return whole;
}

int budget_command(const BudgetOptions& o) {
  const std::vector<FloatFormat> formats = float_formats(o.formats);
  if (!o.plot.empty()) image_format(o.plot);  // a wrong ending is seen before any work
  if (!o.height.empty() && !(o.steps.empty() && o.until.empty()))
    throw BadInput("--height asks for the peak of a jump; --steps and --until for a frame: give one of them");
  const FloatQuestion q = float_question(o);
  std::string about = q.program.name + ", ";
  std::vector<Budget> budgets;
  {
    ProgressLine line;
    if (!o.height.empty()) {
      const Rational height = positive_quantity(o.height, Unit::length, "--height");
      for (const FloatFormat& f : formats)
        budgets.push_back(peak_budget(f, q, height, o.gravity(), line.progress()));
      about += "a jump of " + height.significant(6) + " m under g = " + o.gravity().significant(6) + " m/s^2";
    } else {
      const std::int64_t steps = step_count(o, q.h);
      for (const FloatFormat& f : formats) budgets.push_back(budget(f, q, steps, line.progress()));
      about += "force " + q.force.text + ", x0 = " + q.x0.significant(6) + " m, v0 = " + q.v0.significant(6) +
               " m/s, " + std::to_string(steps) + " steps";
    }
  }
  about += ", dt = " + (q.h.digits() < 12 ? q.h.str() : q.h.significant(17)) + " s";
  if (q.kept_h) about += ", stored as " + o.dt;
  if (!o.plot.empty()) {
    try {
      write_output(image(budget_figure(budgets, about), image_format(o.plot)), o.plot);
    } catch (const ProgramError& e) {
      throw OutputError(e.what());
    }
    say("wrote " + o.plot);
  }
  write_output(o.json ? as_json(budgets).dump(2) + "\n" : as_text(budgets, about), o.output);
  return kDone;
}

}  // namespace

void add_budget(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Floats", "budget",
                  "What part of an error is the method's, the constants', the arithmetic's, the sampling's.",
                  {"budget symplectic-euler --height 1.7 --dt 0.02f --formats f32",
                   "budget velocity-verlet --force spring:k=1 --dt 1/10 --steps 10000 --formats "
                   "f16,f32,f32+kahan,f64,mpfr:50",
                   "budget --height 1.7 --formats f32 --plot budget.svg"});
  auto o = std::make_shared<BudgetOptions>();
  o->formats = "f32,f64";
  add_float_options(*command, *o,
                    "f16, bf16, f32, f64, x87, f128, dd, mpfr:DIGITS, with +fma, +kahan, +origin, +tozero");
  command->add_option("--height", o->height, "the peak of a jump that is meant to be so high")
      ->type_name("H");
  command->add_option("--steps", o->steps, "after so many steps")->type_name("N");
  command->add_option("--until", o->until, "at a time, a whole number of steps")->type_name("TIME");
  command
      ->add_option("--plot", o->plot,
                   "draw the parts (needs gnuplot): a file that ends in .svg, .png or .pdf")
      ->type_name("FILE");
  command->callback([o, &code] { code = budget_command(*o); });
}

}  // namespace shortfall::cli
