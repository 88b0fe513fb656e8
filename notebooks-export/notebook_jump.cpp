// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump.hpp"
#include "notebooks-export/example_setting.hpp"
#include "notebooks-export/notebook_lecture.hpp"

namespace shortfall {

namespace {

const Rational kHeights[] = {Rational(2, 5), Rational(17, 10)};

/// The jump to a height, or nothing where it is no plain rise and fall.
std::optional<Jump> plain_jump(const Lecture& l, const Rational& height) {
  JumpQuestion question{height, kExampleFrame, kExampleGravity, l.d.substeps, l.given, 0};
  try {
    Jump j = jump(l.program, question);
    // A tie cannot be decided from a launch velocity of 60 digits.
    const bool plain = j.lifts_off && !j.tie && Surd(j.best_frame.n * kExampleFrame) < j.ideal_time * Surd(2);
    return plain ? std::optional(std::move(j)) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;  // the lecture does without its example
  }
}

std::string centimetres(const Surd& metres) { return (Surd(100) * metres).decimal(9); }

/// The parameters at their usual values: ", beta=Fraction(1, 4)".
std::string usual(const Lecture& l) {
  std::string text;
  for (const auto& [parameter, value] : l.step.parameters())
    text += ", Fraction(" + value.numerator().str() + ", " + value.denominator().str() + ")";
  return text;
}

std::string helpers(const Lecture& l) {
  return R"py(from decimal import ROUND_HALF_UP, Decimal, localcontext

g, dt = Fraction(981, 100), Fraction(1, 50)  # m/s^2, s


def decimal(q):
    """A fraction to 60 digits."""
    with localcontext() as context:
        context.prec = 60
        return Decimal(q.numerator) / Decimal(q.denominator)


def root(q):
    """The square root of a fraction, to 60 digits, as a fraction."""
    with localcontext() as context:
        context.prec = 60
        return Fraction(decimal(q).sqrt())


def rounded(q, places):
    return format(decimal(q).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP), "f")


def launch(height):
    """How a jump begins, as the arguments of the formulas: x0, v0, a, h)py" +
         (l.step.parameters().empty() ? std::string() : ", and the usual parameters") + R"py(."""
    return Fraction(0), root(2 * g * height), -g, dt)py" +
         usual(l) + "\n";
}

std::string table(const std::vector<Jump>& jumps) {
  std::string text =
      "| height aimed at | highest frame | its height | short by | of it by the integrator | of it between "
      "frames |\n"
      "|---|---|---|---|---|---|\n";
  for (const Jump& j : jumps)
    text += "| " + j.target.decimal(2) + " m | " + j.best_frame.n.str() + " | " +
            j.best_frame.height.decimal(12) + " m | " + centimetres(j.shortfall.total) + " cm | " +
            centimetres(j.shortfall.method) + " cm | " + centimetres(j.shortfall.sampling) + " cm |\n";
  return text;
}

std::string claims(const std::vector<Jump>& jumps) {
  std::string text = "claims = {\n";
  for (const Jump& j : jumps)
    text += "    Fraction(" + j.target.numerator().str() + ", " + j.target.denominator().str() + "): (" +
            j.best_frame.n.str() + ", \"" + j.best_frame.height.decimal(12) + "\", \"" +
            centimetres(j.shortfall.total) + "\", \"" + centimetres(j.shortfall.method) + "\", \"" +
            centimetres(j.shortfall.sampling) + "\"),\n";
  return text + "}\n";
}

/// `frames` of a jump, from the launch until the body is back where it began.
std::string flight(const std::string& function, bool with_carried) {
  return std::string("    ") + (with_carried ? "_, " : "") + "frames = " + function +
         "(LONG, *launch(height))\n";
}

