// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "cli/command.hpp"
#include "cli/export_lesson.hpp"
#include "cli/force.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "cli/output_folder.hpp"
#include "notebooks-export/code.hpp"
#include "notebooks-export/code_kit.hpp"
#include "notebooks-export/figure_gnuplot.hpp"
#include "notebooks-export/figure_jump.hpp"
#include "notebooks-export/latex_text.hpp"
#include "notebooks-export/notebook.hpp"
#include "notebooks-export/page.hpp"
#include "notebooks-export/page_document.hpp"

namespace shortfall::cli {

namespace {

/// What is wanted.
struct Wanted {
  bool notebook = false;
  bool html = false;
  std::string code;  ///< languages with commas between, or "all"
  bool overwrite = false;
};

std::vector<Language> languages(const std::string& words) {
  std::vector<Language> list;
  std::istringstream stream(words == "all" ? fmt::format("{}", fmt::join(language_names(), ",")) : words);
  for (std::string word; std::getline(stream, word, ',');) {
    list.push_back(language_of(word, "--code", ", or all"));
  }
  return list;
}

/// The corrected jump where the force is constant, the kit's functions otherwise; nothing where there is
/// nothing to write.
std::optional<std::string> source(const Question& q, const Derivation& d, const CorrectionKit& kit,
                                  Language language) {
  try {
    if (d.degree == 0)
      return jump_code(Flight(q.program(), q.step(), q.substeps(), q.values()), q.gravity(), language);
    return kit_code(kit, d, language);
  } catch (const Undefined&) {
    return std::nullopt;
  } catch (const Unable&) {
    return std::nullopt;
  }
}

/// The motion at the values that its letters have, which the page can draw; nothing where a formula cannot be
/// evaluated there.
std::string figure(const Program& program, const Values& given, const Derivation& d) {
  try {
    const Derivation at = derivation(program, d.degree, parameter_values(program, given), d.substeps, false);
    return explorer_motion(at, correction_kit(at));
  } catch (const Unable&) {
    return {};
  } catch (const Undefined&) {
    return {};
  }
}

/// The jump that the notebook is about, drawn; nothing where there is none, or no gnuplot.
std::string jump_picture(const Question& q, const Derivation& d) {
  if (d.degree > 0) return {};
  if (!gnuplot_is_here()) return {};  // the cell draws it when it is run
  try {
    std::vector<Flight> flights;
    flights.emplace_back(q.program(), Rational(1, 50), q.substeps(), q.values());
    return image(jump_figure(flights, Rational(2, 5), Rational(981, 100)), ImageFormat::png);
  } catch (const Undefined&) {
    return {};
  } catch (const Unable&) {
    return {};
  } catch (const ProgramError& e) {
    throw OutputError(e.what());
  }
}

std::string command_line(const Question& q, const Derivation& d) {
  std::string text = "shortfall export " + word_for(q.program()) + " --force " +
                     (d.degree == 0 ? "constant" : "poly:" + std::to_string(d.degree));
  if (q.substep_count) text += " --substeps " + std::to_string(*q.substep_count);
  for (const std::string& p : q.parameters) text += " --param " + p;
  return text + " --html";
}

int export_derivation(const Question& q, const Wanted& wanted) {
  const int kinds = wanted.notebook + wanted.html + q.latex;
  if (kinds == 0 && wanted.code.empty())
    throw BadInput("export takes --notebook, --html, --latex, --code LANGUAGES: say what to write");
  const bool folder = kinds > 1 || !wanted.code.empty() || q.output.ends_with('/');
  if (folder && (q.output.empty() || q.output == "-"))
    throw BadInput("several files go into a folder: say which with -o FOLDER");
  const std::vector<Language> asked = wanted.code.empty() ? std::vector<Language>() : languages(wanted.code);
  const int degree = force_degree(q.force);
  if (degree > kHighestNotebookDegree)
    throw Unable("derivations are written out for forces of degree up to " +
                 std::to_string(kHighestNotebookDegree) + ", not " + std::to_string(degree) +
                 "; derive goes up to degree 200");
  const Program program = q.program();
  const Values values = q.values();
  if (program.solves && with_own_equation(force_named(q.force), program, values).linear())
    throw Unable(program.name + " solves x'' = " + print(program.solves, Style::language) +
                 ", which is no force polynomial in time: derive and correct answer for it; export writes "
                 "what such a force has, as with its damping set to 0 by --param");
  const Derivation d = derivation(program, degree, values, q.substeps());
  const CorrectionKit kit = correction_kit(d);
  const std::string name = file_name(program.name);

  std::map<std::string, std::string> files;
  if (wanted.notebook) files[name + ".ipynb"] = notebook(program, values, d, kit, jump_picture(q, d));
  if (q.latex) files[name + ".tex"] = as_latex(d, &kit);
  std::vector<std::pair<std::string, std::string>> shown;
  for (const Language language : wanted.html&& asked.empty() ? languages("all") : asked)
    if (auto text = source(q, d, kit, language)) {
      shown.emplace_back(title(language), *text);
      // Functions to be pasted become a header where they are a file.
      if (language == Language::cpp && text->find("#pragma once") == std::string::npos)
        text->insert(0, "#pragma once\n\n");
      if (!asked.empty()) files["code/" + name + file_ending(language)] = std::move(*text);
    }
  if (!asked.empty() && shown.empty())
    say("shortfall: no code is written: " +
        (kit.needed ? "there is no correction that these languages could hold"
                    : d.integrator + " is exact for this force, there is nothing to correct"));
  if (wanted.html) {
    files[name + ".html"] = page(program, d, kit, shown, figure(program, values, d), command_line(q, d));
    if (katex_folder().empty())
      say("shortfall: KaTeX was not found, so that the page shows formulas as LaTeX; Debian's package is "
          "libjs-katex");
  }
  if (folder) {
    write_folder(files, q.output, wanted.overwrite);
    for (const auto& [file, text] : files)
      say("shortfall: wrote " + q.output + (q.output.ends_with('/') ? "" : "/") + file);
  } else {
    write_output(files.begin()->second, q.output);
  }
  return d.proved() ? kDone : kBug;
}

}  // namespace

void add_export(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Start here", "export",
                  "A derivation to keep: a notebook that asserts its own claims, a page, LaTeX, code; "
                  "lessons for a class.",
                  {"export symplectic-euler --force constant --notebook -o falling-short.ipynb",
                   "export symplectic-euler --force constant --notebook --html --latex --code all -o out/",
                   "export newmark --force poly:2 --param beta=1/6 --html -o newmark.html",
                   "export my-own.integrator --force poly:1 --latex -o my-own.tex",
                   "export lesson:falling-short --exercise -o lesson/"});
  auto q = std::make_shared<Question>();
  auto wanted = std::make_shared<Wanted>();
  add_integrator(*command, *q);
  add_force(*command, *q);
  add_parameters(*command, *q);
  command->add_flag("--notebook", wanted->notebook,
                    "a Jupyter notebook; its cells need Python 3 and nothing else");
  command->add_flag("--html", wanted->html,
                    "a page that needs nothing beside itself, with a figure to explore");
  command->add_flag("--latex", q->latex, "LaTeX (amsmath, booktabs)");
  command
      ->add_option("--code", wanted->code,
                   "the correction in csharp, cpp, gdscript, python, rust, javascript, or all, into a folder")
      ->type_name("L,L");
  command->add_flag("--overwrite", wanted->overwrite,
                    "write into a folder that is not empty, over a lesson that is there");
  add_output(*command, *q);
  const auto lesson = add_lesson_options(*command);
  command->callback([q, wanted, lesson, &code] {
    lesson->overwrite = wanted->overwrite;
    code = is_lesson(q->integrator, *lesson) ? export_lesson(q->integrator, q->output, *lesson)
                                             : export_derivation(*q, *wanted);
  });
}

}  // namespace shortfall::cli
