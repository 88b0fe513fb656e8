// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/notebook.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/notebook_lecture.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall {

namespace {

/// The block of a draw of random values for the letters.
std::string draws(const Lecture& l) {
  std::string text =
      "draws = []  # values for all letters of the formulas\nfor _ in range(4):\n    draws.append({\n";
  for (const std::string& letter : l.launch_letters()) text += "        \"" + letter + "\": some(),\n";
  text += "        \"h\": Fraction(1, random.randint(2, 60)),\n";
  std::string usual;
  for (const auto& [parameter, value] : l.step.parameters()) {
    const std::string name = l.step.name(parameter);
    text += "        \"" + name + "\": Fraction(random.randint(1, 30), 31),\n";
    usual += (usual.empty() ? "" : ", ") + name + "=Fraction(" + value.numerator().str() + ", " +
             value.denominator().str() + ")";
  }
  text += "    })\n";
  if (!usual.empty()) text += "draws[0].update(" + usual + ")  # as the integrator comes\n";
  return text;
}

std::string letters_list(const Lecture& l) {
  std::string text = "- $x_0$ and $v_0$: position and velocity at the launch (dimensions L, L/T)\n";
  if (l.d.degree == 0)
    text += "- $a$: the acceleration, force over mass (L/T²)\n";
  else
    text += "- $f_0, \\dots, f_{" + std::to_string(l.d.degree) +
            "}$: the coefficients of the acceleration, force over mass (L/T², L/T³, ...)\n";
  text +=
      "- $h$: the step, the time from frame to frame (T)\n"
      "- $n$: how many steps were taken; $t = n h$: the time then (T)\n";
  for (const auto& [parameter, value] : l.step.parameters())
    text += "- " + inlined(name(parameter)) + ": a parameter of the integrator, usually " + value.str() +
            " (" + l.program.parameter(parameter)->dimension.str() + ")\n";
  return text;
}

/// What the coefficients of the acceleration are called, in Python: "[f0, f1, f2]".
std::string coefficients(const Lecture& l) {
  std::string text;
  for (int c = 0; c <= l.d.degree; ++c) text += (c ? ", " : "") + column_name(2 + c, l.d.degree);
  return "[" + text + "]";
}

std::string command(const Lecture& l) {
  std::string text = "shortfall export " + l.d.integrator + " --force " +
                     (l.d.degree == 0 ? "constant" : "poly:" + std::to_string(l.d.degree));
  if (l.d.substeps > 1) text += " --substeps " + std::to_string(l.d.substeps);
  for (const auto& [name, value] : l.given) text += " --param " + name + "=" + value.str();
  return text + " --notebook";
}

}  // namespace

void tell_title(Lecture& l) {
  const Derivation& d = l.d;
  std::string text =
      "# The shortfall of " + d.integrator + "\n\n**Under " + force_words(d) +
      (l.is_exact() ? " it has none: it is exact at every frame" : ": what it is, why, and what repairs it") +
      ".**\n\n";
  text +=
      "An integrator moves a body from frame to frame by a simple rule. This notebook finds where *" +
      d.integrator +
      "* has put the body after $n$ steps, exactly and for every $n$, and subtracts that from where the body "
      "should be. What is left is the **shortfall**: exact minus computed, positive where the computed value "
      "is "
      "too low.\n\n";
  text += displayed(name("x(t)") - l.reported("x"), d.shortfall_position) + "\n\n" +
          displayed(name("v(t)") - l.reported("v"), d.shortfall_velocity) + "\n\n";
  if (d.form.valid_from > 0)
    text += "This holds for $n \\ge " + std::to_string(d.form.valid_from) +
            "$; before that, the start of the integrator is still felt.\n\n";
  text +=
      "Nothing here is rounded, and nothing has to be believed: after each claim follows a cell that asserts "
      "it "
      "with fractions, and Python's standard library is all it needs. Run all cells; a claim that is wrong "
      "stops "
      "the notebook there.\n\n" +
      letters_list(l);
  l.document.text("title", text);
}

