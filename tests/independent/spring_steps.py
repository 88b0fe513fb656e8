#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Three steps of every integrator for a damped, driven spring, by the second implementation of the language.

    tests/independent/spring_steps.py FOLDER FILE           compare FILE with what the integrators in FOLDER do
    tests/independent/spring_steps.py FOLDER FILE --write   write it

The file holds, for every integrator that is no engine's, its name and a line `x v` after each step, with 50 significant
digits, parameters at their defaults. A force that reads x, v and t sees coefficients that forces a(t) and springs
without a damper do not: when the velocity is predicted, in the stages of a tableau, in the start of a multistep method.
"""

import sys
from decimal import Decimal, localcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
from interpreter import parameters, run  # noqa: E402
from language import Integrator  # noqa: E402

K, C, G, B = Fraction(2, 3), Fraction(3, 5), Fraction(1, 2), Fraction(-1, 7)
H, X, V, T = Fraction(1, 3), Fraction(5, 4), Fraction(-1, 3), Fraction(2, 7)
DIGITS = 50


def force(x, v, t):
    return G + B * t - K * x - C * v


def decimal(q):
    with localcontext() as context:
        context.prec = DIGITS
        return str(Decimal(q.numerator) / Decimal(q.denominator))


def text(folder):
    blocks = []
    for path in sorted(folder.rglob("*.integrator"), key=lambda p: p.stem):
        if path.parent.name == "engines":
            continue
        integrator = Integrator(path.read_text(encoding="utf-8"))
        read = run(integrator, parameters(integrator, {}), force, H, X, V, T, 3)
        blocks.append("".join([f"{integrator.name}\n", *(f"  {decimal(x)} {decimal(v)}\n" for x, v in read)]))
    return "".join(blocks)


def main():
    folder, file = map(Path, sys.argv[1:3])
    found = text(folder)
    if sys.argv[3:] == ["--write"]:
        file.write_text(found, encoding="utf-8")
    elif file.read_text(encoding="utf-8") != found:
        print(f"{file} does not hold what the integrators do: spring_steps.py {folder} {file} --write writes it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
