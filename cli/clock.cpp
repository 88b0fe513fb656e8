// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/clock.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/clock_text.hpp"
#include "notebooks-export/figure_clock.hpp"

namespace shortfall::cli {

namespace {

constexpr int kMostStepped = 100'000'000;  // additions of Kahan's sum that --kahan carries out: some seconds

struct ClockOptions : Question {
  std::string steps, until, format, rounding, x0, velocity, plot;
  bool kahan = false;
};

Rational additions(const ClockOptions& o, const Rational& dt) {
  if (o.steps.empty() == o.until.empty())
    throw BadInput("a clock needs --steps N or --until TIME, one of them");
  if (!o.steps.empty()) {
    Rational n = quantity(o.steps, Unit::none, "--steps");
    if (!n.is_integer() || n.sign() < 0)
      throw BadInput("--steps " + o.steps.substr(0, 40) + ": a number of steps is a whole number, 0 or more");
    return n;
  }
  const Rational until = quantity(o.until, Unit::time, "--until");
  if (until.sign() < 0) throw BadInput("--until " + o.until.substr(0, 40) + ": a time to run is 0 or more");
  return (until / dt.abs()).floor();
}

/// Of --format, --kahan and --rounding; 0.1f is a clock in binary32, 0.1d one in binary64.
ClockArithmetic arithmetic(const ClockOptions& o) {
  ClockArithmetic a = clock_arithmetic(!o.format.empty() ? o.format : has_suffix(o.dt, 'd') ? "f64" : "f32");
  if (!o.rounding.empty()) a.rounding = rounding_named(o.rounding);
  if (o.kahan) a.compensated = true;
  return a;
}

int clock_command(const ClockOptions& o) {
  check_picture_name(o.plot);
  ClockQuestion q;
  static_cast<ClockArithmetic&>(q) = arithmetic(o);
  const StoredQuantity dt = stored_quantity(o.dt, Unit::time, "--dt");
  q.dt = dt.meant;
  q.kept_dt = dt.kept;
  if (q.dt.is_zero()) throw BadInput("--dt is 0: such a clock stands still");
  if (!o.velocity.empty()) q.velocity = quantity(o.velocity, Unit::none, "--velocity");
  if (!o.x0.empty()) q.start = quantity(o.x0, q.velocity ? Unit::length : Unit::time, "--x0");
  q.additions = additions(o, q.dt);
  q.most_stepped = kMostStepped;
  const ClockReport report = [&] {
    ProgressLine line;
    return clock_report(q, line.progress());
  }();
  if (!o.plot.empty()) {
    if (q.compensated) throw BadInput("--plot draws plain sums; leave --kahan out");
    write_picture(clock_figure(report), o.plot);
  }
  std::string text = o.json ? as_json(report).dump(2) + "\n" : o.csv ? as_csv(report) : as_text(report);
  if (o.ascii)
    for (std::size_t at = text.find("≈"); at != std::string::npos; at = text.find("≈", at))
      text.replace(at, std::string("≈").size(), "~");
  write_output(text, o.output);
  return kDone;
}

}  // namespace

void add_clock(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Floats", "clock",
                  "What t += dt (or x += v dt) really is after any number of additions: fast, slow, stopped.",
                  {"clock --dt 1/60f --until 24h", "clock --dt 0.1f --steps 1e18",
                   "clock --dt 0.1 --until 100h --format fixed:23 --rounding toward-zero",
                   "clock --dt 0.02 --velocity 3 --x0 10km --until 1h", "clock --dt 1/60f --until 24h --csv",
                   "clock --dt 1/60f --until 24h --plot clock.svg"});
  auto o = std::make_shared<ClockOptions>();
  o->dt = "";
  command->add_option("--dt", o->dt, "what is added: 0.02, 1/50, 20ms, 50Hz; 1/60f is stored in binary32")
      ->type_name("DT")
      ->required();
  command->add_option("--steps", o->steps, "so many additions; 1e18 takes no longer")->type_name("N");
  command->add_option("--until", o->until, "as many additions as fit into this time")->type_name("TIME");
  command
      ->add_option(
          "--format", o->format,
          "f32 (unless given; f64 with --dt 0.1d), f16, bf16, f64, x87, f128, mpfr:DIGITS, with +fma, "
          "+kahan or +tozero; fixed:B is fixed point with B bits after the point")
      ->type_name("FORMAT");
  command
      ->add_option("--rounding", o->rounding,
                   "nearest-even (unless given), nearest-away, toward-zero, up, down; constants and sums")
      ->type_name("R");
  command->add_option("--x0", o->x0, "where it starts (0)")->type_name("X");
  command->add_option("--velocity", o->velocity, "m/s: then it is a position, x += v dt")->type_name("V");
  command->add_flag("--kahan", o->kahan, "the compensated sum instead");
  command
      ->add_option("--plot", o->plot, "what it loses and how fast it goes, as a picture: .svg, .png or .pdf")
      ->type_name("FILE");
  command->add_flag("--csv", o->csv, "the speeds as a table, a line for each spacing of the numbers");
  command->add_flag("--ascii", o->ascii, "plain ASCII");
  add_json(*command, *o);
  add_output(*command, *o);
  command->callback([o, &code] { code = clock_command(*o); });
}

}  // namespace shortfall::cli