void tell_integrator(Lecture& l) {
  std::string text = l.heading("The integrator") + "\n\n";
  if (!l.program.description.empty()) text += sentence(markdown_escaped(l.program.description)) + "\n\n";
  for (const std::string& source : l.program.sources)
    text += (&source == &l.program.sources.front() ? "Published by\n\n- " : "- ") + markdown_escaped(source) +
            "\n";
  if (!l.program.sources.empty()) text += "\n";
  Program bare = l.program;
  bare.description.clear();
  bare.aliases.clear();
  bare.sources.clear();
  bare.claims.clear();
  text +=
      "It is written down once, as a short program. `x` and `v` are position and velocity, `h` is the step, "
      "and "
      "`a(x, v, t)` asks for the acceleration. Statements run in order: a name holds its new value from then "
      "on.\n\n"
      "```\n" +
      print(bare) + "```\n\n";
  if (l.program.tableau)
    text +=
        "The tableau is applied to $x' = v$, $v' = a(x, v, t)$: stage $i$ has the velocity `v1`, `v2`, ... "
        "and the "
        "acceleration `k1`, `k2`, ...\n\n";
  if (l.d.substeps > 1)
    text += "Here it takes " + std::to_string(l.d.substeps) + " steps of $h/" + std::to_string(l.d.substeps) +
            "$ in every frame, and $h$ is the length of the frame.\n\n";
  for (const auto& [name, value] : l.given)
    text += "Here " + inlined(shortfall::name(name)) + " $= " + value.str() + "$.\n\n";
  text += "The same in Python; with fractions it computes exactly.";
  if (!l.step.solver().empty())
    text +=
        " The rule is implicit: it asks for accelerations that satisfy an equation in which they occur. "
        "`solved` "
        "finds them, exactly.";
  l.document.text("integrator", text);
  std::string code = "from fractions import Fraction\nfrom random import Random\n\n\n";
  if (!l.step.solver().empty()) code += l.step.solver() + "\n\n";
  l.document.code("step", code + l.step.functions());
}

void tell_problem(Lecture& l) {
  const Derivation& d = l.d;
  std::string text = l.heading("The problem") + "\n\nThe body feels " + force_words(d) + ",\n\n";
  text += displayed(name("x''(t)"), l.acceleration()) + "\n\n";
  text +=
      "and starts at time 0 from $x_0$ with the velocity $v_0$. Integrating once gives its true velocity, "
      "integrating twice its true position:\n\n" +
      displayed(name("v(t)"), d.exact_velocity) + "\n\n" + displayed(name("x(t)"), d.exact_position) +
      "\n\n" +
      "The cell does these two integrals on the list of coefficients, for four sets of random letters, and "
      "compares.";
  l.document.text("problem", text);
  std::string code =
      "FIRST, LAST = " + std::to_string(l.first) + ", " + std::to_string(l.last) +
      "  # the frames that are compared\nrandom = Random(20240808)\n\n\n"
      "def some():\n"
      "    \"\"\"A random fraction, not 0.\"\"\"\n"
      "    return random.choice([-1, 1]) * Fraction(random.randint(1, 40), random.randint(1, 9))\n\n\n" +
      draws(l) + "\n\n" + l.formula_function("exact_position", "x(t) at t = n h.", d.exact_position) +
      "\n\n" + l.formula_function("exact_velocity", "v(t) at t = n h.", d.exact_velocity) +
      "\n\n"
      "def integral(coefficients, constant):\n"
      "    \"\"\"Of a polynomial, lowest power first.\"\"\"\n"
      "    return [constant] + [c / (i + 1) for i, c in enumerate(coefficients)]\n\n\n"
      "def value(coefficients, t):\n"
      "    return sum(c * t**i for i, c in enumerate(coefficients))\n\n\n"
      "for letters in draws:\n"
      "    " +
      l.arguments() +
      " = letters.values()\n"
      "    v = integral(" +
      coefficients(l) +
      ", v0)\n"
      "    x = integral(v, x0)\n"
      "    for n in range(LAST + 1):\n"
      "        assert exact_velocity(n, **letters) == value(v, n * h)\n"
      "        assert exact_position(n, **letters) == value(x, n * h)\n"
      "print(\"The true motion is the twofold integral of the acceleration.\")\n";
  l.document.code("problem-check", code);

  l.document.text(
      "stepping",
      "And this is what the integrator makes of it, frame by frame: the truth that every formula below "
      "is held against.");
  const bool complex = l.is_complex();
  l.document.code("stepping-code",
                  motion_function(l, "stepped",
                                  complex ? "What is carried at frames 0..steps, and what is read out there."
                                          : "Position and velocity at frames 0..steps.",
                                  {}, complex) +
                      "\n\nruns = [stepped(LAST, **letters) for letters in draws]\n");
}

