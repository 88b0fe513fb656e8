// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/program/print.hpp"
#include "notebooks-export/notebook_lecture.hpp"

namespace shortfall {

namespace {

/// What a correction is added to, in words.
std::string what_it_is_added_to(const Correction& c, const Derivation& d) {
  switch (c.kind) {
    case Correction::Kind::launch:
      return c.target == "v0" ? "to the launch velocity" : "to the starting position";
    case Correction::Kind::read_out:
      return c.target == "v" ? "to the velocity that is read out" : "to the position that is read out";
    case Correction::Kind::force:
      return "to the acceleration that the integrator sees";
    case Correction::Kind::term:
      return std::string(c.target == "v" ? "to the velocity" : "to the position") +
             (d.substeps > 1 ? " at the end of each frame" : " at the end of each step");
  }
  return "";
}

/// Where in time a correction is taken.
std::string when(const Correction& c) {
  if (!mentions(c.add, "t")) return "";
  switch (c.kind) {
    case Correction::Kind::launch:
      return "";
    case Correction::Kind::read_out:
      return ", with $t$ the time of the frame";
    case Correction::Kind::force:
      return ", with $t$ the time at which it is asked for";
    case Correction::Kind::term:
      return ", with $t$ the time at the beginning of the step";
  }
  return "";
}

/// What to add, a short formula within its line, a long one below it.
std::string listed(const CorrectionOption& option, const Derivation& d) {
  std::string text;
  for (const Correction& c : option.corrections) {
    const std::string where = what_it_is_added_to(c, d) + when(c);
    if (is_long(c.add))
      text += "**Add " + where + "**\n\n" + displayed(c.add) + "\n\n";
    else
      text += "**Add** " + inlined(c.add) + " " + where + ".\n\n";
    if (d.degree > 0 && c.series != print(c.add))
      text += "In terms of the force and its derivatives by time this is `" + c.series + "`.\n\n";
  }
  return text;
}

std::string title(const CorrectionOption& option) {
  if (option.name == "launch") return "By the launch";
  if (option.name == "force alone") return "By the force alone";
  if (option.name == "term") return "By a term in every step";
  return "By " + option.name;
}

/// Whether the shortfall is a change of the launch velocity in disguise: a constant times t.
const Correction* as_launch(const Lecture& l, const CorrectionOption& option) {
  if (l.d.degree > 0 || option.corrections.empty()) return nullptr;
  const auto launches = std::ranges::count_if(
      option.corrections, [](const Correction& c) { return c.kind == Correction::Kind::launch; });
  const Correction& c = option.corrections.front();
  return launches == 1 && c.kind == Correction::Kind::launch && c.target == "v0" ? &c : nullptr;
}

}  // namespace

Repair repair(const CorrectionOption& option) {
  Repair r;
  for (const Correction& c : option.corrections) {
    const bool x = c.target.starts_with("x");
    switch (c.kind) {
      case Correction::Kind::launch:
        (x ? r.launch_x : r.launch_v) = c.add;
        break;
      case Correction::Kind::read_out:
        (x ? r.read_x : r.read_v) = c.add;
        break;
      case Correction::Kind::force:
        r.force = c.add;
        break;
      case Correction::Kind::term:
        (x ? r.term_x : r.term_v) = c.add;
        break;
    }
  }
  return r;
}

std::string repair_name(const CorrectionOption& option) {
  std::string text = "with_" + option.name;
  for (char& c : text)
    if (c == ' ' || c == '-') c = '_';
  return text;
}

void tell_corrections(Lecture& l) {
  if (l.is_exact()) return;
  const bool any = l.kit.best() != nullptr;
  std::string text = l.heading("What repairs it") + "\n\n";
  text += any ? "A correction is something to add: to the launch, to what is read out, to the acceleration, "
                "or to the "
                "step itself. Each of the following makes position and velocity exact at every frame; the "
                "cells step "
                "with the correction and compare with the true motion."
              : "A correction would be something to add: to the launch, to what is read out, to the "
                "acceleration, or "
                "to the step itself. There is none of the kinds that were tried.";
  l.document.text("corrections", text);
  for (const CorrectionOption& option : l.kit.options) {
    if (!option.exists) continue;
    const Correction* launch = as_launch(l, option);
    text = "### " + title(option) + "\n\n" + listed(option, l.d);
    std::string code =
        motion_function(l, repair_name(option), "Position and velocity at frames 0..steps, corrected.",
                        repair(option), false) +
        "\n\n";
    code += "for letters in draws:\n";
    code += "    frames = " + repair_name(option) +
            "(LAST, **letters)\n    for n in range(FIRST, LAST + 1):\n" +
            "        assert frames[n] == (exact_position(n, **letters), exact_velocity(n, **letters))\n";
    if (launch) {
      text +=
          "\nThe shortfall of the position is a constant times $t$, and a constant times a time is a "
          "velocity: the "
          "body moves as if it had been launched with another velocity. That is why one number, added once, "
          "repairs every frame.\n";
      code +=
          "    " + l.arguments() + " = letters.values()\n" + "    for n in range(FIRST, LAST + 1):\n" +
          wrapped(
              8, "assert shortfall_position(n, **letters) == ", "(" + l.python(launch->add) + ") * (n * h)") +
          "\n";
    }
    code += "print(f\"Exact at frames {FIRST} to {LAST}, for {len(draws)} sets of letters.\")\n";
    l.document.text("correction", text);
    l.document.code("correction-check", code);
  }
}

}  // namespace shortfall
