# SPDX-License-Identifier: GPL-3.0-or-later
"""Rewrites the outputs in the ```console blocks of documents with what the commands print today. Read the diff before you commit it.

Usage: fill_blocks.py SHORTFALL DOCUMENT...
"""
import os
import subprocess
import sys

from run_blocks import folder_of_document


def refilled(path, shortfall):
    inside, output = False, []
    environment = dict(os.environ, PATH=os.path.dirname(shortfall) + os.pathsep + os.environ["PATH"], NO_COLOR="1")
    with folder_of_document() as folder:
        for line in open(path, encoding="utf-8").read().split("\n"):
            if line.startswith("```"):
                inside = line.strip() == "```console"
            elif inside and not line.startswith("$ "):
                continue  # the old output
            output.append(line)
            if inside and line.startswith("$ "):
                run = subprocess.run(line[2:], shell=True, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
                output += [text.rstrip() for text in run.stdout.decode("utf-8").rstrip("\n").split("\n")] if run.stdout else []
                if run.returncode:
                    output.append(f"# exit {run.returncode}")
    return "\n".join(output)


if __name__ == "__main__":
    for document in sys.argv[2:]:
        text = refilled(document, os.path.abspath(sys.argv[1]))
        open(document, "w", encoding="utf-8").write(text)
