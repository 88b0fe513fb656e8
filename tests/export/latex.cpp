// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/latex_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/cli/command.hpp"

using namespace shortfall;

TEST_CASE("text for LaTeX is set as it stands") {
  CHECK(latex_escaped("f_0 & 50% of {a} ~ \\b ^ $ #\n") ==
        "f\\_0 \\& 50\\% of \\{a\\} \\textasciitilde{} \\textbackslash{}b \\textasciicircum{} \\$ \\#");
}

TEST_CASE("the derivations of the whole catalogue compile as LaTeX, in one document" *
          doctest::test_suite("thorough")) {
  if (std::system("command -v pdflatex >/dev/null 2>&1") != 0) {
    MESSAGE("skipped: pdflatex is not installed");
    return;
  }
  std::string document =
      "\\documentclass{article}\n\\usepackage{amsmath}\n"
      // Where booktabs is not installed, its rules are plain lines.
      "\\IfFileExists{booktabs.sty}{\\usepackage{booktabs}}"
      "{\\let\\toprule\\hline\\let\\midrule\\hline\\let\\bottomrule\\hline}\n\\begin{document}\n";
  int count = 0;
  for (const Program& program : catalogue())
    for (const int degree : {0, 1, 3}) try {
        const Derivation d = derivation(program, degree);
        const CorrectionKit kit = correction_kit(d);
        document += "\\section{" + latex_escaped(program.name) + "}\n" + as_latex(d, &kit) + "\n";
        ++count;
      } catch (const Unable&) {
        continue;
      } catch (const Undefined&) {
        continue;
      }
  CHECK(count > 100);
  CHECK(document.find("launch & launch & $v_{0}$ & $-\\frac{1}{2} \\, a \\, h$ \\\\\n") != std::string::npos);
  const Folder folder;
  folder.write("all.tex", document + "\\end{document}\n");
  const int status =
      std::system(("cd '" + folder.path(".") +
                   "' && pdflatex -interaction=nonstopmode -halt-on-error all.tex >out 2>&1 </dev/null")
                      .c_str());
  const std::string log = folder.text("out");
  if (status != 0) MESSAGE(log.substr(log.size() > 1500 ? log.size() - 1500 : 0));
  CHECK(status == 0);
  CHECK(folder.has("all.pdf"));
}
