#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the lessons and keeps what they draw, so that their notebooks show it before they are run.

    lessons/draw_pictures.py SHORTFALL [--check]

Writes lessons/pictures/LESSON-NUMBER.png for every cell that calls plt.show(), where the code up to there has changed
since; drawn-from.json there says by its SHA-256 which code that was. With --check nothing is written or run: the exit
code is 1 when a picture is missing, left over, or of other code. Needs matplotlib, except with --check.
"""

import contextlib
import hashlib
import io
import json
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "pictures"


def lessons(shortfall):
    """Names and code cells."""
    said = subprocess.run([shortfall, "export", "--lessons", "--json"], check=True, capture_output=True, text=True).stdout
    for lesson in json.loads(said)["lessons"]:
        text = subprocess.run([shortfall, "export", "lesson:" + lesson["name"]], check=True, capture_output=True, text=True).stdout
        yield lesson["name"], ["".join(c["source"]) for c in json.loads(text)["cells"] if c["cell_type"] == "code"]


def pictures(cells):
    """For each cell that draws: its index, and a digest of the code up to there."""
    code = hashlib.sha256()
    for index, source in enumerate(cells):
        code.update(source.encode() + b"\n")
        if "plt.show()" in source:
            yield index, code.hexdigest()


def draw(name, cells, wanted):
    """Runs the cells; saves what those of `wanted` (index: file) show."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    at = None

    def show():
        if at in wanted:
            # No date, no version: the same drawing is the same file.
            plt.gcf().savefig(wanted[at], dpi=80, metadata={"Software": None})
        plt.close("all")

    plt.show = show
    namespace = {"__name__": "__main__"}
    for at, source in enumerate(cells):
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(source, f"{name}, code cell {at}", "exec"), namespace)


def main(arguments):
    shortfall, check = arguments[0], "--check" in arguments
    known_file = FOLDER / "drawn-from.json"
    known = json.loads(known_file.read_text()) if known_file.exists() else {}
    now, stale = {}, []
    for name, cells in lessons(shortfall):
        wanted = {}
        for number, (index, digest) in enumerate(pictures(cells), 1):
            file = f"{name}-{number}.png"
            now[file] = digest
            if known.get(file) != digest or not (FOLDER / file).exists():
                stale.append(file)
                wanted[index] = FOLDER / file
        if wanted and not check:
            FOLDER.mkdir(exist_ok=True)
            draw(name, cells, wanted)
    left_over = [f.name for f in FOLDER.glob("*.png") if f.name not in now]
    for file in stale + left_over:
        print(("stale: " if file in stale else "left over: ") + file)
    if check:
        if stale or left_over:
            print("./dev pictures draws them anew")
        return 1 if stale or left_over else 0
    for file in left_over:
        (FOLDER / file).unlink()
    known_file.write_text(json.dumps(now, indent=1, sort_keys=True) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
