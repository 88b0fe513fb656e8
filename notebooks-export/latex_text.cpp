// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/latex_text.hpp"

#include "analysis/program/print.hpp"
#include "notebooks-export/notebook_document.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall {

namespace {

/// left = right on lines of its own, broken at its terms where it is long.
std::string display(const Expr& left, const Expr& right) {
  std::string text = displayed(left, right);  // $$ ... $$, which is no LaTeX of today
  text.replace(0, 2, "\\[");
  text.replace(text.size() - 2, 2, "\\]");
  return text + "\n";
}

std::string force_latex(const Derivation& d) {
  return d.degree == 0 ? "a constant acceleration $a$"
                       : "the acceleration $f_0 + f_1 t + \\dots$ of degree " + std::to_string(d.degree);
}

std::string option_text(const CorrectionOption& o) {
  std::string text = "\n\\paragraph{" + latex_escaped(o.name) + "} ";
  if (!o.exists) return text + "Does not exist: " + latex_escaped(sentence(o.obstruction)) + "\n";
  text += "Exact for every $n$.\n";
  for (const Correction& c : o.corrections)
    text += "\n\\noindent " + std::string(kind_name(c.kind)) + ", to be added to $" +
            print(name(c.target), Style::latex) + "$ (" + latex_escaped(c.reason) + "):\n" + "\\[ " +
            print(c.add, Style::latex) + " \\]\n";
  return text;
}

/// A row for each thing to add; a formula that no column holds stands in its paragraph only.
std::string overview(const CorrectionKit& kit) {
  std::string text =
      "\n\\begin{center}\n\\begin{tabular}{llll}\n\\toprule\ncorrection & kind & added to & what is added "
      "\\\\\n\\midrule\n";
  for (const CorrectionOption& o : kit.options) {
    if (!o.exists) {
      text += latex_escaped(o.name) + " & \\multicolumn{3}{l}{does not exist} \\\\\n";
      continue;
    }
    for (const Correction& c : o.corrections)
      text += (&c == &o.corrections.front() ? latex_escaped(o.name) : "") + " & " + kind_name(c.kind) +
              " & $" + print(name(c.target), Style::latex) + "$ & " +
              (is_long(c.add) ? "see below" : "$" + print(c.add, Style::latex) + "$") + " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\end{center}\n";
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        result += '\\';
        result += c;
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '\\':
        result += "\\textbackslash{}";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
  return result;
}

std::string as_latex(const Derivation& d, const CorrectionKit* kit) {
  std::string text = "% " + d.integrator + ", force of degree " + std::to_string(d.degree) +
                     " in t. Needs amsmath" + (kit && kit->needed ? " and booktabs" : "") +
                     ". Written by shortfall; what it prints is yours.\n";
  text += "The shortfall, exact minus computed, of " + latex_escaped(d.integrator) + " under " +
          force_latex(d) + " after $n$ steps of length $h$, at $t = n h$, and its derivation" +
          (d.proved() ? ", each line of which was proved" : "") + ":\n";
  text += display(name("x(t)") - name("x_n"), d.shortfall_position);
  text += display(name("v(t)") - name("v_n"), d.shortfall_velocity);
  int count = 0;
  for (const DerivationStep& s : d.steps)
    text += "\n\\noindent(" + std::to_string(++count) + ") " + latex_escaped(sentence(s.why)) + "\n" +
            display(s.left, s.right);
  if (!kit) return text;
  if (!kit->needed) return text + "\nNothing to correct: position and velocity are exact.\n";
  text += overview(*kit);
  for (const CorrectionOption& o : kit->options) text += option_text(o);
  return text;
}

}  // namespace shortfall
