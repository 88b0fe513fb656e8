// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/lesson.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "notebooks-export/lesson_value.hpp"
#include "tests/export/python_run.hpp"

namespace shortfall {
namespace {

ShellRun script(const std::string& python, const std::string& name, const std::string& arguments) {
  return shell_run("'" + python + "' '" SHORTFALL_SOURCE_DIR "/tests/export/" + name + "' " + arguments);
}

/// Writes a file; its name as a shell takes it.
std::string written(const ScratchFolder& folder, const std::string& name, const std::string& text) {
  folder.write(name, text);
  return quoted(folder, name);
}

std::string shortfall(const std::string& arguments) { return "'" SHORTFALL_BINARY "' " + arguments; }

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A lesson of one code cell.
Lesson small(const std::string& cell) {
  return parse_lesson("lesson small\ntitle Small\nabout A small one.\n\n%% code\n" + cell + "\n",
                      "small.lesson");
}

TEST_CASE("there are six lessons, of 20 to 40 minutes, in the order of the course") {
  REQUIRE(lessons().size() == 6);
  const std::vector<std::string> names{"falling-short", "gauss-faulhaber",   "three-eulers",
                                       "floats",        "modified-equation", "nine-engines"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Lesson& lesson = lessons()[i];
    CHECK(lesson.name == names[i]);
    CHECK(lesson.place == static_cast<int>(i) + 1);
    CHECK(lesson.minutes >= 20);
    CHECK(lesson.minutes <= 40);
    const std::string last = lesson.cells.back().source;
    CHECK(last.find("## Sources and further reading") != std::string::npos);
  }
}

TEST_CASE("every lesson runs, and its assertions hold, in Jupyter as well") {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: lessons are written, but not run");
    return;
  }
  const ScratchFolder folder;
  std::string files;
  for (const Lesson& lesson : lessons())
    files += " " + written(folder, lesson.name + ".ipynb", notebook(lesson, LessonFor::teacher));
  const ShellRun plain = script(interpreter, "run_notebook.py", files);
  INFO(plain.output);
  CHECK(plain.code == 0);
  const ShellRun jupyter = script(interpreter, "run_notebook.py", "--jupyter" + files);
  INFO(jupyter.output);
  if (jupyter.code == 77)
    MESSAGE("nbformat, nbconvert and ipykernel are not installed: lessons were not run in Jupyter");
  else
    CHECK(jupyter.code == 0);
}

TEST_CASE("the pupil's copy holds no answer, and its checks fail until there is one") {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: not run");
    return;
  }
  const ScratchFolder folder;
  for (const Lesson& lesson : lessons()) {
    const std::string teacher = written(folder, "teacher.ipynb", notebook(lesson, LessonFor::teacher));
    const std::string pupil = written(folder, "pupil.ipynb", notebook(lesson, LessonFor::pupil));
    const ShellRun outcome = script(interpreter, "lesson_exercises.py", teacher + " " + pupil);
    INFO(lesson.name, "\n", outcome.output);
    CHECK(outcome.code == 0);
  }
}

TEST_CASE("a lesson runs without matplotlib, too") {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: not run");
    return;
  }
  const ScratchFolder folder;
  folder.write("matplotlib.py", "raise ImportError('hidden by a test')\n");
  const std::string file =
      written(folder, "falling-short.ipynb", notebook(find_lesson("falling-short"), LessonFor::teacher));
  const ShellRun outcome = shell_run("PYTHONPATH='" + folder.root().string() + "' '" + interpreter +
                                     "' '" SHORTFALL_SOURCE_DIR "/tests/export/run_notebook.py' " + file);
  INFO(outcome.output);
  CHECK(outcome.code == 0);
}

