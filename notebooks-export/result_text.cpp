// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/result_text.hpp"

#include <algorithm>

#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

std::string force_with_letters(const Derivation& d, Style style) {
  if (d.degree == 0) return "constant acceleration a";
  Expr f = name("f0");
  for (int k = 1; k <= std::min(d.degree, 3); ++k)
    f = f + name("f" + std::to_string(k)) * power(name("t"), k);
  std::string text = print(f, style);
  if (d.degree > 3)
    text += " + ... + " + print(name("f" + std::to_string(d.degree)) * power(name("t"), d.degree), style);
  return "force f(t) = " + text + " (acceleration)";
}

std::string shown(const Expr& e, Style style) {
  std::string text = print(e, style);
  // A terminal is not the place for a page of digits; --json and --latex have all of it.
  if (style != Style::latex && static_cast<int>(text.size()) > kLongestFormula)
    return "a formula of " + std::to_string(text.size()) + " characters (--json or --latex shows it)";
  return text;
}

void append_steps(std::string& text, const Derivation& d, Style style) {
  std::size_t width = 0;
  std::string last;
  for (const DerivationStep& s : d.steps) width = std::max(width, width_of(print(s.left, style)));
  for (const DerivationStep& s : d.steps) {
    const std::string left = print(s.left, style);
    if (!last.empty() && left != last) text += "\n";
    const std::size_t taken = width_of(left);
    text += "  " + (left == last ? std::string(taken, ' ') : left) + std::string(width - taken, ' ') + " = " +
            shown(s.right, style) + "\n";
    text += "  " + std::string(width, ' ') + "   " + (style == Style::unicode ? "↑ " : "^ ") + s.why +
            (s.proved ? "" : "  [NOT PROVED]") + "\n";
    last = left;
  }
}

void append_corrections(std::string& text, const CorrectionOption& o, Style style) {
  for (const Correction& c : o.corrections)
    text += "    " + std::string(kind_name(c.kind)) + ": " + c.target + " += " + shown(c.add, style) +
            (c.series != print(c.add) ? "   (" + c.series + ")" : "") + "\n        " + c.reason + "\n";
}

std::string letters_note(const Derivation& d) {
  std::string text = d.substeps > 1 ? "h is the frame; it is stepped in " + std::to_string(d.substeps) +
                                          " substeps of h/" + std::to_string(d.substeps) + ". "
                                    : "";
  return text + "n steps, t = n h. Shortfall = exact - computed: positive means too low. " +
         exactness(d.digits) + "\n";
}

}  // namespace

std::string force_words(const Derivation& d) {
  return d.degree == 0 ? "a constant acceleration"
                       : "an acceleration that is a polynomial in time of degree " + std::to_string(d.degree);
}

std::string exactness(int digits) {
  return digits == 0 ? "All formulas are exact."
                     : "All formulas are exact for the decimals as printed: about the method itself they "
                       "hold to about " +
                           std::to_string(digits) + " digits.";
}

std::string line(const std::string& left, const Expr& right, Style style) {
  return left + " = " + shown(right, style);
}

std::string sentence(const RandomCheck& check) {
  const bool exact = check.digits == 0;
  return std::to_string(check.trials) + " random cases stepped " +
         (exact ? "in rational numbers" : "with 80 digits") + " for " + std::to_string(check.steps) +
         " steps: " +
         (!check.agrees ? "DIFFERENT"
          : exact       ? "equal"
                        : "equal to " + std::to_string(check.digits) + " digits") +
         ".";
}

std::string from_words(const Derivation& d) {
  return d.form.valid_from > 0 ? " >= " + std::to_string(d.form.valid_from) : "";
}

std::string as_text(const CorrectionKit& kit, const Derivation& d, Style style) {
  if (!kit.needed)
    return "Nothing to correct: position and velocity are exact for this force at every step.\n";
  std::string text;
  const std::string exact = "exact for every n" + from_words(d);
  for (const CorrectionOption& o : kit.options) {
    text += "  " + o.name + ": " + (o.exists ? exact : "does not exist") + "\n";
    if (o.exists)
      append_corrections(text, o, style);
    else
      text += "    " + o.obstruction + "\n";
    text += "    proof: " + o.proof + "\n";
  }
  if (d.degree > 0)
    text +=
        "  (f' is the derivative of the force by time; launches take it at t = 0, read-outs at t = n h, "
        "terms at the beginning of the step)\n";
  return text;
}

std::string as_text(const Derivation& d, const CorrectionKit* kit, Style style) {
  std::string text = d.integrator + ", " + force_with_letters(d, style) + "\n" + letters_note(d) + "\n";
  text += "  " + line("position  x_n      ", d.position, style) + "\n";
  text += "  " + line("velocity  v_n      ", d.velocity, style) + "\n";
  text += "  " + line("shortfall x(t)-x_n ", d.shortfall_position, style) + "\n";
  text += "  " + line("shortfall v(t)-v_n ", d.shortfall_velocity, style) + "\n";
  if (!d.steps.empty()) {
    text += "\nDerivation\n";
    append_steps(text, d, style);
  }
  if (kit) text += "\nCorrections (what to add)\n" + as_text(*kit, d, style);
  text += "\nProof\n";
  if (d.proof.proved)
    text +=
        "  Both sides of each line satisfy one linear recurrence in n, and agree, with all letters symbolic, "
        "at as many consecutive n\n"
        "  as its order: " +
        std::to_string(d.proof.points) + " for the result" +
        (d.steps.empty() ? "" : ", " + std::to_string(d.steps.front().points) + " for each line") +
        ". Hence they agree for every n.\n";
  else
    text += "  NOT PROVED: the closed form differs from stepping. This is a bug of ours; please report it.\n";
  text += "  Checked besides: " + sentence(d.check) + "\n";
  text += "Assumed: ";
  for (std::size_t i = 0; i < d.assumptions.size(); ++i) text += (i ? "; " : "") + d.assumptions[i];
  return text + ".\n";
}

}  // namespace shortfall
