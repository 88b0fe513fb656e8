// SPDX-License-Identifier: GPL-3.0-or-later
// What SECURITY.md promises: signals, closed pipes, full disks, folders that are not there, nothing outside
// the named output, and files that cannot do anything but be read.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

/// What lies in a folder, but for the two files of Folder::run.
std::vector<std::string> files_in(const Folder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path(".")))
    if (entry.path().filename() != ".out" && entry.path().filename() != ".error")
      names.push_back(fs::relative(entry.path(), folder.path(".")).string());
  std::ranges::sort(names);
  return names;
}

TEST_CASE("a pipe that is closed early is quiet") {
  const Folder folder;
  const CommandRun o = folder.run("list | head -n 1");
  CHECK(o.code == 0);
  CHECK(o.error.empty());
  CHECK_FALSE(o.out.empty());
}

TEST_CASE("help is a command as well") {
  CHECK(run("help").out == run("--help").out);
  CHECK(run("help jump").out == run("jump --help").out);
  CHECK(run("help jmup").code == 2);
}

TEST_CASE("a full disk is exit code 5, whatever is written") {
  for (const std::string command :
       {"list", "jump --height 1", "derive rk4 --json", "export symplectic-euler --latex", "completion bash",
        "manual", "--version", "--help"}) {
    CAPTURE(command);
    const CommandRun o = run(command + " >/dev/full 2>.error #");
    CHECK(o.code == 5);
    CHECK(contains(o.error, "shortfall: "));
  }
}

TEST_CASE("an output that cannot be made is exit code 5, and nothing is left behind") {
  const Folder folder;
  for (const std::string where : {"nowhere/out.txt", "/proc/shortfall.txt"}) {
    CAPTURE(where);
    CHECK(folder.run("derive symplectic-euler -o " + where).code == 5);
  }
  CHECK(files_in(folder).empty());
}

TEST_CASE("a symbolic link stays one, and what it names is written") {
  const Folder folder;
  folder.write("target.txt", "before");
  fs::create_directory(folder.path("below"));
  fs::create_symlink("../target.txt", folder.path("below/link.txt"));
  fs::create_symlink("new.txt", folder.path("dangling.txt"));
  CHECK(folder.run("derive symplectic-euler -o below/link.txt").code == 0);
  CHECK(folder.run("derive symplectic-euler -o dangling.txt").code == 0);
  CHECK(fs::is_symlink(folder.path("below/link.txt")));
  CHECK(fs::is_symlink(folder.path("dangling.txt")));
  CHECK(contains(folder.text("target.txt"), "symplectic-euler"));
  CHECK(folder.text("new.txt") == folder.text("target.txt"));
  CHECK(folder.run("derive symplectic-euler -o /dev/stdout >>target.txt 2>.error #").code == 0);
  CHECK(folder.text("target.txt") == folder.text("new.txt") + folder.text("new.txt"));
  CHECK(fs::is_symlink("/dev/stdout"));
}

TEST_CASE("a new file whose place cannot be looked at is exit code 5") {
  const Folder folder;
  CHECK(folder.run("new integrator " + std::string(300, 'a') + ".integrator").code == 5);
  folder.write("file", "");
  CHECK(folder.run("new integrator file/a.integrator").code == 5);
}

TEST_CASE("one kind of output is printed: two are refused") {
  const Folder folder;
  for (const std::string command :
       {"jump --height 1 --json --csv", "jump --height 1 --lang cpp --json", "correct rk4 --lang cpp --json",
        "derive rk4 --json --latex", "modified rk4 --latex --json", "damping godot --lang cpp --json",
        "clock --dt 0.1f --until 1h --json --csv", "show rk4 --lang cpp --json",
        "trade s.toml --json --csv"}) {
    CAPTURE(command);
    const CommandRun o = run(command);
    CHECK(o.code == 2);
    CHECK(contains(o.error, ": give one of them"));
  }
  CHECK(run("extremes --substeps 4").code == 2);
  CHECK(run("extremes box2d --substeps 4 --formats f32").code == 0);
}

