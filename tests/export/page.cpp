// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/page.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "notebooks-export/page_document.hpp"
#include "tests/cli/command.hpp"
#include "tests/export/languages.hpp"

using namespace shortfall;

namespace {

std::string page_of(const Program& program, int degree) {
  const Derivation d = derivation(program, degree);
  return page(program, d, correction_kit(d), {{"C++", "if (a < b && c > d) return \"</script>\";"}},
              explorer_motion(d, correction_kit(d)), "shortfall export");
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("a page fetches nothing and is the same bytes twice") {
  const Program program = find_integrator("symplectic-euler");
  const std::string text = page_of(program, 0);
  CHECK(text == page_of(program, 0));
  for (const char* outside : {"src=\"http", "href=\"http", "url(http", "url(fonts", "@import", "import("}) {
    CAPTURE(outside);
    CHECK(text.find(outside) == std::string::npos);
  }
  CHECK(text.find("data-tex=\"x(t) - x_n = -\\frac{1}{2} \\, a \\, h \\, t\"") != std::string::npos);
  CHECK(text.find("proved at 5 values of n") != std::string::npos);
  CHECK(text.find("not proved") == std::string::npos);
}

TEST_CASE("what users wrote cannot leave its place in a page") {
  const Program program = parse(
      "# <script>alert(1)</script> & \"quotes\" 'single' `back`\nintegrator evil\nstep\n"
      "  v = v + h*a(x, v, t)\n  x = x + h*v\n",
      "evil.integrator");
  const std::string text = page_of(program, 0);
  CHECK(text.find("<script>alert") == std::string::npos);
  CHECK(text.find("&lt;/script&gt;") != std::string::npos);  // of the code in the tab
  // As many scripts begin as end.
  CHECK(count(text, "<script>") == count(text, "</script>"));
}

TEST_CASE("an exact integrator's page says so, and offers nothing to correct") {
  const std::string text = page_of(find_integrator("velocity-verlet"), 0);
  CHECK(text.find("is exact at every frame") != std::string::npos);
  CHECK(text.find("Corrections, and where") == std::string::npos);
}

TEST_CASE("the figure to explore computes what the integrator does, for the whole catalogue") {
  if (!installed("node")) return;
  const Folder folder;
  std::string script = "\"use strict\";\n";
  std::vector<std::string> what;
  std::vector<double> expected, exact;
  std::vector<bool> correctable;
  const Rational x0(1, 3), v0(14, 5), f0(-49, 5), f1(3, 2), h(1, 16);
  constexpr int kFrame = 9;
  for (const Program& program : catalogue())
    for (const int degree : {0, 1}) {
      std::string motion;
      try {
        const Derivation d = derivation(program, degree, parameter_values(program, {}), 1, false);
        motion = explorer_motion(d, correction_kit(d));
        if (d.form.valid_from > kFrame) continue;
        const Rational slope = degree == 0 ? Rational(0) : f1;
        Numbers<Rational> problem{
            [&](const Rational&, const Rational&, const Rational& t) { return f0 + slope * t; }};
        const Tape tape = lower(undisturbed(program), parameter_values(program, {}));
        Run<Numbers<Rational>> run(tape, problem, h);
        run.begin(x0, v0, Rational(0));
        for (int n = 0; n < kFrame; ++n) run.step();
        expected.push_back(run.read_out().first.to_double());
      } catch (const Unable&) {
        continue;  // irrational stages: not for this way of checking
      } catch (const Undefined&) {
        continue;
      }
      const Rational t = h * Rational(kFrame);
      exact.push_back(
          (x0 + v0 * t + f0 * t * t / Rational(2) + (degree ? f1 * t * t * t / Rational(6) : Rational(0)))
              .to_double());
      correctable.push_back(motion.find("correctable: true") != std::string::npos);
      what.push_back(program.name + " under a force of degree " + std::to_string(degree));
      script += "{\n" + motion +
                "  const at = { x0: 1 / 3, v0: 2.8, a: -9.8, f0: -9.8, f1: 1.5, h: 1 / 16 };\n"
                "  const t = 9 / 16, n = 9;\n  console.log(motion.position(at, t, n), motion.exact(at, t), "
                "motion.position(motion.launched(at), t, n) + motion.readout(at, t, n, "
                "motion.velocity(motion.launched(at), t, n)));\n}\n";
    }
  folder.write("motions.js", script);
  REQUIRE(std::system(("node '" + folder.path("motions.js") + "' >'" + folder.path("out") + "'").c_str()) ==
          0);
  std::istringstream out(folder.text("out"));
  for (std::size_t i = 0; i < what.size(); ++i) {
    CAPTURE(what[i]);
    double position = 0, truth = 0, corrected = 0;
    const bool complete = static_cast<bool>(out >> position >> truth >> corrected);
    REQUIRE(complete);
    CHECK(position == doctest::Approx(expected[i]).epsilon(1e-10));  // 1/c^2 cancels
    CHECK(truth == doctest::Approx(exact[i]).epsilon(1e-12));
    if (correctable[i]) CHECK(corrected == doctest::Approx(truth).epsilon(1e-12));
  }
  CHECK(what.size() > 60);
}

TEST_CASE(
    "a browser shows the page: formulas set, figure drawn, tabs and colours switch, nothing complains") {
  if (!installed("chromium")) return;
  if (katex_folder().empty()) {
    MESSAGE("skipped: KaTeX is not installed");
    return;
  }
  const Folder folder;
  // What a person would do, and what came of it.
  const std::string probe = R"(<script>
    const say = (id, text) => { const e = document.createElement("p"); e.id = id; e.textContent = text; document.body.append(e); };
    say("formulas", `${document.querySelectorAll("[data-tex]").length} ${document.querySelectorAll("[data-tex] .katex").length}`);
    say("curves", document.querySelectorAll("#arcs path").length);
    const before = document.getElementById("said").textContent;
    const rate = document.getElementById("letter-rate");
    rate.value = 25; rate.dispatchEvent(new Event("input", { bubbles: true }));
    say("changed", String(before !== document.getElementById("said").textContent));
    const tabs = [...document.querySelectorAll("[role=tab]")];
    tabs[1].click();
    say("tabs", tabs.map((t) => document.getElementById(t.getAttribute("aria-controls")).hidden).join(" "));
    tabs[1].dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
    say("keys", String(document.activeElement === tabs[0]));
    document.getElementById("theme").click();
    say("colours", document.documentElement.dataset.theme);
  </script></body>)";
  const Program program = find_integrator("symplectic-euler");
  const Derivation d = derivation(program, 0);
  std::string text = page(program, d, correction_kit(d), {{"C++", "int a;"}, {"Rust", "let a;"}},
                          explorer_motion(d, correction_kit(d)), "shortfall export");
  const std::size_t end = text.rfind("</body>");
  REQUIRE(end != std::string::npos);
  text.replace(end, 7, probe);
  folder.write("page.html", text);
  const std::string command =
      "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking "
      "--disable-component-update --disable-sync --user-data-dir='" +
      folder.path("profile") + "' --virtual-time-budget=5000 --enable-logging=stderr --dump-dom 'file://" +
      folder.path("page.html") + "' >'" + folder.path("dom") + "' 2>'" + folder.path("log") + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string dom = folder.text("dom"), log = folder.text("log");
  const auto said = [&](const std::string& id) {
    const std::string open = "<p id=\"" + id + "\">";
    const std::size_t at = dom.find(open);
    if (at == std::string::npos) return std::string("nothing");
    return dom.substr(at + open.size(), dom.find("</p>", at) - at - open.size());
  };
  std::istringstream formulas(said("formulas"));
  int wanted = 0, set = 0;
  formulas >> wanted >> set;
  CHECK(wanted > 20);
  CHECK(set == wanted);
  CHECK(said("curves") == "3");
  CHECK(said("changed") == "true");
  CHECK(said("tabs") == "true false");
  CHECK(said("keys") == "true");
  CHECK(said("colours") == "dark");
  CHECK(log.find("CONSOLE") == std::string::npos);
  if (log.find("CONSOLE") != std::string::npos) MESSAGE(log);
}
