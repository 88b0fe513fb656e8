# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference of the command, docs/commands.md, from what `shortfall --help` and `shortfall COMMAND --help` print.

Usage: make_commands.py SHORTFALL DOCUMENT            writes the document
       make_commands.py --check SHORTFALL DOCUMENT    fails, with the difference, when it is stale
"""
import difflib
import os
import re
import subprocess
import sys

INTRODUCTION = """# Commands

What `shortfall COMMAND --help` says, for all commands. This page is written by `tests/docs/make_commands.py`; do not edit it. What stands after `=` is taken
when an option is left out. Every command has `--help`.

- Numbers are text and exact: `0.02`, `1/50`, `40cm`, `50Hz`. `1/60f` is 1/60, rounded to binary32.
- INTEGRATOR is a name or an alias (`shortfall list`), an engine with its version (`rapier@0.21`), or a file that ends in .integrator or .json.
- Exit codes: 0 done; 1 a claim refuted or a tolerance missed; 2 usage; 3 bad input file; 4 not derivable, with the reason; 5 input/output; 70 a bug of ours.
"""


def printed(shortfall, *words):
    """What the command prints, without an end of line that nobody sees."""
    run = subprocess.run([shortfall, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60,
                         env=dict(os.environ, NO_COLOR="1"))
    text = run.stdout.decode("utf-8")
    if run.returncode:
        sys.exit(f"shortfall {' '.join(words)} ended with {run.returncode}:\n{text}")
    return text


def groups(text):
    """[(group, [command])] from the overview: a group ends in a colon, its commands are indented by two."""
    found = []
    for line in text.split("Usage:", 1)[1].split("\n"):
        if re.fullmatch(r"\S.*:", line):
            found.append((line[:-1], []))
        elif found and re.match(r"  (?!shortfall )[a-z]", line):
            found[-1][1].append(line.split()[0])
    return [group for group in found if group[1]]


def entries(lines):
    """[(what is written, what it means)]: a line that is indented far goes on with the one above."""
    found = []
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if indent >= 30 and found:
            found[-1][1] += " " + line.strip()
        elif line.strip():
            head, _, tail = re.sub(r"^(-\w),\s+--", r"\1,--", line.strip()).partition("  ")
            if not tail and line[33:34] == " ":  # what is written fills its column to the last character but one
                head, tail = line[:33].strip(), line[34:]
            found.append([head, tail.strip()])
    return [(head.replace(" ...", "..."), meaning.strip()) for head, meaning in found]


def parts(text):
    """(examples, sentence, usage, positionals, options) of the help of one command, however CLI11 has set it."""
    head, rest = text.split("Usage:", 1)
    lines = [line for line in head.split("\n") if line.strip()]
    examples = [line.strip() for line in lines if line.startswith("  ")]
    sentences = [line.strip() for line in lines if not line.startswith("  ") and line != "Examples:"]
    usage, *sections = re.split(r"(?im)^(positionals|options):", rest)
    found = {name.lower(): entries(body.split("\n")) for name, body in zip(sections[::2], sections[1::2])}
    options = [entry for entry in found.get("options", []) if not entry[0].startswith("-h")]
    return examples, " ".join(sentences), " ".join(usage.split()), found.get("positionals", []), options


def of_command(name, help_text):
    examples, sentence, usage, positionals, options = help_text
    text = f"\n## {name}\n{sentence}\n\n```text\n" + "\n".join(examples) + f"\n```\n\nUsage: `{usage}`\n"
    if positionals + options:
        text += "\n"
    for head, meaning in positionals + options:
        word, _, excluded = head.partition("Excludes: ")
        if meaning.startswith("Excludes: "):  # newer releases of CLI11 write it behind, or in the next column
            excluded = re.match(r"Excludes:((?: (?:--[\w-]+|[A-Z]+)(?=\s|$))+)", meaning)
            excluded, meaning = excluded.group(1), meaning[excluded.end():].strip()
        word = re.sub(r"(?<! in) \[([^]]*)\]$", r"=\1", word.strip())  # how newer releases of CLI11 write a default
        if meaning.startswith("REQUIRED "):
            word, meaning = word + " REQUIRED", meaning[len("REQUIRED "):].strip()
        text += f"- `{word}`: {meaning}" + (f" (not with {', '.join(excluded.split())})" if excluded else "") + "\n"
    return text


def document(shortfall):
    commands = groups(printed(shortfall, "--help"))
    helps = {name: parts(printed(shortfall, name, "--help")) for _, names in commands for name in names}
    text = INTRODUCTION + "\n| | command | |\n|---|---|---|\n"
    for group, names in commands:
        for i, name in enumerate(names):
            text += f"| {group if i == 0 else ''} | [{name}](#{name}) | {helps[name][1]} |\n"
    return text + "".join(of_command(name, helps[name]) for _, names in commands for name in names)


def main():
    check = sys.argv[1:2] == ["--check"]
    shortfall, path = sys.argv[1 + check:]
    text = document(os.path.abspath(shortfall))
    if not check:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return 0
    with open(path, encoding="utf-8") as file:
        found = file.read()
    if found == text:
        print(f"{path} is what the command prints: {text.count(chr(10) + '## ')} commands")
        return 0
    print(f"{path} is stale; tests/docs/make_commands.py writes it anew:")
    print("\n".join(difflib.unified_diff(found.split("\n"), text.split("\n"), "document", "today", lineterm="", n=1)))
    return 1


if __name__ == "__main__":
    sys.exit(main())
