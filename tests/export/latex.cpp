// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/latex_text.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;
namespace fs = std::filesystem;

TEST_CASE("text for LaTeX is set as it stands") {
  CHECK(latex_escaped("f_0 & 50% of {a} ~ \\b ^ $ #\n") ==
        "f\\_0 \\& 50\\% of \\{a\\} \\textasciitilde{} \\textbackslash{}b \\textasciicircum{} \\$ \\#");
}

TEST_CASE("the derivations of the whole catalogue compile as LaTeX, in one document") {
  if (std::system("command -v pdflatex >/dev/null 2>&1") != 0) {
    MESSAGE("skipped: pdflatex is not installed");
    return;
  }
  std::string document = "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n";
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
  std::string folder = (fs::temp_directory_path() / "shortfall-latex-XXXXXX").string();
  REQUIRE(mkdtemp(folder.data()) != nullptr);
  std::ofstream(folder + "/all.tex") << document << "\\end{document}\n";
  const int status = std::system(
      ("cd '" + folder + "' && pdflatex -interaction=nonstopmode -halt-on-error all.tex >out 2>&1 </dev/null")
          .c_str());
  if (status != 0) {
    std::ifstream log(folder + "/out");
    const std::string text{std::istreambuf_iterator<char>(log), {}};
    MESSAGE(text.substr(text.size() > 1500 ? text.size() - 1500 : 0));
  }
  CHECK(status == 0);
  CHECK(fs::exists(folder + "/all.pdf"));
  fs::remove_all(folder);
}