TEST_CASE("a signal ends the work at once, and leaves nothing half-written") {
  const Folder folder;
  // An answer that takes far longer than the test waits.
  const std::string work = "derive generalised-alpha --force poly:150 -o out.txt";
  for (const std::string signal : {"INT", "TERM", "KILL"}) {
    CAPTURE(signal);
    const CommandRun o = folder.run(work, "timeout -s " + signal + " 0.5");
    CHECK((o.code == 124 || o.code == 137));
    CHECK(files_in(folder).empty());
  }
}

TEST_CASE("nothing is written outside the named output") {
  const Folder folder;
  fs::create_directory(folder.path("home"));
  folder.write("own.integrator", run("show symplectic-euler").out);
  const std::string before = "HOME=" + folder.path("home") + " TMPDIR=" + folder.path("home") +
                             " XDG_CACHE_HOME=" + folder.path("home") +
                             " XDG_CONFIG_HOME=" + folder.path("home");
  const std::vector<std::string> commands = {"list",
                                             "doctor",
                                             "jump own.integrator --height 1",
                                             "derive own.integrator",
                                             "stability rk4",
                                             "order rk4",
                                             "budget symplectic-euler --height 1.7 --dt 0.02f --formats f32",
                                             "clock --dt 1/60f --until 24h",
                                             "export symplectic-euler --html -o page.html",
                                             "export symplectic-euler --notebook -o book.ipynb"};
  for (const std::string& command : commands) {
    CAPTURE(command);
    CHECK(folder.run(command, before).code == 0);
  }
  CHECK(files_in(folder) == std::vector<std::string>{"book.ipynb", "home", "own.integrator", "page.html"});
}

TEST_CASE("what an .integrator or a scene says is never run, opened or asked for") {
  const Folder folder;
  const std::string evil = "$(touch struck) `touch struck` ; touch struck | touch struck";
  folder.write("a.integrator", "integrator x\nstep\n  v = v + h*system(" + evil + ")\n  x = x + h*v\n");
  folder.write("b.integrator", "include /etc/passwd\nintegrator x\nstep\n  x = x + h*v\n");
  folder.write("s.toml", "name = \"" + evil + "\"\ninclude = \"/etc/passwd\"\n");
  for (const std::string command :
       {"derive a.integrator", "derive b.integrator", "trade s.toml", "advise s.toml"}) {
    CAPTURE(command);
    const CommandRun o = folder.run(command);
    CHECK(o.code == 3);
    CHECK_FALSE(contains(o.text(), "root:"));
  }
  CHECK_FALSE(folder.has("struck"));
}

TEST_CASE("limits of size, depth and length have one sentence each") {
  const Folder folder;
  const std::string head = "integrator x\nstep\n  v = v + h*a(x, v, t)\n  x = x + h*";
  folder.write("deep.integrator", head + std::string(100'000, '(') + "v" + std::string(100'000, ')') + "\n");
  folder.write("long.integrator", head + "v" + std::string(2'000'000, ' ') + "\n");
  std::string sum = "v";
  for (int i = 0; i < 5000; ++i) sum += " + v";
  folder.write("wide.integrator", head + "(" + sum + ")\n");
  folder.write("digits.integrator", head + std::string(50'000, '9') + "*v\n");
  folder.write("power.integrator", head + "(1 + h*v)^999999999\n");
  for (const std::string name : {"deep", "long", "wide", "digits", "power"}) {
    CAPTURE(name);
    const CommandRun o = folder.run("derive " + name + ".integrator", "timeout 20");
    CHECK((o.code == 3 || o.code == 4));
    CHECK(o.error.size() < 2000);
    CHECK(o.out.empty());
  }
}

}  // namespace
}  // namespace shortfall