TEST_CASE("a lesson fails when one of its numbers or formulas is wrong") {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: not run");
    return;
  }
  const std::vector<std::array<std::string, 3>> mistakes{
      {"falling-short", "v = v + h * a(x, v, t)", "v = v + h / 2 * a(x, v, t)"},
      {"falling-short", "\\\"2.762010199\\\"", "\\\"2.762010198\\\""},
      {"gauss-faulhaber", "bernoulli[:7] == [1, Fraction(1, 2)", "bernoulli[:7] == [1, Fraction(1, 3)"},
      {"three-eulers", "(1 + 2 * n) * x0", "(1 - 2 * n) * x0"},
      {"floats", "24986955", "24986956"},
      {"modified-equation", "series(0, 0, Fraction(-1, 2))", "series(0, 0, Fraction(1, 2))"},
      {"nine-engines", "\\\"Bullet\\\": 14.25", "\\\"Bullet\\\": 14.26"}};
  const ScratchFolder folder;
  std::string files;
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    const auto& [name, from, to] = mistakes[i];
    std::string text = notebook(find_lesson(name), LessonFor::teacher);
    const std::size_t at = text.rfind(from);
    INFO(mistakes[i][0], ": ", mistakes[i][1]);
    REQUIRE(at != std::string::npos);
    files += " " + written(folder, std::to_string(i) + ".ipynb", text.replace(at, from.size(), to));
  }
  const ShellRun outcome = script(interpreter, "run_notebook.py", files);
  INFO(outcome.output);
  CHECK(outcome.code == 1);
  CHECK(outcome.output.find("0 notebooks passed, " + std::to_string(mistakes.size()) + " failed") !=
        std::string::npos);
}

TEST_CASE("the same lesson gives the same bytes, and no substitution is left in them") {
  for (const Lesson& lesson : lessons())
    for (const LessonFor reader : {LessonFor::teacher, LessonFor::pupil}) {
      const std::string text = notebook(lesson, reader);
      CHECK(text == notebook(lesson, reader));
      CHECK(text.find("{{") == std::string::npos);
    }
}

TEST_CASE("every cell that draws shows its picture before it is run, to teachers and to pupils") {
  int drawn = 0;
  for (const Lesson& lesson : lessons())
    for (const LessonFor reader : {LessonFor::teacher, LessonFor::pupil}) {
      CAPTURE(lesson.name);
      const auto file = nlohmann::json::parse(notebook(lesson, reader));
      for (const auto& cell : file["cells"]) {
        std::string source;
        for (const auto& line : cell["source"]) source += line.get<std::string>();
        const bool draws = cell["cell_type"] == "code" && source.find("plt.show()") != std::string::npos;
        if (!draws) {
          CHECK((!cell.contains("outputs") || cell["outputs"].empty()));
          continue;
        }
        ++drawn;
        REQUIRE(cell["outputs"].size() == 1);
        const std::string png = cell["outputs"][0]["data"]["image/png"];
        CHECK(png.starts_with("iVBORw0KGgo"));  // a PNG's first eight bytes
        CHECK(png.size() > 5000);
      }
    }
  CHECK(drawn >= 16);
}

TEST_CASE("graded cells carry what nbgrader asks for, and slides what Jupyter asks for") {
  const auto file = nlohmann::json::parse(notebook(find_lesson("falling-short"), LessonFor::pupil));
  std::set<std::string> ids;
  int graded = 0, slides = 0;
  for (const auto& cell : file["cells"]) {
    slides += cell["metadata"].contains("slideshow");
    if (!cell["metadata"].contains("nbgrader")) continue;
    ++graded;
    const auto& m = cell["metadata"]["nbgrader"];
    CHECK(m["schema_version"] == 3);
    CHECK(m["cell_type"] == cell["cell_type"]);
    CHECK(m["locked"] != m["solution"]);
    CHECK((m["grade"] || m["solution"]));
    CHECK(m["grade"] == m.contains("points"));
    CHECK(ids.insert(m["grade_id"]).second);
  }
  CHECK(graded == 7);  // three solutions with their checks, one answer
  CHECK(slides > 10);
}

TEST_CASE("what shortfall puts into a lesson is what is known from elsewhere") {
  CHECK(lesson_value("jump symplectic-euler 2/5 short:cm 9") == "2.762010199");
  CHECK(lesson_value("jump chipmunk 2/5 short:cm 3") == "-2.841");
  CHECK(lesson_value("powers 4") ==
        "\\frac{1}{5} \\, n^{5} + \\frac{1}{2} \\, n^{4} + \\frac{1}{3} \\, n^{3} - \\frac{1}{30} \\, n");
  CHECK(lesson_value("powers 1 list") == "[Fraction(0, 1), Fraction(1, 2), Fraction(1, 2)]");
  CHECK(lesson_value("clock 1/10 1000000 value") == "3230667/32");
  CHECK(lesson_value("clock 1/60 1 stops-after") == "24986955");
  CHECK(lesson_value("stability symplectic-euler trace") == "2 - y");
  CHECK(lesson_value("damping ode terminal 3 c=1/2") == "0.196");
  CHECK(lesson_value("step symplectic-euler one") ==
        "def one(x, v, t, h, a):\n    \"\"\"One step of length h, from t to t + h.\"\"\"\n    v = v + h * "
        "a(x, v, t)\n    x = x "
        "+ h * v\n    return x, v");
  CHECK(lesson_value("step bullet").find("(1 - c)**h") != std::string::npos);
}

