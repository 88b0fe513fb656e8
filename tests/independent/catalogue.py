#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A second, independent implementation of the .integrator language, which checks every claim of the catalogue.

It shares nothing with the library: its own reader and interpreter (language.py, interpreter.py), the standard library
only. Every file is stepped exactly, with fractions.Fraction, for accelerations that are polynomials in t with random
coefficients, from random starting values, and its `expect` lines are compared:

  exact D             equal for every degree up to D, different for degree D + 1
  shortfall E         equal after n = 1..6 steps, for three sets of parameters
  shortfall-velocity  the same
  trace, determinant  equal, of the pair of readings after two and three steps, for a spring with random h, w, parameters
  limit               bounded steps below it and unbounded ones just above it, with floats

Irrational coefficients and functions (root, sqrt, exp, pow, log) are fractions of 120 digits, found by Newton's method or
the decimal module: their files are compared to 60 digits, and the line says so. Files with `approx` coefficients are
compared to the digits printed, less two.

Besides that each file is held against what the literature says of the method: the order seen when the step is halved
for an anharmonic, non-autonomous force, without and with a dependence on the velocity; for tableaus the order
conditions of all rooted trees, exactly; which methods are the same map, and which are each other's adjoint, exactly
for a damped and driven spring. One line a file; the exit code is 1 if anything failed.

    tests/independent/catalogue.py [--seed N] [FILE or FOLDER ...]
"""
import random
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from claims import check_claims  # noqa: E402
from expressions import Bad  # noqa: E402
from kinship import IMPLICIT_EULER, check_kinship  # noqa: E402
from language import Integrator  # noqa: E402
from orders import ORDER, check_order  # noqa: E402

ENGINES = "engines"  # the folder of loops of programs: nobody published an order for them

CONTROLS = [  # (what it shows, the file, whether it must hold)
    ("four substeps divide the shortfall by four", """integrator control
step
  substeps 4 {
    v = v + h*a(x, v, t)
    x = x + h*v
  }
expect
  shortfall -a*h*t/8
  shortfall-velocity 0
""", True),
    ("a wrong sign is refuted", """integrator control
step
  v = v + h*a(x, v, t)
  x = x + h*v
expect
  shortfall a*h*t/2
  shortfall-velocity 0
""", False),
    ("a claim of too low a degree is refuted", """integrator control
tableau
  0   |
  1/2 | 1/2
  1   | -1 2
  b   | 1/6 2/3 1/6
expect
  exact 1
  shortfall 0
  shortfall-velocity 0
""", False),
    ("time that advances with the kick is refuted", """integrator control
step
  v = v + 7/24*h*a(x, v, t)
  x = x + 2/3*h*v
  v = v + 3/4*h*a(x, v, t + 7/24*h)
  x = x - 2/3*h*v
  v = v - 1/24*h*a(x, v, t + 25/24*h)
  x = x + h*v
expect
  exact 1
  shortfall 0
  shortfall-velocity 0
""", False),
    ("x + v is refused", """integrator control
step
  x = x + v
expect
  shortfall 0
  shortfall-velocity 0
""", False),
]


def main(arguments):
    seed = 1
    if arguments[:1] == ["--seed"]:
        seed, arguments = int(arguments[1]), arguments[2:]
    places = [Path(place) for place in arguments] or [Path(__file__).resolve().parents[2] / "integrators"]
    files = sorted(file for place in places for file in (place.rglob("*.integrator") if place.is_dir() else [place]))
    failed = 0
    for what, text, holds in CONTROLS:
        try:
            check_claims(Integrator(text), random.Random(seed))
            found = True
        except Bad:
            found = False
        if found != holds:
            failed += 1
            print(f"FAILED  control: {what}")
    names, catalogue = {}, {"implicit-euler-as-a-tableau": Integrator(IMPLICIT_EULER)}
    for file in files:
        try:
            text = file.read_text(encoding="utf-8")
            integrator = Integrator(text)
            if integrator.name != file.stem:
                raise Bad(f"the file is named {file.stem}, the integrator {integrator.name}")
            if not (integrator.about and integrator.sources):
                raise Bad("a description and a source are wanted")
            for name in (integrator.name, *integrator.aliases):
                key = re.sub(r"[\s_-]+", "-", name.lower())
                if key in names:
                    raise Bad(f"'{name}' also names {names[key]}")
                names[key] = integrator.name
            check_claims(integrator, random.Random(f"{seed} {integrator.name}"))
            how = "to the digits printed" if integrator.approximations else \
                "to 60 digits" if integrator.irrational else "exactly"
            if file.parent.name == ENGINES:
                print(f"ok      {integrator.name:28} trace and determinant, {how}")
                continue
            seen = check_order(integrator)
            catalogue[integrator.name] = integrator
            lines = dict(re.findall(r"^ *(exact|shortfall|shortfall-velocity) +(.*)$", text, re.M))
            print(f"ok      {integrator.name:28} exact {lines.get('exact', '-'):2} shortfall {lines['shortfall']:9} "
                  f"velocity {lines['shortfall-velocity']:7} order {seen[0]:.2f}, with velocity {seen[1]:.2f}, {how}")
        except (Bad, OSError, ValueError, KeyError, ZeroDivisionError) as problem:
            failed += 1
            print(f"FAILED  {file}: {problem}")
    if set(ORDER) <= set(catalogue):
        for problem in check_kinship(catalogue, random.Random(seed)):
            failed += 1
            print(f"FAILED  {problem}")
    if not files:
        print("FAILED  no .integrator file found")
        failed += 1
    print(f"{len(files)} files, {failed} failures")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
