// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/suggest.hpp"
#include "cli/command.hpp"
#include "cli/jump_frames.hpp"
#include "cli/jump_render.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/code.hpp"
#include "notebooks-export/figure_jump.hpp"

namespace shortfall::cli {

namespace {

struct JumpOptions : Question {
  std::string height;
  std::string language;
  std::string launch = "velocity";
  std::string plot;
  bool all_engines = false;
  FrameOptions frames;

  LaunchBy by() const {
    return launch == "impulse"           ? LaunchBy::impulse
           : launch.starts_with("force") ? LaunchBy::force
                                         : LaunchBy::velocity;
  }
  /// Of force:N; 1 without a number.
  int force_frames() const { return launch.starts_with("force:") ? std::stoi(launch.substr(6)) : 1; }
};

/// Why a text is no way to launch a body; empty when it is one.
std::string not_a_launch(const std::string& text) {
  if (text == "velocity" || text == "impulse" || text == "force") return {};
  if (!text.starts_with("force:"))
    return "'" + text.substr(0, 40) + "' is none of velocity, impulse, force, force:N" +
           did_you_mean(text, {"velocity", "impulse", "force"});
  int frames = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + 6, end, frames);
  if (error == std::errc{} && stopped == end && frames >= 1 && frames <= Flight::kForceFrames) return {};
  return "'" + text.substr(0, 40) + "': a force is held over a whole number of frames from 1 to " +
         std::to_string(Flight::kForceFrames) + ", as in force:5";
}

/// The unit in which the user gave the height; empty for a bare number.
std::string unit_of(const std::string& height) {
  const std::string first = height.substr(0, height.find(':'));
  std::size_t begin = first.size();
  while (begin > 0 && std::isalpha(static_cast<unsigned char>(first[begin - 1]))) --begin;
  const std::string unit = first.substr(begin);
  return unit == "f" || unit == "d" ? "" : unit;
}

/// `jump --dt-file`: the frames are listed in a file.
void jump_over_frames(const JumpOptions& o, const std::vector<Rational>& heights) {
  if (heights.size() != 1) throw BadInput("--dt-file takes one --height, no sweep");
  const Program program = o.program();
  const ListedJump listed = listed_jump(program, o.frames,
                                        {.height = heights.front(),
                                         .steps = {},
                                         .g = o.gravity(),
                                         .substeps = o.substeps(),
                                         .parameters = o.values(),
                                         .fixed_dt = o.step()});
  if (!o.language.empty()) {
    const auto& term = listed.jump.term;
    if (!term && listed.jump.exactness.exact != true)
      throw Undefined("there is no term that makes every step exact, and so no code for it: " +
                      listed.jump.no_term);
    const Flight flight = term ? Flight(term->program, o.step(), 1, o.values())
                               : Flight(program, o.step(), o.substeps(), o.values());
    write_output(jump_code(flight, o.gravity(), language_of(o.language)), o.output);
  } else if (o.json) {
    write_output(frames_json(listed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 o.output);
  } else {
    write_output(o.csv ? frames_csv(listed.jump) : frames_text(listed, {unit_of(o.height), o.ascii}),
                 o.output);
  }
}

/// `jump --all-engines`: every engine of the catalogue that can be launched so.
void jump_of_engines(JumpOptions o, const std::vector<Rational>& heights) {
  if (heights.size() != 1) throw BadInput("--all-engines takes one --height, no sweep");
  std::vector<EngineJump> jumps;
  for (const Program& engine : catalogue()) {
    if (family(engine) != "engines" || (o.by() == LaunchBy::impulse && !engine.impulse)) continue;
    o.integrator = engine.name;
    jumps.push_back(engine_jump(engine, {.height = heights.front(),
                                         .dt = o.step(),
                                         .g = o.gravity(),
                                         .substeps = o.substeps(),
                                         .parameters = o.values(),
                                         .binary32_frames = 0,
                                         .by = o.by(),
                                         .force_frames = o.force_frames()}));
  }
  if (jumps.empty()) throw Undefined("no engine of the catalogue can be launched so");
  if (o.json)
    write_output(engines_json(jumps).dump(2) + "\n", o.output);
  else
    write_output(o.csv ? engines_csv(jumps) : engines_text(jumps, {unit_of(o.height), o.ascii}), o.output);
}

/// The jump at the usual frame rates, and at the one asked for.
void draw(const JumpOptions& o, const Rational& height) {
  check_picture_name(o.plot);
  if (o.by() != LaunchBy::velocity) throw BadInput("--plot draws jumps that are launched by their velocity");
  std::vector<Rational> steps{Rational(1, 30), Rational(1, 60), Rational(1, 120)};
  if (std::ranges::find(steps, o.step()) == steps.end()) steps.push_back(o.step());
  std::ranges::sort(steps, std::greater<>());
  std::vector<Flight> flights;
  for (const Rational& dt : steps) flights.emplace_back(o.program(), dt, o.substeps(), o.values());
  write_picture(jump_figure(flights, height, o.gravity()), o.plot);
}

void jump(const JumpOptions& o) {
  const bool listed = !o.frames.file.empty();
  if (o.height.empty() && (listed || o.language.empty()))
    throw BadInput("--height is required, as in: shortfall jump --height 40cm");
  if (o.frames.repeat && !listed) throw BadInput("--repeat goes with --dt-file");
  std::vector<Rational> heights;
  if (!o.height.empty()) heights = sweep(o.height, Unit::length, "--height");
  if (listed && o.by() != LaunchBy::velocity)
    throw BadInput("--dt-file sets the velocity: no --launch " + o.launch);
  if (!o.language.empty() && o.by() == LaunchBy::force)
    throw BadInput("--lang writes code that sets the velocity: no --launch force");
  if (!o.plot.empty()) {
    if (listed || o.all_engines || heights.size() != 1)
      throw BadInput("--plot draws one jump: one --height, no sweep, no --dt-file, no --all-engines");
    draw(o, heights.front());
  }
  if (listed) return jump_over_frames(o, heights);
  if (o.all_engines) return jump_of_engines(o, heights);
  const Rational g = o.gravity();
  const Flight flight(o.program(), o.step(), o.substeps(), o.values(), o.by(), o.force_frames());
  if (!o.language.empty()) {
    write_output(jump_code(flight, g, language_of(o.language)), o.output);
    return;
  }
  // A sweep shares what a single jump may spend on its search.
  const std::int64_t frames = kBinary32Frames / static_cast<std::int64_t>(heights.size());
  std::vector<Jump> jumps;
  for (const Rational& height : heights) jumps.push_back(shortfall::jump(flight, height, g, frames));
  const JumpWords words{unit_of(o.height), o.ascii};
  if (o.json)
    write_output(jump_json(jumps).dump(2) + "\n", o.output);
  else if (o.csv)
    write_output(jump_csv(jumps), o.output);
  else
    write_output(jumps.size() == 1 ? jump_text(jumps.front(), words) : jump_table(jumps, words), o.output);
}

}  // namespace

void add_jump(CLI::App& app, int&) {
  CLI::App* command = new_command(
      app, "Start here", "jump", "How far a jump falls short, why, and the launch that makes it right.",
      {"jump --height 40cm --dt 0.02", "jump velocity-verlet --height 1.7 --dt 50Hz --json",
       "jump symplectic-euler --height 1.7m --substeps 4", "jump --height 1mm:100m:log:50 --csv",
       "jump godot --height 10m --param c=0.1", "jump rapier --height 1.7 --substeps 8",
       "jump rapier --height 1.7 --launch force:5", "jump --all-engines --height 1.7",
       "jump --height 1.7 --dt-file frames.csv", "jump --lang csharp", "jump --height 1.7 --plot jump.svg"});
  auto o = std::make_shared<JumpOptions>();
  add_integrator(*command, *o);
  command->add_option("--height", o->height, "the height to jump to: 40cm, 1.7, or a sweep 1mm:100m:log:50")
      ->type_name("H");
  add_time_step(*command, *o);
  command
      ->add_option("--dt-file", o->frames.file,
                   "frames of lengths of their own: a column of seconds, or a table with a header such as dt "
                   "[ms] or time [s]; --dt is then the step of the accumulator that is offered instead")
      ->type_name("FILE");
  command->add_flag("--repeat", o->frames.repeat, "begin the list of --dt-file anew when it is over");
  add_gravity(*command, *o);
  add_parameters(*command, *o);
  command
      ->add_option("--lang", o->language,
                   "the corrected jump as code: csharp, cpp, gdscript, python, rust, javascript")
      ->type_name("L");
  command
      ->add_option(
          "--launch", o->launch,
          "how the body is launched: its velocity is set; it is given an impulse, which some engines spread "
          "over their substeps; or a force is held over the first frame, mass * launch/dt, or with force:N "
          "over the "
          "first N frames, mass * launch/(N dt)")
      ->capture_default_str()
      ->type_name("HOW")
      ->check(not_a_launch);
  command
      ->add_flag(
          "--all-engines", o->all_engines,
          "a table of all engines: how far each falls short, with g dt/2 added to the launch, and what is "
          "right")
      ->excludes("INTEGRATOR")
      ->excludes("--param")
      ->excludes("--dt-file")
      ->excludes("--lang");
  command
      ->add_option(
          "--plot", o->plot,
          "draw it at 30, 60, 120 Hz and --dt (needs gnuplot): a file that ends in .svg, .png or .pdf")
      ->type_name("FILE");
  add_json(*command, *o);
  command->add_flag(
      "--csv", o->csv,
      "one line a height (with --dt-file a frame), in metres and seconds, decimals rounded to 17 digits");
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o] { jump(*o); });
}

}  // namespace shortfall::cli
