// SPDX-License-Identifier: GPL-3.0-or-later
// `jump --all-engines`: one line an engine.
#include <fmt/format.h>

#include "analysis/program/print.hpp"
#include "cli/jump_amount.hpp"
#include "cli/jump_render.hpp"
#include "notebooks-export/text_table.hpp"

namespace shortfall::cli {

namespace {

constexpr int kPlaces = 3;

std::string centimetres(const Surd& metres) {
  const std::string text = (metres * Surd(100)).decimal(kPlaces);
  return text.starts_with('-') ? text : "+" + text;
}

/// "c = 0.1", for a parameter that the engine has.
std::string setting(const Jump& jump, const std::string& name) {
  const auto found = jump.parameters.find(name);
  return found == jump.parameters.end() ? "" : fmt::format("{} = {}", name, exact_text(found->second));
}

std::string right_correction(const Jump& jump, Style style) {
  if (!jump.correction.exists) return "none";
  if (jump.correction.per_gravity.is_zero()) return "0";
  return print(replace(jump.correction.formula, "h", name("dt")), style);
}

}  // namespace

std::string engines_text(const std::vector<EngineJump>& jumps, const JumpWords& words) {
  const Style style = words.ascii ? Style::language : Style::unicode;
  const Jump& first = jumps.front().undamped;
  const Amounts amounts(words.unit, first.target, words.ascii);
  std::string text = fmt::format(
      "A jump to {}{}, dt = {} s, g = {} downwards: cm short, rounded to {} digits after the point\n\n",
      amounts.height_exactly(first.target),
      first.by == LaunchBy::impulse ? std::string(", launched by an impulse")
      : first.by == LaunchBy::force
          ? ", launched by a force that is held over " + force_frames_text(first.force_frames)
          : std::string(),
      exact_text(first.dt), amounts.acceleration(first.g), kPlaces);
  text += fmt::format("{:<33} {:>9} {:>12}  {:<18} {}\n", "engine, undamped", "cm short", "with g dt/2",
                      "right correction", "with its default damping");
  for (const EngineJump& e : jumps) {
    const Jump& j = e.undamped;
    std::string name = j.integrator;
    if (const std::string substeps = setting(j, "N"); !substeps.empty()) name += ", " + substeps;
    if (j.substeps > 1) name += fmt::format(", {} substeps", j.substeps);
    std::string line =
        fmt::format("{:<33} {:>9} {:>12}  {} ", name, centimetres(j.shortfall.total),
                    centimetres(e.usual_fix.shortfall), padded(right_correction(j, style), 18));
    if (e.damped)
      line += fmt::format("{} ({})", centimetres(e.damped->shortfall.total), setting(*e.damped, "c"));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
    if (j.limit) text += fmt::format("  '{}' acts in frame {}: not so high\n", j.limit->text, j.limit->frame);
  }
  return text +
         "\nShortfall = exact - computed: + is too low, - too high. A right correction, added to the launch, "
         "puts "
         "every frame on the\nexact parabola (proved); with damping there is none.\n";
}

std::string engines_csv(const std::vector<EngineJump>& jumps) {
  std::vector<Jump> undamped;
  for (const EngineJump& e : jumps) undamped.push_back(e.undamped);
  const std::string lines = jump_csv(undamped);
  std::string text = "engine," + lines.substr(0, lines.find('\n') + 1);
  std::size_t begin = lines.find('\n') + 1;
  for (const Jump& j : undamped) {
    const std::size_t end = lines.find('\n', begin) + 1;
    text += j.integrator + "," + lines.substr(begin, end - begin);
    begin = end;
  }
  return text;
}

}  // namespace shortfall::cli
