// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/page.hpp"

#include "analysis/program/print.hpp"
#include "notebooks-export/notebook_document.hpp"
#include "notebooks-export/page_document.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall {

namespace {

std::string tex(const Expr& e) { return print(e, Style::latex); }
std::string equation(const std::string& left, const Expr& right) { return left + " = " + tex(right); }

std::string where_words(const Correction& c) {
  switch (c.kind) {
    case Correction::Kind::launch:
      return "added once, before the first step, to ";
    case Correction::Kind::read_out:
      return "added to what is shown, while the integrator goes on with its own, to ";
    case Correction::Kind::force:
      return "added in every step to the acceleration ";
    case Correction::Kind::term:
      return "added at the end of every step to ";
  }
  return {};
}

std::string correction_list(const CorrectionOption& o) {
  std::string text = "<ul>\n";
  for (const Correction& c : o.corrections)
    text += "<li>" + inline_formula(tex(c.add)) + " " + where_words(c) + inline_formula(tex(name(c.target))) +
            "</li>\n";
  return text + "</ul>";
}

void tell_answer(PageDocument& page, const Derivation& d, const CorrectionKit& kit) {
  std::string text = "<div class=\"answer\">\n<p>Under " + html_escaped(force_words(d)) + " <strong>" +
                     html_escaped(d.integrator) + "</strong>";
  if (!kit.needed) {
    page.html(text +
              " is exact at every frame: position and velocity are those of the true motion. There is "
              "nothing to correct.</p>\n</div>");
    return;
  }
  text += " falls short of the true motion, after n steps of length h, at time t = n h, by</p>\n";
  page.html(text);
  page.formula(equation("x(t) - x_n", d.shortfall_position));
  page.formula(equation("v(t) - v_n", d.shortfall_velocity));
  if (const CorrectionOption* best = kit.best())
    page.html("<p>Positive: what is computed is too low. This repairs it, exactly, at every frame:</p>\n" +
              correction_list(*best));
  else
    page.html("<p>Positive: what is computed is too low. No correction of the kinds tried repairs it: " +
              html_escaped(kit.options.empty() ? std::string() : kit.options.front().obstruction) + ".</p>");
  page.html("</div>");
}

void tell_derivation(PageDocument& page, const Derivation& d) {
  page.section("Why: the derivation, line by line");
  page.paragraph(
      "One step is written out, the steps are added up, and the sum that is left is one that Gauss and "
      "Faulhaber knew. Each line was "
      "proved by the program that wrote this page: both sides were compared, exactly and with every letter "
      "symbolic, at as many n "
      "as determine them.");
  std::string list = "<ol class=\"steps\">\n";
  for (const DerivationStep& s : d.steps) {
    const std::string latex = tex(s.left) + " = " + tex(s.right);
    list += "<li><p class=\"why\">" + html_escaped(sentence(s.why)) + " " +
            (s.proved ? "<span class=\"proved\">proved at " + std::to_string(s.points) +
                            (s.points == 1 ? " value" : " values") + " of n</span>"
                      : std::string("<span class=\"not\">not proved</span>")) +
            "</p><div class=\"formula\" tabindex=\"0\" data-tex=\"" + html_escaped(latex) + "\">" +
            html_escaped(latex) + "</div></li>\n";
  }
  page.html(list + "</ol>");
  if (d.form.valid_from > 0)
    page.paragraph("The closed form holds from n = " + std::to_string(d.form.valid_from) +
                   " on; before, the start of the integrator is still felt.");
}

void tell_corrections(PageDocument& page, const Derivation& d, const CorrectionKit& kit) {
  if (!kit.needed) return;
  page.section("Corrections, and where there are none");
  for (const CorrectionOption& o : kit.options) {
    page.html("<h3>" + html_escaped(o.name) + "</h3>");
    if (o.exists)
      page.html("<p><span class=\"proved\">Exact for every n" + html_escaped(from_words(d)) +
                ".</span></p>\n" + correction_list(o));
    else
      page.html("<p><span class=\"not\">Does not exist:</span> " + html_escaped(sentence(o.obstruction)) +
                "</p>");
    if (!o.proof.empty())
      page.html("<details><summary>How it is known</summary><p>" + html_escaped(sentence(o.proof)) +
                "</p></details>");
  }
}

void tell_program(PageDocument& page, const Program& program) {
  page.section("The integrator");
  if (!program.description.empty()) page.paragraph(sentence(program.description));
  page.code(print(program));
  if (program.sources.empty()) return;
  std::string list = "<p>Published by</p>\n<ul>\n";
  for (const std::string& s : program.sources) list += "<li>" + html_escaped(s) + "</li>\n";
  page.html(list + "</ul>");
}

}  // namespace

std::string page(const Program& program, const Derivation& d, const CorrectionKit& kit,
                 const std::vector<std::pair<std::string, std::string>>& sources, const std::string& motion,
                 const std::string& command) {
  PageDocument page(
      "The shortfall of " + d.integrator,
      "What " + d.integrator + " does under " + force_words(d) + ", exactly, and what repairs it");
  tell_answer(page, d, kit);
  if (!motion.empty()) {
    page.section("Try it");
    page.html(explorer_markup(d, motion.find("correctable: true") != std::string::npos));
    page.script(motion + page_text("explorer.js"));
  }
  page.section("The closed form");
  page.paragraph("What the integrator reads out after n steps:");
  page.formula(equation("x_n", d.position));
  page.formula(equation("v_n", d.velocity));
  page.paragraph("And the true motion at the same time:");
  page.formula(equation("x(t)", d.exact_position));
  page.formula(equation("v(t)", d.exact_velocity));
  tell_derivation(page, d);
  tell_corrections(page, d, kit);
  if (!sources.empty()) {
    page.section("Code");
    page.tabs("Programming languages", sources);
  }
  tell_program(page, program);
  page.html("<footer><p>" +
            html_escaped(sentence(
                d.check.agrees ? sentence(d.check)
                               : std::string("the closed form was proved; no random check was made"))) +
            " Written by shortfall:</p>");
  page.code(command);
  page.html("</footer>");
  return page.text();
}

}  // namespace shortfall
