// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget.hpp"
#include "cli/float_question.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/budget_text.hpp"

namespace shortfall::cli {

namespace {

struct BudgetOptions : FloatOptions {
  std::string height, steps, until, plot, periods;
  bool landing = false;
};

std::int64_t step_count(const BudgetOptions& o, const Rational& h) {
  if (o.steps.empty() == o.until.empty())
    throw BadInput(
        "a budget needs --height H (with --landing, if you like), --steps N, --until TIME or --periods N");
  const Rational n = o.steps.empty() ? quantity(o.until, Unit::time, "--until") / h
                                     : quantity(o.steps, Unit::none, "--steps");
  std::int64_t whole = 0;
  if (!n.is_integer() || n.sign() <= 0)
    throw BadInput(o.steps.empty() ? "--until " + o.until.substr(0, 40) + " is no whole number of steps"
                                   : "--steps " + o.steps.substr(0, 40) +
                                         ": a number of steps is a whole number, 1 or more");
  if (!n.fits_int64(whole))
    throw Unable(
        "a run of " + n.significant(3) + " steps takes thousands of years; the exact map alone " +
        "answers for up to 1e100 (shortfall derive --steps), a clock for up to 1e18 (shortfall clock)");
  return whole;
}

/// How many periods; 0 when none were asked for.
int period_count(const BudgetOptions& o) {
  if (o.periods.empty()) return 0;
  const Rational n = quantity(o.periods, Unit::none, "--periods");
  std::int64_t whole = 0;
  if (!n.is_integer() || !n.fits_int64(whole) || whole < 1 || whole > kMostPeriods)
    throw BadInput("--periods " + o.periods.substr(0, 40) + ": a whole number from 1 to " +
                   std::to_string(kMostPeriods));
  return static_cast<int>(whole);
}

/// throws  BadInput  for options that ask two things
void check_options(const BudgetOptions& o) {
  const bool frame = !(o.steps.empty() && o.until.empty());
  if (!o.height.empty() && frame)
    throw BadInput("--height asks for the peak of a jump; --steps and --until for a frame: give one of them");
  if (!o.periods.empty() && (frame || !o.height.empty()))
    throw BadInput(
        "--periods asks for the time of an oscillation: give no --height, --steps or --until with it");
  if (o.landing && o.height.empty()) throw BadInput("--landing is that of a jump: give its --height");
}

int budget_command(const BudgetOptions& o) {
  const std::vector<FloatFormat> formats = float_formats(o.formats);
  check_picture_name(o.plot);
  check_options(o);
  const int periods = period_count(o);
  const FloatQuestion q = float_question(o);
  std::string about = q.program.name + ", ";
  std::vector<Budget> budgets;
  {
    ProgressLine line;
    if (!o.height.empty()) {
      const Rational height = positive_quantity(o.height, Unit::length, "--height");
      for (const FloatFormat& f : formats)
        budgets.push_back(o.landing ? landing_budget(f, q, height, o.gravity(), line.progress())
                                    : peak_budget(f, q, height, o.gravity(), line.progress()));
      about += "a jump of " + height.significant(6) + " m under g = " + o.gravity().significant(6) + " m/s^2";
    } else if (periods > 0) {
      for (const FloatFormat& f : formats) budgets.push_back(period_budget(f, q, periods, line.progress()));
      about += "force " + q.force.text + ", x0 = " + q.x0.significant(6) + " m, v0 = " + q.v0.significant(6) +
               " m/s";
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
    write_picture(budget_figure(budgets, about), o.plot);
  }
  write_output(o.json ? as_json(budgets).dump(2) + "\n" : as_text(budgets, about), o.output);
  const bool all = std::ranges::all_of(budgets, [](const Budget& b) { return b.reason.empty(); });
  return all ? kDone : kNotDerivable;
}

}  // namespace

void add_budget(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Floats", "budget",
      "What part of an error is the method's, the constants', the arithmetic's, the sampling's.",
      {"budget symplectic-euler --height 1.7 --dt 0.02f --formats f32",
       "budget velocity-verlet --force spring:k=1 --dt 1/10 --steps 10000 --formats f32,f32+kahan",
       "budget --height 1.7 --formats f32 --plot budget.svg", "budget --height 1.7 --landing --dt 0.02f",
       "budget velocity-verlet --force spring:k=40 --dt 1/60f --periods 10"});
  auto o = std::make_shared<BudgetOptions>();
  o->formats = "f32,f64";
  add_float_options(*command, *o,
                    "f16, bf16, f32, f64, x87, f128, dd, mpfr:DIGITS, with +fma, +kahan, +origin, +tozero");
  command->add_option("--height", o->height, "the peak of a jump that is meant to be so high")
      ->type_name("H");
  command->add_flag("--landing", o->landing, "of that jump the time of landing, instead of the peak");
  command->add_option("--periods", o->periods, "the period of an oscillation, measured over so many")
      ->type_name("N");
  command->add_option("--steps", o->steps, "after so many steps")->type_name("N");
  command->add_option("--until", o->until, "at a time, a whole number of steps")->type_name("TIME");
  command
      ->add_option("--plot", o->plot,
                   "draw the parts (needs gnuplot): a file that ends in .svg, .png or .pdf")
      ->type_name("FILE");
  command->callback([o, &code] { code = budget_command(*o); });
}

}  // namespace shortfall::cli
