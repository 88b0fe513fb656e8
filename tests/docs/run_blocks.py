# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every command of the ```console blocks of documents again and compares what it prints; runs the commands that
stand indented, without their output; and steps the scenes of ```toml blocks.

A line `$ command` is run with shortfall on the PATH in a directory of the document's own, empty but for links to the
repository's examples, scenes and tests (so what a reader runs at the root of the repository runs here); the lines up to
the next `$` or the end of the block must be its output (stdout and stderr together). A line `...` stands for any number
of lines; what a clock measured is not compared. `# exit N` as the last line states the exit code. Of an indented command
only the exit code is looked at: 0, or N where a comment behind it says `exit N`.
Usage: run_blocks.py SHORTFALL DOCUMENT...
"""
import difflib
import os
import re
import subprocess
import sys
import tempfile


def folder_of_document():
    """A new directory in which the commands of one document are run."""
    folder = tempfile.TemporaryDirectory()
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    for name in ("examples", "scenes", "tests"):
        os.symlink(os.path.join(root, name), os.path.join(folder.name, name))
    return folder


def blocks(path):
    """(line number, command, expected lines) of every command in a document."""
    inside, found = False, []
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        line = line.rstrip("\n")
        if line.startswith("```"):
            inside = line.strip() == "```console"
        elif inside and line.startswith("$ "):
            found.append((number, line[2:], []))
        elif inside and found:
            found[-1][2].append(line)
    return found


def indented_commands(path):
    """(line number, command, exit code) of every command that is shown indented by four blanks.

    More than one blank after the name makes it a row of a table."""
    found, fenced = [], False
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        fenced ^= line.startswith("```")
        shown = re.match(r"    ((?:shortfall|awk|printf) \S.*?)(?:  +# (.*))?$", line.rstrip("\n"))
        if shown and not fenced:
            code = re.search(r"exit (\d+)", shown[2] or "")
            found.append((number, shown[1], int(code[1]) if code else 0))
    return found


def scenes(path):
    """(line number, text) of every ```toml block."""
    text = open(path, encoding="utf-8").read()
    return [(text.count("\n", 0, m.start()) + 1, m[1]) for m in re.finditer(r"^```toml\n(.*?)^```$", text, re.M | re.S)]


def without_clock(line):
    """A line without what a clock measured (ns, us, and their ratio), which no two runs share."""
    return re.sub(r"\d+ times as much", "N times as much", re.sub(r"\b\d[\d.]* (?:ns|us)\b", "T", line.rstrip()))


def matches(expected, actual):
    """Whether the lines agree, `...` standing for any lines."""
    if not expected:
        return not actual
    if expected[0].strip() == "...":
        return any(matches(expected[1:], actual[i:]) for i in range(len(actual) + 1))
    return bool(actual) and without_clock(expected[0]) == without_clock(actual[0]) and matches(expected[1:], actual[1:])


def main():
    shortfall, documents = os.path.abspath(sys.argv[1]), sys.argv[2:]
    passed = failed = 0
    for document in documents:
        with folder_of_document() as folder:
            environment = dict(os.environ, PATH=os.path.dirname(shortfall) + os.pathsep + os.environ["PATH"], NO_COLOR="1")
            for number, command, expected in blocks(document):
                code = 0
                while expected and (expected[-1] == "" or expected[-1].startswith("# exit ")):
                    last = expected.pop()
                    code = int(last.split()[-1]) if last else code
                run = subprocess.run(command, shell=True, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
                actual = run.stdout.decode("utf-8").rstrip("\n").split("\n") if run.stdout else []
                if run.returncode == code and matches(expected, actual):
                    passed += 1
                    continue
                failed += 1
                print(f"{document}:{number}: $ {command}\n  exit code {run.returncode}, expected {code}")
                print("\n".join("  " + line for line in difflib.unified_diff(expected, actual, "document", "today", lineterm="", n=1)))
            others = indented_commands(document)
            for number, text in scenes(document):
                name = f"scene-{number}.toml"
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
                others.append((number, f"shortfall trade {name} --integrators rk4 --no-peers --repeats 0", 0))
            for number, command, code in others:
                run = subprocess.run(command, shell=True, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
                if run.returncode == code:
                    passed += 1
                    continue
                failed += 1
                print(f"{document}:{number}: {command}\n  exit code {run.returncode}, expected {code}\n  {run.stdout.decode('utf-8')[-600:]}")
    print(f"{passed} commands as printed, {failed} not")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
