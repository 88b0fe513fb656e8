# SPDX-License-Identifier: GPL-3.0-or-later
"""What the literature says of pairs of methods, exactly: which are one map, and which are each other's adjoint; see
catalogue.py."""

from fractions import Fraction

from claims import some
from interpreter import execute, parameters, run

IMPLICIT_EULER = """integrator implicit-euler-as-a-tableau
tableau
  1 | 1
  b | 1
"""

SAME = [  # (one, its parameters, other, its parameters, also with damping?)
    ("implicit-euler", {}, "implicit-euler-as-a-tableau", {}, True),
    ("newmark", {}, "trapezoidal", {}, True),
    ("newmark", {"beta": 0}, "velocity-verlet", {}, False),
    ("generalised-alpha", {"alpha_m": 0, "alpha_f": 0, "beta": Fraction(1, 6), "gamma": Fraction(2, 3)},
     "newmark", {"beta": Fraction(1, 6), "gamma": Fraction(2, 3)}, True),
    ("stoermer-verlet", {}, "velocity-verlet", {}, False),
    ("leapfrog", {}, "velocity-verlet", {}, False),
]

ADJOINT = [  # a step of the one, then a step of -h of the other, leads back
    ("explicit-euler", "implicit-euler", True), ("symplectic-euler", "symplectic-euler-drift-kick", False),
    ("implicit-midpoint", "implicit-midpoint", True), ("trapezoidal", "trapezoidal", True),
    ("velocity-verlet", "velocity-verlet", False), ("position-verlet", "position-verlet", False),
]


def check_kinship(catalogue, rng):
    """Yields a sentence for each relation that does not hold."""
    def spring(damping):
        k, c, p, q = (abs(some(rng)) for _ in range(4))
        return lambda x, v, t: -k * x - c * damping * v + p + q * t * t

    def trajectory(name, chosen, force, v=None, h=None, start=None):
        integrator = catalogue[name]
        chosen = {key: Fraction(number) for key, number in chosen.items()}
        start = start or (h, Fraction(3, 7), v, Fraction(2, 5), 5)
        return run(integrator, parameters(integrator, chosen), force, *start)

    for one, p, other, q, damping in SAME:
        force, h, v = spring(damping), Fraction(rng.randint(1, 9), 10), some(rng)
        if trajectory(one, p, force, v, h) != trajectory(other, q, force, v, h):
            yield f"{one} {p or ''} and {other} {q or ''} are not the same map"
    for one, other, damping in ADJOINT:
        for first, second in ((one, other), (other, one)):
            force, h, x, v, t = spring(damping), Fraction(rng.randint(1, 9), 10), some(rng), some(rng), some(rng)
            there = trajectory(first, {}, force, start=(h, x, v, t, 1))[0]
            if trajectory(second, {}, force, start=(-h, *there, t + h, 1))[0] != (x, v):
                yield f"{second} is not the adjoint of {first}"
    # Without its half step of acceleration Verlet has the positions of symplectic Euler.
    force, h, v = spring(False), Fraction(1, 3), some(rng)
    wrong, euler = (trajectory(name, {}, force, v, h) for name in ("stoermer-verlet-wrong-start", "symplectic-euler"))
    if [x for x, _ in wrong] != [x for x, _ in euler]:
        yield "stoermer-verlet-wrong-start has not the positions of symplectic-euler"
    # The spectrum of generalised-alpha for an infinitely stiff spring is -rho, three times (Chung & Hulbert 1993).
    integrator = catalogue["generalised-alpha"]
    for rho in (None, Fraction(0), Fraction(1, 3), Fraction(1)):
        params = parameters(integrator, {} if rho is None else {"rho": rho})
        stiff = Fraction(10) ** 12
        columns = []
        for x, v, a0 in ((1, 0, 0), (0, 1, 0), (0, 0, stiff)):
            env = {**params, "one": Fraction(1), "h": Fraction(1), "t": Fraction(0),
                   "x": Fraction(x), "v": Fraction(v), "a0": Fraction(a0)}
            execute(integrator.step, env, lambda x, v, t: -stiff * x)
            columns.append((env["x"], env["v"], env["a0"] / stiff))
        (a, d, g), (b, e, h), (c, f, i) = columns
        r = params["rho"]
        found = (a + e + i, a * e - b * d + a * i - c * g + e * i - f * h,
                 a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g))
        if any(abs(p - q) > Fraction(1, 10 ** 6) for p, q in zip(found, (-3 * r, 3 * r * r, -r ** 3))):
            yield f"generalised-alpha with rho = {r} damps by {[float(p) for p in found]}, not by rho"
