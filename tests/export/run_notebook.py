#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs notebooks as a reader would: all code cells in order, in one namespace. The standard library is enough.

Each file is first held against the rules of the notebook format, version 4.5, that matter here. A line a file that
failed, with the cell; the exit code is 1 if anything failed.

    tests/export/run_notebook.py [--jupyter] FILE ...

With --jupyter the files are validated by nbformat and executed by nbconvert instead, in a kernel of their own; the exit
code is 77 when these are not installed.
"""

import contextlib
import io
import json
import os
import re
import sys
import traceback

SYSTEM_PYTHON = "/usr/bin/python3"

os.environ.setdefault("MPLBACKEND", "Agg")  # a picture is drawn, and not shown


def complaints(notebook):
    """What breaks the format."""
    if (notebook.get("nbformat"), notebook.get("nbformat_minor")) != (4, 5):
        yield "it is not of format 4.5"
    if set(notebook) != {"cells", "metadata", "nbformat", "nbformat_minor"}:
        yield "its members are " + ", ".join(notebook)
    seen = set()
    for number, cell in enumerate(notebook["cells"]):
        where = f"cell {number}: "
        wanted = {"cell_type", "id", "metadata", "source"}
        if cell["cell_type"] == "code":
            wanted |= {"execution_count", "outputs"}
        elif cell["cell_type"] != "markdown":
            yield where + "unknown type " + cell["cell_type"]
        if set(cell) != wanted:
            yield where + "its members are " + ", ".join(cell)
        if not re.fullmatch(r"[a-zA-Z0-9_-]{1,64}", cell["id"]) or cell["id"] in seen:
            yield where + "bad id " + cell["id"]
        seen.add(cell["id"])
        source = cell["source"]
        if not source or any(not line.endswith("\n") for line in source[:-1]):
            yield where + "its lines are not lines"
        text = "".join(source)
        if cell["cell_type"] == "markdown" and (text.count("$$") % 2 or text.replace(r"\$", "").count("$") % 2):
            yield where + "a formula is not closed"


def execute(path, notebook):
    """Runs the code cells; raises what they raise."""
    namespace = {"__name__": "__main__"}
    for number, cell in enumerate(notebook["cells"]):
        if cell["cell_type"] != "code":
            continue
        source = "".join(cell["source"])
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(source, f"{path}, cell {number}", "exec"), namespace)
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


def plainly(path):
    with open(path, encoding="utf-8") as file:
        notebook = json.load(file)
    found = list(complaints(notebook))
    for complaint in found:
        print(f"{path}: {complaint}")
    try:
        execute(path, notebook)
    except Exception:
        print(f"{path}: a cell failed")
        traceback.print_exc(limit=-1, file=sys.stdout)
        return False
    return not found


def with_jupyter(path):
    import nbformat
    from nbconvert.preprocessors import ExecutePreprocessor

    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    ExecutePreprocessor(timeout=600, startup_timeout=300, kernel_name="python3").preprocess(notebook, {"metadata": {"path": "/tmp"}})
    return True


def main(arguments):
    run = plainly
    if arguments[:1] == ["--jupyter"]:
        run, arguments = with_jupyter, arguments[1:]
        try:
            import ipykernel  # noqa: F401
            import nbconvert  # noqa: F401
            import nbformat  # noqa: F401
        except ImportError as missing:
            # Debian's packages belong to Debian's interpreter, which need not be the first on the search path.
            if sys.executable != SYSTEM_PYTHON and os.access(SYSTEM_PYTHON, os.X_OK):
                os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, __file__, "--jupyter", *arguments])
            print(f"not run: {missing}")
            return 77
    passed = [run(path) for path in arguments]
    print(f"{sum(passed)} notebooks passed, {len(passed) - sum(passed)} failed")
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
