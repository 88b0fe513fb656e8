# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles every ```cpp block of documents, as the inside of a function in which x0, v0, x and v are vectors of one number.

Usage: compile_blocks.py COMPILER SOURCE NATIVE DOCUMENT...
SOURCE is the repository, which an installed tree has as <shortfall/...>; NATIVE the folder of the classes that the build wrote.
"""
import os
import re
import subprocess
import sys
import tempfile

GIVEN = "std::vector<double> x0{1}, v0{0}, x(1), v(1);"


def program(block):
    """The block as a file: what includes stays in front."""
    lines = block.split("\n")
    includes = [line for line in lines if line.startswith("#include")]
    inside = [line for line in lines if not line.startswith("#include")]
    return "\n".join(["#include <vector>", *includes, "void example() {", "  {", "    " + GIVEN, "    {", *inside, "    }", "  }", "}", ""])


def main():
    compiler, source, native, documents = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
    good = bad = 0
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(source, os.path.join(folder, "shortfall"))
        os.symlink(native, os.path.join(folder, "native"))
        for document in documents:
            text = open(document, encoding="utf-8").read()
            for found in re.finditer(r"^```cpp\n(.*?)^```$", text, re.M | re.S):
                run = subprocess.run([compiler, "-std=c++20", "-ffp-contract=off", "-fsyntax-only", "-x", "c++", "-", "-I", folder, "-I", source],
                                     input=program(found[1]), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=300)
                if run.returncode == 0:
                    good += 1
                else:
                    bad += 1
                    print(f"{document}:{text.count(chr(10), 0, found.start()) + 1}: does not compile\n{run.stdout[:2000]}")
    print(f"{good} blocks compile, {bad} do not")
    return 1 if bad or not good else 0


if __name__ == "__main__":
    sys.exit(main())