void tell_result(Lecture& l) {
  const Derivation& d = l.d;
  l.document.text(
      "result", l.heading("The result") + "\n\nAfter $n$ steps, at $t = n h$, the integrator reads out\n\n" +
                    displayed(l.reported("x"), d.position) + "\n\n" + displayed(l.reported("v"), d.velocity) +
                    "\n\nThe cell steps and compares, at " + l.frames() + ".");
  const std::string loop = std::string("for letters, ") + (l.is_complex() ? "(_, frames)" : "frames") +
                           " in zip(draws, runs):\n" + "    for n in range(FIRST, LAST + 1):\n";
  l.document.code("result-check",
                  l.formula_function("position", "x_n in closed form.", d.position) + "\n\n" +
                      l.formula_function("velocity", "v_n in closed form.", d.velocity) + "\n\n" + loop +
                      "        assert frames[n] == (position(n, **letters), velocity(n, **letters))\n"
                      "print(f\"The closed form is what stepping gives: {len(draws)} sets of letters, frames "
                      "{FIRST} to {LAST}.\")\n");

  std::string text = l.heading("The shortfall") + "\n\n";
  text += "Subtract what was computed from what is true, at the same time $t = n h$:\n\n" +
          displayed(name("x(t)") - l.reported("x"), d.shortfall_position) + "\n\n" +
          displayed(name("v(t)") - l.reported("v"), d.shortfall_velocity) + "\n\n";
  if (l.is_exact())
    text +=
        "Both are 0: at every frame the body is exactly where it should be, as fast as it should be. Between "
        "frames nothing is claimed.";
  else
    text += "Positive means that the computed value is too low.";
  l.document.text("shortfall", text);
  l.document.code(
      "shortfall-check",
      l.formula_function("shortfall_position", "Exact minus computed position.", d.shortfall_position) +
          "\n\n" +
          l.formula_function("shortfall_velocity", "Exact minus computed velocity.", d.shortfall_velocity) +
          "\n\n" + loop +
          "        x, v = frames[n]\n"
          "        assert exact_position(n, **letters) - x == shortfall_position(n, **letters)\n"
          "        assert exact_velocity(n, **letters) - v == shortfall_velocity(n, **letters)\n"
          "print(\"Exact minus stepped is the shortfall.\")\n");
}

void tell_proof(Lecture& l) {
  const MotionProof& proof = l.d.proof;
  const std::string order = std::to_string(proof.recurrence);
  std::string text = l.heading("How it was proved") + "\n\n";
  text +=
      "What stepping gives and what a formula gives are two functions of $n$ that satisfy one linear "
      "recurrence, "
      "here of order " +
      order + ": if they agree at " + order +
      " consecutive $n$, they agree at all that follow. `shortfall` compared the result at " +
      std::to_string(proof.points) + " of them" +
      (l.d.steps.empty()
           ? ""
           : ", and each line of the derivation at " + std::to_string(l.d.steps.front().points)) +
      ", with all letters left as letters; that is a proof for every $n$ and all values of the letters. Of "
      "each "
      "correction it was shown that the corrected motion and the true one are the same function of $n$, $h$ "
      "and "
      "all letters.\n\n";
  text +=
      "The cells above did it again with numbers for the letters. They compared enough frames that, for "
      "these "
      "numbers, they are a proof for every $n$ too.\n\nAssumed:\n\n";
  for (const std::string& a : l.d.assumptions) text += "- " + sentence(markdown_escaped(a)) + "\n";
  text += "\nThis notebook was written by `" + command(l) + "`.";
  l.document.text("proof", text);
  const int from = std::max(l.first, l.settled);
  l.document.code("proof-check", "assert LAST " + (from ? "- " + std::to_string(from) + " " : std::string()) +
                                     ">= " + std::to_string(l.points()) +
                                     "  # enough for each line\nprint(\"Every claim above holds.\")\n");
}

std::string notebook(const Program& program, const Values& given, const Derivation& d,
                     const CorrectionKit& kit, const std::string& jump_picture) {
  if (d.degree > kHighestNotebookDegree)
    throw Unable("a notebook is written for forces of degree up to " +
                 std::to_string(kHighestNotebookDegree) + ", not " + std::to_string(d.degree));
  Lecture lecture(program, given, d, kit);
  lecture.jump_picture = jump_picture;
  tell_title(lecture);
  tell_integrator(lecture);
  tell_problem(lecture);
  tell_derivation(lecture);
  tell_result(lecture);
  tell_corrections(lecture);
  tell_impossible(lecture);
  tell_jump(lecture);
  tell_proof(lecture);
  return lecture.document.json();
}

}  // namespace shortfall
