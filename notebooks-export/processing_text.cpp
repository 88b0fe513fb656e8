// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/processing_text.hpp"

#include "notebooks-export/series_text.hpp"

namespace shortfall {

namespace {

std::string sum_of(const std::vector<FieldTerm>& terms, const std::string& component,
                   const SeriesSource& source, Style style) {
  SumByPowers sum(source, style);
  for (const FieldTerm& t : terms)
    if (t.component == component) sum.add(t.power, t.coefficient, t.differential);
  return sum.str();
}

void put_change(std::string& text, const std::string& title, const std::vector<FieldTerm>& terms,
                const std::string& where, const std::string& index, const SeriesSource& source, Style style) {
  bool first = true;
  for (const char* component : {"x", "v"}) {
    const std::string sum = sum_of(terms, component, source, style);
    if (sum.empty()) continue;
    const std::string old = print(name(component + index), style);
    text += first ? "    " + title : std::string(4 + title.size(), ' ');
    text += (index == "0" ? old : std::string(component)) + " := " + old + sum +
            (first ? "     (" + where + ")" : "") + "\n";
    first = false;
  }
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

std::string as_text(const Processing& p, const std::vector<std::string>& twins, const SeriesSource& source,
                    Style style) {
  std::string text =
      "  every force " + p.forces->force + ": order " + std::to_string(p.plain_order) + " by itself";
  if (p.effective_order > p.plain_order)
    text += ", effective order " + std::to_string(p.effective_order) +
            (p.force.empty() ? " with launch and read-out" : " with force, launch and read-out");
  else
    text += "; no launch and read-out" +
            std::string(p.obstruction.empty() ? " was looked for beyond that" : " raises it");
  text += "\n";
  if (p.effective_order > p.plain_order) {
    if (!p.force.empty())
      text += "    force      the step is given a" + sum_of(p.force, "v", source, style) + " instead of a\n";
    put_change(text, "launch     ", p.launch,
               "once, before the first step; right-hand sides at the old x0, v0", "0", source, style);
    put_change(text, "read-out   ", p.read_out,
               "for what is shown only, at x_n, v_n; the steps go on from these", "_n", source, style);
    if (text.find("a_") != std::string::npos)
      text += "    (a_x u is the derivative of a along u; terms of higher order in h do not matter)\n";
    if (!twins.empty())
      text += "    With these it is " + joined_names(twins) +
              ", step for step: proved, both are the same formula with a left open.\n";
  }
  if (!p.obstruction.empty()) {
    text += "    order " + std::to_string(p.obstructed_at) + " " +
            (p.proved ? "does not exist: " : "was not found: ") + p.obstruction + "\n";
    std::string combination;
    for (std::size_t i = 0; i < p.residual.size(); ++i) {
      const FieldTerm& t = p.residual[i];
      const bool minus = source.to_double(t.coefficient) < 0;
      const Fraction size = minus ? -t.coefficient : t.coefficient;
      combination += i == 0 ? (minus ? "-" : "") : minus ? " - " : " + ";
      if (!(size == Fraction(1))) combination += print(source.formula(size), style) + " ";
      combination += "b(" + t.tree + ")";
    }
    text += "      b being the coefficients of the modified equation, " + combination + " = " +
            (source.digits() > 0 || !p.residual_value.is_constant()
                 ? (p.residual_value.is_constant() ? std::string()
                                                   : print(source.formula(p.residual_value), style) + " = ") +
                       source.decimal(p.residual_value, 10) + " (rounded)"
                 : print(source.formula(p.residual_value), style)) +
            " with every launch" +
            (p.force.empty() ? " that makes" : " and force of the position that make") + " it of order " +
            std::to_string(p.obstructed_at - 1) + "; it would have to be 0\n";
  }
  for (const std::string& note : p.notes) text += "    " + note + "\n";
  return text;
}

}  // namespace shortfall
