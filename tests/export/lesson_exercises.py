#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the pupil's copy of a lesson before the pupil has written anything.

Every cell must run but the locked ones that give points: these must fail, for otherwise they check nothing. And no answer may be left.

    tests/export/lesson_exercises.py TEACHERS_COPY PUPILS_COPY
"""

import contextlib
import io
import json
import os
import re
import sys

os.environ.setdefault("MPLBACKEND", "Agg")


def cells(path):
    with open(path, encoding="utf-8") as file:
        return [(cell, "".join(cell["source"])) for cell in json.load(file)["cells"]]


def answers(source):
    return re.findall(r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", source, re.DOTALL)


def complaints(teacher, pupil):
    if [c["id"] for c, _ in teacher] != [c["id"] for c, _ in pupil]:
        yield "the copies do not have the same cells"
    everything = "\n".join(source for _, source in pupil)
    if "SOLUTION" in everything:
        yield "a marker is left in the pupil's copy"
    exercises = 0
    for cell, source in teacher:
        found = answers(source)
        graded = cell["metadata"].get("nbgrader", {})
        if bool(found) != graded.get("solution", False):
            yield f"{cell['id']}: an answer without nbgrader's metadata, or the reverse"
        for answer in found:
            exercises += 1
            if answer in everything:
                yield f"{cell['id']}: the answer is in the pupil's copy"
    if exercises < 4:
        yield f"{exercises} exercises only"
    namespace = {"__name__": "__main__"}
    for cell, source in pupil:
        if cell["cell_type"] != "code":
            continue
        graded = cell["metadata"].get("nbgrader", {})
        failed = None
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(source, cell["id"], "exec"), namespace)
        except Exception as error:
            failed = error
        if graded.get("grade") and failed is None:
            yield f"{cell['id']} gives points for nothing"
        elif graded.get("grade") and not isinstance(failed, NotImplementedError):
            yield f"{cell['id']} fails, but not because nothing was written: {failed!r}"
        elif not graded.get("grade") and failed is not None:
            yield f"{cell['id']} fails before the pupil has written anything: {failed!r}"


def main(arguments):
    teacher, pupil = (cells(path) for path in arguments)
    found = list(complaints(teacher, pupil))
    for complaint in found:
        print(f"{arguments[1]}: {complaint}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
