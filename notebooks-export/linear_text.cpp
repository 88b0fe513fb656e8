// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/linear_text.hpp"

#include <algorithm>

#include "analysis/correction/kit_letters.hpp"
#include "notebooks-export/linear_implicit.hpp"
#include "notebooks-export/named_formulas.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall {

namespace {

std::string equation_of_motion(const LinearDerivation& d, Style style) {
  Expr f = number(0);
  const Wording w = d.wording();
  for (int i = 0; i <= d.force.degree; ++i)
    f = f + name(column_name(2 + i, d.force.degree)) * power(name("t"), i);
  if (d.force.spring) f = f - formula(d.force.stiffness(), name("x"), w);
  if (d.force.damper) f = f - formula(d.force.damping(), name("v"), w);
  return (style == Style::latex ? "\\ddot x = " : "x'' = ") + print(f, style);
}

std::string kind(LinearCorrection::Kind k) {
  switch (k) {
    case LinearCorrection::Kind::parameter:
      return "parameter";
    case LinearCorrection::Kind::launch:
      return "launch";
    case LinearCorrection::Kind::read_out:
      return "read-out";
  }
  return "";
}

/// Broken between words into lines of at most 125 columns; the lines after the first are indented.
std::string wrapped(const std::string& text, const std::string& indent) {
  constexpr std::size_t kColumns = 125;
  std::string result, row;
  std::size_t width = 0;
  const auto columns = [](const std::string& s) {
    return static_cast<std::size_t>(std::ranges::count_if(s, [](char c) { return (c & 0xC0) != 0x80; }));
  };
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find(' ', begin);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (width > 0 && width + 1 + columns(word) > kColumns) {
      result += row + "\n";
      row = indent;
      width = indent.size();
    } else if (width > 0) {
      row += " ";
      ++width;
    }
    row += word;
    width += columns(word);
  }
  return result + row + "\n";
}

void append_definitions(std::string& text, const std::vector<Definition>& definitions, NamedFormulas& f) {
  for (const Definition& d : definitions)
    text += "    " + print(name(d.name), f.style()) + " = " + f.print(d.value) + "   (" + d.note + ")\n";
}

/// "x_n = ...", the signs of equality below each other.
std::string line(const std::string& what, const Expr& e, NamedFormulas& f) {
  return what + " = " + f.print(e);
}

Expr conserved_form(const QuadraticForm& q, const Wording& w) {
  const Expr square = power(name("v"), 2);
  const bool minus = !q.xv.is_zero() && q.xv.numerator().terms().front().coefficient.sign() < 0;
  const Expr mixed = chained(formula(minus ? -q.xv : q.xv, w), name("x") * name("v"));
  return joined(minus ? square - mixed : joined(square, mixed), formula(q.xx, power(name("x"), 2), w));
}

/// What the step does to the energy, or to the quadratic form that takes its place.
std::string energy(const LinearDerivation& d, const LinearKit& kit, NamedFormulas& f) {
  if (!d.force.spring) return "";
  if (!kit.conserved)
    return "\nEnergy\n  No quadratic form of x and v takes its place: a further carried vector matters.\n";
  const Wording w = d.wording();
  const QuadraticForm& q = *kit.conserved;
  std::string text = "\nEnergy\n  " + f.print(conserved_form(q, w));
  if (q.xv.is_zero() && q.xx == d.force.stiffness()) text += ", twice the energy,";
  text += q.factor == Fraction(1)
              ? " is conserved exactly by every step"
              : " is multiplied by D = " + f.print(formula(q.factor, w)) + " in every step";
  if (d.amplified_from > 0) text += " from n = " + std::to_string(d.amplified_from) + " on";
  return text + " (about the rest point; M^T Q M = D Q, proved).\n" + f.introduced();
}

void append_recurrence(std::string& text, const LinearDerivation& d, NamedFormulas& f) {
  const auto& p = d.form.oscillation.polynomial;
  const Wording w = d.wording();
  text += "  The free part r of the motion satisfies\n    r(n+" + std::to_string(d.form.oscillation.order()) +
          ")";
  for (int j = d.form.oscillation.order() - 1; j >= 0; --j)
    text += " + (" + f.print(formula(p[j], w)) + ") r(n" + (j ? "+" + std::to_string(j) : "") + ")";
  text += " = 0\n" + f.introduced();
}