TEST_CASE("a mistake in a lesson file is named with its line") {
  const auto read_ = [](const std::string& text) { return parse_lesson(text, "wrong.lesson"); };
  const std::string head = "lesson wrong\ntitle Wrong\nabout It is wrong.\n\n";
  CHECK_THROWS_WITH_AS(read_(""), doctest::Contains("a lesson needs the lines"), SyntaxError);
  CHECK_THROWS_WITH_AS(read_("titel Wrong\n"),
                       doctest::Contains("wrong.lesson:1:1: unknown word 'titel'; did you mean 'title'?"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% txt\nHi\n"), doctest::Contains("did you mean 'text'?"), SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% text\n\n"), doctest::Contains(":5:1: this cell is empty"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% solution a\npass\n"), doctest::Contains("### BEGIN SOLUTION"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% code\n### BEGIN SOLUTION\n"), doctest::Contains("only cells"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% check a\npass\n"), doctest::Contains("wants points=N"), SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% check a points=x\npass\n"), doctest::Contains("a whole number"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% check points=1\npass\n"), doctest::Contains("wants a name"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(read_(head + "%% check a points=1\np\n%% check a points=1\np\n"),
                       doctest::Contains("two cells"), SyntaxError);
  const auto made = [](const std::string& cell) { return notebook(small(cell), LessonFor::teacher); };
  CHECK_THROWS_WITH_AS(made("1\n{{stpe rapier}}"), doctest::Contains("small.lesson:7:1: {{stpe rapier}}"),
                       SyntaxError);
  CHECK_THROWS_WITH_AS(made("{{step rapeir}}"), doctest::Contains("did you mean 'rapier'?"), SyntaxError);
  CHECK_THROWS_WITH_AS(made("{{jump rapier}}"), doctest::Contains("wants more words"), SyntaxError);
  CHECK_THROWS_WITH_AS(made("{{step rapier"), doctest::Contains("is not closed"), SyntaxError);
  CHECK_THROWS_AS(made("{{}}"), SyntaxError);
}

TEST_CASE("shortfall export writes a lesson into a folder, and no answer over an older one") {
  const ScratchFolder folder;
  const std::string out = quoted(folder, "new/lesson");
  CHECK(shell_run(shortfall("export lesson:falling-short --exercise -o " + out)).code == 0);
  const fs::path file = folder.root() / "new/lesson/falling-short.ipynb";
  const std::string pupil = notebook(find_lesson("falling-short"), LessonFor::pupil);
  CHECK(read(file) == pupil);
  CHECK(read(folder.root() / "new/lesson/falling-short.md").find("pupil's copy") != std::string::npos);

  const ShellRun refused = shell_run(shortfall("export lesson:falling-short -o " + out));
  CHECK(refused.code == 2);
  CHECK(refused.output.find("is there already") != std::string::npos);
  CHECK(read(file) == pupil);
  CHECK(shell_run(shortfall("export lesson:falling-short --overwrite -o " + out)).code == 0);
  CHECK(read(file) == notebook(find_lesson("falling-short"), LessonFor::teacher));

  CHECK(shell_run(shortfall("export lesson:falling-short --exercise")).output == pupil);
  CHECK(shell_run(shortfall("export lesson:floats -o /proc/no/such")).code == 5);
}

TEST_CASE("an unknown lesson is a mistake of the user, with a suggestion") {
  const ShellRun outcome = shell_run(shortfall("export lesson:faling-short"));
  CHECK(outcome.code == 2);
  CHECK(outcome.output.find("did you mean 'falling-short'?") != std::string::npos);
  CHECK(shell_run(shortfall("export lesson:")).code == 2);
  CHECK(shell_run(shortfall("export symplectic-euler --exercise --notebook")).code == 2);
}

TEST_CASE("the list of lessons tells how long they take, as text and as JSON") {
  CHECK(shell_run(shortfall("export --lessons")).output.find("falling-short      35 min") !=
        std::string::npos);
  const auto json = nlohmann::json::parse(shell_run(shortfall("export --lessons --json")).output);
  CHECK(json["schema"] == "shortfall.lessons/1");
  CHECK(json["lessons"].size() == 6);
}

}  // namespace
}  // namespace shortfall
