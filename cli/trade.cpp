// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/mpi/machines.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/scene.hpp"
#include "notebooks-export/trade_text.hpp"

namespace shortfall::cli {

namespace {

struct TradeOptions {
  std::string scene, integrators, formats, steps, until, plot, html, store, output;
  int repeats = 10;
  int at_once = 0;
  bool no_peers = false, no_launches = false, json = false, csv = false;
};

/// What has to be right before a point is done.
struct Begun {
  Scene scene;
  TradeQuestion question;
  std::optional<PointStore> store;

  Begun(const Machines& machines, const TradeOptions& o) {
    check_picture_name(o.plot);
    scene = scene_from(o.scene, o.until);
    question.integrators = words_of(o.integrators);
    question.formats = words_of(o.formats);
    question.repeats = o.repeats;
    question.peers = !o.no_peers;
    question.at_once = o.at_once;
    if (o.at_once > 0 && o.repeats == 0)
      throw BadInput("--lanes asks what a motion costs in company, and --repeats 0 measures no times");
    question.launches = !o.no_launches;
    if (!o.steps.empty())
      for (const Rational& h : sweep(o.steps, Unit::time, "--dt"))
        question.steps.push_back(scene.units.from_si(h, {0, 1, 0}));
    std::ranges::sort(question.steps, std::greater<>());
    question.run_points = [&machines](std::size_t count, const auto& one, const Progress& progress) {
      return machines.run_points(count, one, progress);
    };
    if (!machines.speaks()) {  // times mean something only where nothing else runs
      question.repeats = 0;
      question.peers = false;
      question.at_once = 0;
    }
    if (!o.store.empty()) question.store = &store.emplace(o.store);
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;
};

int trade_on(const Machines& machines, const TradeOptions& o) {
  std::optional<Begun> begun;
  try {
    begun.emplace(machines, o);
  } catch (const std::exception& e) {
    const auto first = machines.unready(false);
    if (!machines.speaks() && machines.is(*first))
      say("shortfall: process " + std::to_string(*first) + " of mpirun: " + e.what());
    throw;
  }
  if (const auto other = machines.unready(true))
    throw OutputError("process " + std::to_string(*other) + " of mpirun cannot begin, and says why");
  Trade result;
  {
    ProgressLine line;
    result = trade(begun->scene, begun->question, line.progress());
  }
  if (!machines.speaks()) return kDone;
  if (!o.plot.empty()) {
    write_picture(trade_figure(result), o.plot);
  }
  if (!o.html.empty()) {
    write_output(trade_page(result, "shortfall trade " + o.scene + " --html " + o.html), o.html);
    say("wrote " + o.html);
  }
  write_output(o.json ? as_json(result).dump(2) + "\n" : o.csv ? as_csv(result) : as_text(result), o.output);
  return kDone;
}

int trade_command(const TradeOptions& o) {
  const Machines machines;
  if (machines.speaks()) return trade_on(machines, o);
  try {
    return trade_on(machines, o);
  } catch (const std::exception&) {
    return kUsage;  // said already, by the first process that something went wrong on
  }
}

}  // namespace

void add_trade(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Scenes", "trade", "Accuracy against speed: errors in a scene's own terms, beside what they cost.",
      {"trade scenes/kepler.toml",
       "trade scenes/grenade.toml --integrators symplectic-euler,velocity-verlet,rk4 --csv",
       "trade scenes/swing.toml --formats f32,f64 --plot trade.svg",
       "trade scenes/kepler.toml --html trade.html"});
  auto o = std::make_shared<TradeOptions>();
  command->add_option("SCENE", o->scene, "a scene's file; see docs/scenes.md")->required();
  command->add_option("--integrators", o->integrators, "names, separated by commas")->type_name("LIST");
  command->add_option("--formats", o->formats, "f32, f64 or both; otherwise those of the scene's budget")
      ->type_name("LIST");
  command->add_option("--dt", o->steps, "FROM:TO:log:COUNT instead of the usual steps")->type_name("STEPS");
  command->add_option("--until", o->until, "end the scene there instead")->type_name("TIME");
  command->add_option("--repeats", o->repeats, "of each time measurement; 0: count evaluations only")
      ->type_name("N")
      ->check(CLI::Range(0, 1000));
  command
      ->add_option(
          "--lanes", o->at_once,
          "also the time of one motion among N that are stepped side by side, for scenes of one coordinate")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  command->add_flag("--no-peers", o->no_peers, "leave out the steppers of GSL and Boost.odeint");
  command->add_flag("--no-launches", o->no_launches, "leave out integrators with launch and read-out");
  command->add_flag("--json", o->json, "as JSON");
  command->add_flag("--csv", o->csv, "every point, one a line");
  command->add_option("--plot", o->plot, "draw it (needs gnuplot): a file that ends in .svg, .png or .pdf")
      ->type_name("FILE");
  command->add_option("--html", o->html, "write a page: the answer, the drawing, every point")
      ->type_name("FILE");
  command
      ->add_option("--store", o->store,
                   "keep the points in this SQLite file as they come, and go on from there when asked again")
      ->type_name("FILE");
  command->add_option("-o,--output", o->output, "write to a file")->type_name("FILE");
  command->callback([o, &code] { code = trade_command(*o); });
}

}  // namespace shortfall::cli