std::string kit_text(const LinearKit& kit, NamedFormulas& f) {
  const Style style = f.style();
  if (!kit.exists)
    return std::string(kit.impossible ? "  none can be exact on every frame: "
                                      : "  none found that is exact on every frame: ") +
           kit.obstruction + "\n";
  std::string text;
  for (const std::string& note : kit.notes) text += "  " + wrapped(note, "    ");
  text += "  exact on every frame; give or report instead:\n";
  for (const LinearCorrection& c : kit.corrections)
    text +=
        "    " + kind(c.kind) + ": " + c.target + " := " + f.print(c.value) + "\n        " + c.reason + "\n";
  text += "  with\n";
  append_definitions(text, kit.definitions, f);
  for (const FlowCase& other : kit.other_flows) {
    text += "    for " + other.condition + ":\n";
    for (const auto& [letter, value] : {std::pair{kFlowCosine, other.cosine}, {kFlowSine, other.sine}})
      text += "      " + print(name(kit.letters[letter]), style) + " = " +
              print(replace(value, "t", name("h")), style) + "\n";
    for (const Definition& d : other.definitions)
      text += "      " + print(name(d.name), style) + " = " + print(d.value, style) + "\n";
  }
  for (const LinearCorrection& c : kit.corrections)
    if (mentions(c.value, "f'")) {
      text +=
          "    f', f'': derivatives of the force by time; in a launch at t = 0, in a read-out at t = n h\n";
      break;
    }
  if (kit.implicit) text += implicit_text(kit, f);
  if (!kit.step_definitions.empty()) text += "  and, of the step that is given these\n";
  append_definitions(text, kit.step_definitions, f);
  return text + f.introduced() + "  " + wrapped("proof: " + kit.proof, "    ");
}

/// All names of letters and definitions.
std::vector<std::string> names_in(const LinearKit& kit, const LinearDerivation* d) {
  std::vector<std::string> names = kit.letters;
  for (const auto* list : {&kit.definitions, &kit.step_definitions})
    for (const Definition& definition : *list) names.push_back(definition.name);
  if (d) names.insert(names.end(), d->map.letters.begin(), d->map.letters.end());
  return names;
}

/// "T^2 < 4 D, with T = ..., D = ...: two complex roots", without the formulas where these are long.
std::string condition(const LinearDerivation& d, bool full) {
  const std::size_t with = d.condition.find(", with T = "), colon = d.condition.rfind(": ");
  if (full || d.condition.size() <= kLongestPiece || with == std::string::npos || colon == std::string::npos)
    return d.condition;
  return d.condition.substr(0, with) + d.condition.substr(colon) + " (T and D are told below)";
}

}  // namespace

std::string as_text(const LinearKit& kit, Style style, bool full) {
  NamedFormulas f(style, full, names_in(kit, nullptr));
  return kit_text(kit, f);
}