void tell_corrected(Lecture& l, const std::vector<Jump>& jumps) {
  const CorrectionOption* best = l.kit.best();
  if (!best) return;
  const std::string function = repair_name(*best);
  std::string text =
      "With the correction *" + best->name + "* from above every frame lies on the true parabola";
  const Expr& by = repair(*best).launch_v;
  std::string code = "for height in claims:\n" + flight(function, false) +
                     "    for n in range(FIRST, LONG + 1):\n"
                     "        assert frames[n][0] == exact_position(n, *launch(height))\n"
                     "    highest = max(x for x, v in frames)\n";
  std::string values;
  const bool same_frames = jumps.front().corrected && jumps.back().corrected;
  if (same_frames) {
    text += ". What is still missing falls between frames";
    for (const Jump& j : jumps) {
      text += (&j == &jumps.front() ? ": " : " and ") + centimetres(j.corrected->shortfall.total) +
              " cm at " + j.target.decimal(2) + " m";
      values += (values.empty() ? "\"" : ", \"") + centimetres(j.corrected->shortfall.total) + "\"";
    }
    code += "    still_short.append(rounded(100 * (height - highest), 9))\n";
    code = "still_short = []\n" + code + "assert still_short == [" + values + "]\n";
  }
  text += ".";
  if (by && l.step.parameters().empty() && l.given.empty() && jumps.front().correction.exists) {
    const std::string velocity = jumps.front().correction.value(kExampleGravity).decimal(4);
    text += " With $a = -g$ it adds " + inlined(by) + " $= " + velocity + "$ m/s to every launch.";
    code = "a, h = -g, dt\nassert rounded(" + l.python(by) + ", 4) == \"" + velocity + "\"\n" + code;
  }
  code += "print(\"Corrected, every frame lies on the true parabola.\")\n";
  l.document.text("jump-corrected", text);
  l.document.code("jump-corrected-check", code);
}

}  // namespace

void tell_jump(Lecture& l) {
  if (l.d.degree > 0) return;
  std::vector<Jump> jumps;
  for (const Rational& height : kHeights) {
    std::optional<Jump> j = plain_jump(l, height);
    if (!j) return;
    jumps.push_back(std::move(*j));
  }
  std::string text = l.heading("The jump") + "\n\n";
  text +=
      "A game wants a body to jump to a height $H$ under gravity $g = 9.81\\ \\mathrm{m/s^2}$, and launches "
      "it with "
      "$u = \\sqrt{2 g H}$. In exact motion it would just get there. Stepped at 50 frames a second, $h = "
      "1/50$ s, this "
      "is what a player sees:\n\n" +
      table(jumps) +
      "\nThe integrator's part is the shortfall that was derived above, with $a = -g$ at the time of the "
      "highest "
      "frame. The other part is there for any integrator, because the true top falls between two frames.";
  if (jumps.front().shortfall.total.sign() < 0) text += " A minus sign says that the body rises too high.";
  l.document.text("jump", text);
  l.document.code("jump-check",
                  helpers(l) + "\n\n" + "LONG = 80  # frames, more than either jump takes\n" + claims(jumps) +
                      "for height, (top, reached, short, by_integrator, between) in claims.items():\n" +
                      flight("stepped", l.is_complex()) +
                      R"py(    x = [frame[0] for frame in frames]
    n = max(range(LONG), key=lambda n: x[n])
    assert n == top
    assert rounded(x[n], 12) == reached
    lost = shortfall_position(n, *launch(height))
    missed = height - exact_position(n, *launch(height))
    assert height - x[n] == lost + missed  # exactly
    assert rounded(100 * (height - x[n]), 9) == short
    assert rounded(100 * lost, 9) == by_integrator
    assert rounded(100 * missed, 9) == between
    print(f"A jump to {rounded(height, 2)} m: frame {n} is the highest, short by {short} cm.")
)py");
  if (!l.is_exact()) tell_corrected(l, jumps);
  l.document.text("picture",
                  "A picture of the jump to 40 cm; run, the cell draws it anew where matplotlib is "
                  "installed. No claim needs it.");
  const CorrectionOption* best = l.kit.best();
  std::string code = R"py(try:
    import matplotlib.pyplot as plt
except ImportError:
    print("matplotlib is not installed: no picture")
else:
    height = Fraction(2, 5)
    count = int(2 * root(2 * g * height) / g / dt) + 1
    fine = [Fraction(i, 10) for i in range(10 * count + 1)]
    times = [float(n * dt) for n in range(count + 1)]
    fig, axes = plt.subplots()
    axes.plot(
        [float(n * dt) for n in fine],
        [float(exact_position(n, *launch(height))) for n in fine],
        label="true motion",
    )
)py";
  const auto plotted = [&](const std::string& function, const std::string& index, const std::string& marker,
                           const std::string& label) {
    code += "    frames = " + function + "(count, *launch(height))" + index + "\n" +
            "    axes.plot(times, [float(frame[0]) for frame in frames], \"" + marker + "\", label=\"" +
            label + "\")\n";
  };
  plotted("stepped", l.is_complex() ? "[1]" : "", "o", l.d.integrator);
  if (!l.is_exact() && best) plotted(repair_name(*best), "", "x", "corrected: " + best->name);
  code += R"py(    axes.axhline(float(height), color="grey", linewidth=0.8)
    axes.set_xlabel("time t in s")
    axes.set_ylabel("height in m")
    axes.legend()
    plt.show()
)py";
  l.document.code("picture", code, l.jump_picture);
}

}  // namespace shortfall
