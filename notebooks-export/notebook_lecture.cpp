// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/notebook_lecture.hpp"

#include <algorithm>

namespace shortfall {

namespace {

constexpr int kFewestFrames = 12;

/// The first frame from which on the closed forms of all carried vectors give what stepping gives.
int settled_frame(const Derivation& d) {
  const int states = d.map.force.states;
  const auto values = stepped(d.map, states);
  const auto holds = [&](int n) {
    for (int s = 0; s < states; ++s)
      for (int c = 0; c < 2 + d.degree + 1; ++c) {
        const int source = c < 2 ? c : d.map.force.force_column(c - 2);
        if (!(d.form.states[s][c].at(n) == values[n][s][source])) return false;
      }
    return true;
  };
  for (int n = states; n > 0; --n)
    if (!holds(n - 1)) return n;
  return 0;
}

}  // namespace

Lecture::Lecture(const Program& p, const Values& g, const Derivation& derived, const CorrectionKit& k)
    : program(p),
      given(g),
      d(derived),
      kit(k),
      step(p, g, derived.substeps),
      first(derived.form.valid_from),
      settled(settled_frame(derived)) {
  last = std::max(kFewestFrames, std::max(first, settled) + points());
  wording_.name = [this](const std::string& name) { return step.name(name); };
  wording_.whole = {"n", "k"};
}

std::vector<std::string> Lecture::launch_letters() const {
  std::vector<std::string> letters{"x0", "v0"};
  for (int c = 2; c < 2 + d.degree + 1; ++c) letters.push_back(column_name(c, d.degree));
  return letters;
}

std::string Lecture::arguments() const {
  std::string text;
  for (const std::string& letter : launch_letters()) text += letter + ", ";
  return text + "h" + step.more();
}

Expr Lecture::acceleration() const {
  Expr total = number(0);
  for (int i = 0; i <= d.degree; ++i)
    total = total + name(column_name(2 + i, d.degree)) * power(name("t"), i);
  return total;
}

int Lecture::points() const { return d.steps.empty() ? d.proof.points : d.steps.front().points; }

Expr Lecture::reported(const std::string& letter) const {
  const std::string made = letter + "_out";
  const bool by_finish = std::ranges::any_of(d.steps, [&](const DerivationStep& s) {
    return s.left->op == Expression::Op::name && s.left->name == made;
  });
  return name(by_finish ? made : letter + "_n");
}

std::string Lecture::frames() const {
  return "$n = " + std::to_string(first) + ", \\dots, " + std::to_string(last) + "$";
}

std::string Lecture::heading(const std::string& title) {
  return "## " + std::to_string(++sections_) + ". " + title;
}

std::string Lecture::formula_function(const std::string& name, const std::string& what,
                                      const Expr& formula) const {
  std::string text = "def " + name + "(n, " + arguments() + "):\n    \"\"\"" + what + "\"\"\"\n";
  if (mentions(formula, "t")) text += "    t = n * h\n";
  return text + wrapped(4, "return ", python(formula)) + "\n";
}

std::string motion_function(const Lecture& l, const std::string& name, const std::string& what,
                            const Repair& r, bool with_carried) {
  const auto shifted = [&](const std::string& start, const Expr& by) {
    return by ? l.python(shortfall::name(start) + by) : start;
  };
  const std::string state = l.step.state();
  std::string text =
      "def " + name + "(steps, " + r.arguments + l.arguments() + "):\n    \"\"\"" + what + "\"\"\"\n";
  const Expr f = r.force ? l.acceleration() + r.force : l.acceleration();
  text += "\n    def force(x, v, t):\n" + wrapped(8, "return ", l.python(f)) + "\n\n    t = Fraction(0)\n";
  if (r.launch_x) text += wrapped(4, "x = ", shifted("x0", r.launch_x)) + "\n";
  if (r.launch_v) text += wrapped(4, "v = ", shifted("v0", r.launch_v)) + "\n";
  if (!r.launch_x && !r.launch_v) text += "    x, v = x0, v0\n";
  if (static_cast<bool>(r.launch_x) != static_cast<bool>(r.launch_v))
    text += r.launch_x ? "    v = v0\n" : "    x = x0\n";
  if (l.step.has_start()) text += "    " + state + " = start(x, v, t, h, force" + l.step.more() + ")\n";
  text += with_carried ? "    carried, frames = [], []\n" : "    frames = []\n";
  text += "    for _ in range(steps + 1):\n";
  if (with_carried) text += "        carried.append((" + state + "))\n";
  const bool reads = r.read_x || r.read_v;
  if (l.step.has_finish())
    text += "        x_out, v_out = finish(" + state + ", t, h, force" + l.step.more() + ")\n";
  else if (reads)
    text += "        x_out, v_out = x, v\n";
  if (r.read_v) text += wrapped(8, "v_out = ", shifted("v_out", r.read_v)) + "\n";
  // A shift of the position by the velocity means the velocity that is read out.
  if (r.read_x)
    text += wrapped(8, "x_out = ", shifted("x_out", replace(r.read_x, "v", shortfall::name("v_out")))) + "\n";
  text += l.step.has_finish() || reads ? "        frames.append((x_out, v_out))\n"
                                       : "        frames.append((x, v))\n";
  text += "        " + state + " = step(" + state + ", t, h, force" + l.step.more() + ")\n";
  if (r.term_x) text += wrapped(8, "x = ", shifted("x", r.term_x)) + "\n";
  if (r.term_v) text += wrapped(8, "v = ", shifted("v", r.term_v)) + "\n";
  text += "        t = t + h\n";
  return text + (with_carried ? "    return carried, frames\n" : "    return frames\n");
}

}  // namespace shortfall