std::string as_text(const LinearDerivation& d, const LinearKit& kit, Style style, bool full) {
  NamedFormulas f(style, full, names_in(kit, &d));
  const Wording w = d.wording();
  std::string text = d.integrator + ", " + equation_of_motion(d, style) + "\n";
  if (d.force.own_c || d.force.own_k)
    text += "This is the motion that " + d.integrator + " itself is meant for: its own " +
            (d.force.own_c ? "damping" : "spring") + " is physics, not an error.\n";
  if (d.substeps > 1)
    text += "h is the frame; it is stepped in " + std::to_string(d.substeps) + " substeps of h/" +
            std::to_string(d.substeps) + ".\n";
  text += "n steps, t = n h. " + exactness(d.digits) + "\n\n";
  if (d.position) {
    text +=
        "  " + line("position x_n ", d.position, f) + "\n  " + line("velocity v_n ", d.velocity, f) + "\n";
    append_definitions(text, d.definitions, f);
    text += f.introduced();
    if (!d.condition.empty()) text += "    for " + condition(d, full) + "\n";
    for (const RootCase& c : d.cases)
      text += "  " + c.condition + ":\n    " + line("x_n", c.position, f) + "\n    " +
              line("v_n", c.velocity, f) + "\n" + f.introduced();
  } else {
    append_recurrence(text, d, f);
    text +=
        "  from its first values (--json has them); an order above two has no shorter formula than its "
        "roots.\n";
  }
  text += "\n  true motion, for " + d.exact.condition + "\n";
  text += "  " + line("x(t) ", d.exact.position, f) + "\n  " + line("v(t) ", d.exact.velocity, f) + "\n";
  append_definitions(text, d.exact.definitions, f);
  for (const FlowCase& other : d.exact.others) {
    text += "  for " + other.condition + ":\n    " + line("x(t)", other.position, f) + "\n";
    append_definitions(text, other.definitions, f);
  }
  text += "  The shortfall is x(t) - x_n and v(t) - v_n: positive means too low.\n";
  if (!d.amplification.empty()) {
    text +=
        "\nWhy\n  One step is linear: (x, v) becomes M (x, v) plus a push" +
        (d.amplified_from > 0 ? ", from n = " + std::to_string(d.amplified_from) + " on" : std::string()) +
        ", with\n";
    for (const auto& row : d.amplification)
      text += "    [ " + f.print(formula(row[0], w)) + ",  " + f.print(formula(row[1], w)) + " ]\n";
    text += "  trace T = " + f.print(formula(*d.trace, w)) +
            ", determinant D = " + f.print(formula(*d.determinant, w)) + "\n" + f.introduced();
    text +=
        "  M^2 = T M - D (Cayley and Hamilton), so every free motion satisfies x(n+2) = T x(n+1) - D x(n); "
        "its solutions are the powers of the\n"
        "  roots of z^2 = T z - D. A push adds a motion of its own, found by comparing powers of n. The two "
        "first values fix the rest.\n";
  }
  text += energy(d, kit, f);
  text += "\nCorrections\n" + kit_text(kit, f);
  text += "\nProof\n  ";
  text +=
      d.proof.proved
          ? "Closed form and stepping satisfy one linear recurrence of order " +
                std::to_string(d.proof.recurrence) +
                " and agree, all letters symbolic, at\n  as many consecutive n. Hence they agree for every n."
          : "NOT PROVED: this is a bug of ours; please report it.";
  text += "\n  Checked besides: " + sentence(d.check) + "\nAssumed: ";
  for (std::size_t i = 0; i < d.assumptions.size(); ++i) text += (i ? "; " : "") + d.assumptions[i];
  return text + ".\n";
}

std::string as_latex(const LinearDerivation& d, const LinearKit& kit, bool full) {
  NamedFormulas f(Style::latex, full, names_in(kit, &d));
  std::string text = "% " + d.integrator + ", " + equation_of_motion(d, Style::language) +
                     "; needs amsmath\n\\begin{align*}\n";
  const auto add = [&](const std::string& left, const Expr& right) {
    text += "  " + left + " &= " + f.print(right) + " \\\\\n";
  };
  if (d.position) {
    add("x_n", d.position);
    add("v_n", d.velocity);
    for (const Definition& definition : d.definitions)
      add(print(name(definition.name), Style::latex), definition.value);
  }
  add("x(t)", d.exact.position);
  add("v(t)", d.exact.velocity);
  for (const Definition& definition : d.exact.definitions)
    add(print(name(definition.name), Style::latex), definition.value);
  for (const LinearCorrection& c : kit.corrections)
    add("\\tilde{" + print(name(c.target), Style::latex) + "}", c.value);
  for (const auto* list : {&kit.definitions, &kit.step_definitions})
    for (const Definition& definition : *list)
      add(print(name(definition.name), Style::latex), definition.value);
  for (const auto& [name, value] : f.introduced_pairs()) text += "  " + name + " &= " + value + " \\\\\n";
  return text + "\\end{align*}\n";
}

}  // namespace shortfall
