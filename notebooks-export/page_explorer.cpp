// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "analysis/motion/formula_text.hpp"
#include "notebooks-export/code_language.hpp"
#include "notebooks-export/page.hpp"
#include "notebooks-export/page_document.hpp"

namespace shortfall {

namespace {

/// A letter with a slider.
struct Slider {
  std::string name, label, low, high, step, value;
};

/// The letters of the motion: a jump of 40 cm where the force is gravity.
std::vector<Slider> sliders(const Derivation& d) {
  std::vector<Slider> list{{"x0", "position at the launch x₀ (m)", "-1", "1", "0.05", "0"},
                           {"v0", "velocity at the launch v₀ (m/s)", "-5", "8", "0.05", "2.8"}};
  for (int c = 0; c <= d.degree; ++c) {
    const std::string name = column_name(2 + c, d.degree);
    const std::string power = c == 0 ? "" : c == 1 ? " t" : " t^" + std::to_string(c);
    if (c == 0)
      list.push_back({name, "acceleration " + name + " (m/s²)", "-20", "5", "0.05", "-9.8"});
    else
      list.push_back({name, name + power + ": " + name + " (m/s^" + std::to_string(2 + c) + ")", "-20", "20",
                      "0.1", c == 1 ? "3" : "0"});
  }
  return list;
}

std::map<std::string, std::string> names(const Derivation& d) {
  std::map<std::string, std::string> result{{"t", "t"}, {"n", "n"}, {"v", "v"}, {"h", "at.h"}};
  for (const Slider& s : sliders(d)) result[s.name] = "at." + s.name;
  return result;
}

/// The option that the page can show as a motion: what is added at the launch and to what is read out.
const CorrectionOption* shown(const CorrectionKit& kit) {
  for (const CorrectionOption& o : kit.options)
    if (o.exists && std::ranges::all_of(o.corrections, [](const Correction& c) {
          return c.kind == Correction::Kind::launch || c.kind == Correction::Kind::read_out;
        }))
      return &o;
  return nullptr;
}

}  // namespace

std::string explorer_motion(const Derivation& d, const CorrectionKit& kit) {
  const auto known = names(d);
  const auto code = [&](const Expr& e) { return code_in_binary64(e, Language::javascript, known); };
  std::string text = "const motion = {\n  first: " + std::to_string(d.form.valid_from) + ",\n  letters: [";
  for (const Slider& s : sliders(d)) text += "{ name: \"" + s.name + "\" }, ";
  text += "],\n  position: (at, t, n) => " + code(d.position) + ",\n  velocity: (at, t, n) => " +
          code(d.velocity) + ",\n  exact: (at, t) => " + code(d.exact_position) + ",\n";
  std::string launched = "({ ...at", place = "0",
              speed = "own";  // letters of a launch are those of the true motion
  const CorrectionOption* option = shown(kit);
  if (option)
    for (const Correction& c : option->corrections) {
      if (c.kind == Correction::Kind::launch)
        launched += ", " + c.target + ": at." + c.target + " + (" + code(c.add) + ")";
      else
        (c.target == "x" ? place : speed) += " + (" + code(c.add) + ")";
    }
  return text + "  correctable: " + (option ? "true" : "false") +
         ",\n  launched: (at) => { const t = 0, n = 0; return " + launched +
         " }); },\n  readout: (at, t, n, own) => { const v = " + speed + "; return " + place + "; },\n};\n";
}

std::string explorer_markup(const Derivation& d, bool correctable) {
  const auto slider = [](const Slider& s) {
    return "<label for=\"letter-" + s.name + "\">" + html_escaped(s.label) + " = <output id=\"letter-" +
           s.name + "-value\" for=\"letter-" + s.name + "\"></output><input type=\"range\" id=\"letter-" +
           s.name + "\" min=\"" + s.low + "\" max=\"" + s.high + "\" step=\"" + s.step + "\" value=\"" +
           s.value + "\"></label>\n";
  };
  std::string text =
      "<noscript><p>The figure to explore needs JavaScript; all formulas and numbers of this page do "
      "not.</p></noscript>\n"
      "<div id=\"explorer\" hidden>\n<figure><svg id=\"arcs\" role=\"img\" "
      "aria-labelledby=\"said\"></svg></figure>\n"
      "<figure><svg id=\"errors\" role=\"img\" aria-labelledby=\"said\"></svg>\n"
      "<figcaption>Above: the motion; below: exact minus computed, positive where the computed position is "
      "too low. "
      "Dots are frames.</figcaption></figure>\n<p class=\"said sans\" id=\"said\" "
      "aria-live=\"polite\"></p>\n<div class=\"controls\">\n";
  text += slider({"rate", "frames a second (1/s)", "5", "240", "1", "50"});
  text += slider({"duration", "shown for (s)", "0.1", "4", "0.05", "0.6"});
  for (const Slider& s : sliders(d)) text += slider(s);
  if (correctable)
    text +=
        "<label class=\"check\"><input type=\"checkbox\" id=\"corrected\" checked> with the "
        "correction</label>\n";
  return text + "</div>\n</div>";
}

}  // namespace shortfall
