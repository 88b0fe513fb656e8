// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "cli/command.hpp"
#include "cli/export_lesson.hpp"
#include "cli/force.hpp"
#include "cli/output.hpp"
#include "notebooks-export/notebook.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall::cli {

namespace {

int export_derivation(const Question& q, bool as_notebook) {
  if (as_notebook == q.latex) throw BadInput("export takes one of --notebook and --latex: say what to write");
  const int degree = force_degree(q.force);
  if (degree > kHighestNotebookDegree)
    throw Unable("derivations are written out for forces of degree up to " +
                 std::to_string(kHighestNotebookDegree) + ", not " + std::to_string(degree) +
                 "; derive goes up to degree 200");
  const Program program = q.program();
  const Values values = q.values();
  const Derivation d = derivation(program, degree, values, q.substeps());
  const CorrectionKit kit = correction_kit(d);
  write_output(as_notebook ? notebook(program, values, d, kit) : as_latex(d, &kit), q.output);
  return d.proved() ? kDone : kBug;
}

}  // namespace

void add_export(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Start here", "export",
      "A derivation to keep: a notebook that asserts its own claims, or LaTeX; lessons for a class.",
      {"export symplectic-euler --force constant --notebook -o falling-short.ipynb",
       "export newmark --force poly:2 --param beta=1/6 --notebook -o newmark.ipynb",
       "export my-own.integrator --force poly:1 --latex -o my-own.tex",
       "export lesson:falling-short --exercise -o lesson/"});
  auto q = std::make_shared<Question>();
  auto as_notebook = std::make_shared<bool>(false);
  add_integrator(*command, *q);
  add_force(*command, *q);
  add_parameters(*command, *q);
  command->add_flag("--notebook", *as_notebook,
                    "a Jupyter notebook; its cells need Python 3 and nothing else");
  command->add_flag("--latex", q->latex, "LaTeX (amsmath)");
  add_output(*command, *q);
  const auto lesson = add_lesson_options(*command);
  command->callback([q, as_notebook, lesson, &code] {
    code = is_lesson(q->integrator, *lesson) ? export_lesson(q->integrator, q->output, *lesson)
                                             : export_derivation(*q, *as_notebook);
  });
}

}  // namespace shortfall::cli
