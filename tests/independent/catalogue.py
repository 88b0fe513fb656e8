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

import math
import random
import re
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
from interpreter import execute, parameters, run, value  # noqa: E402
from language import Bad, Integrator  # noqa: E402

# The classical order for x'' = a(x, t) and for x'' = a(x, v, t). It comes from the literature, not from the program.
ORDER = {
    "explicit-euler": (1, 1), "symplectic-euler": (1, 1), "symplectic-euler-drift-kick": (1, 1),
    "implicit-euler": (1, 1), "half-gravity": (1, 1),
    "velocity-verlet": (2, 2), "position-verlet": (2, 1), "stoermer-verlet": (2, 1),
    "stoermer-verlet-wrong-start": (1, 1), "leapfrog": (2, 1), "beeman": (2, 2),
    "midpoint": (2, 2), "heun": (2, 2), "ralston": (2, 2), "kutta3": (3, 3), "rk4": (4, 4), "rk38": (4, 4),
    "bogacki-shampine": (3, 3), "dormand-prince": (5, 5), "implicit-midpoint": (2, 2), "trapezoidal": (2, 2),
    "radau-iia-3": (3, 3), "sdirk4": (4, 4),
    "adams-bashforth-2": (2, 2), "ruth3": (3, 1), "newmark": (2, 2), "generalised-alpha": (2, 2),
    "gauss4": (4, 4), "gauss6": (6, 6), "radau-iia-5": (5, 5), "sdirk2": (2, 2),
    "forest-ruth": (4, 1), "yoshida4": (4, 1), "yoshida6": (6, 1), "pefrl": (4, 1), "suzuki4": (4, 1),
    "mclachlan-atela-2": (2, 1), "mclachlan-atela-3": (3, 1), "mclachlan-atela-4": (4, 1),
    "mclachlan-s2": (2, 1), "mclachlan-s4": (4, 1), "mclachlan-s5": (4, 1), "mclachlan-sb3a": (4, 1),
    "blanes-moan-s6": (4, 1), "blanes-moan-s10": (6, 1), "blanes-moan-rkn6": (4, 1), "blanes-moan-rkn11": (6, 1),
    "blanes-moan-rkn14": (6, 1),
}
ENGINES = "engines"  # the folder of loops of programs: nobody published an order for them
EMBEDDED_ORDER = {"bogacki-shampine": 2, "dormand-prince": 4, "sdirk4": 3}


# --- Claims ----------------------------------------------------------------------------------------------------------

def tolerance(integrator):
    """What a difference may be, compared with what is subtracted: 0 where all coefficients are rational."""
    if integrator.approximations:
        digits = min(len(decimal.partition(".")[2]) for decimal in integrator.approximations.values())
        return Fraction(1, 10 ** (digits - 2))
    return Fraction(1, 10 ** 60) if integrator.irrational else Fraction(0)


def same(a, b, size, allowed):
    return a == b if not allowed else abs(a - b) <= allowed * size


def some(rng):
    return Fraction(rng.randint(1, 40), rng.randint(3, 30)) * rng.choice((-1, 1))


def parameter_sets(integrator, rng):
    """The defaults; the first parameter at random, the rest derived from it; all at random. How often something is
    done and from where on a limit acts keep their defaults."""
    def kept(body):
        for statement in body or []:
            if statement[0] in ("substeps", "when"):
                yield statement[1]
                yield from kept(statement[2])
            elif statement[0] == "limit":
                yield statement[2]

    fixed = {e[1] for e in kept(integrator.step) if e[0] == "name"}
    names = [name for name in integrator.params if name not in fixed]
    sets = [[], names[:1], names]
    return [parameters(integrator, {name: Fraction(rng.randint(1, 30), 31) for name in names}) for names in sets]


def exact_to(integrator, params, degree, rng):
    """Whether x and v are exact for a random acceleration of this degree in t."""
    f = [some(rng) for _ in range(degree + 1)]
    h, x0, v0, t0 = abs(some(rng)), some(rng), some(rng), some(rng)
    allowed = tolerance(integrator)
    if allowed:  # all terms of a like size, so that a difference is seen
        h, t0 = 1 + abs(some(rng)) / 50, abs(some(rng)) / 50

    def force(x, v, t):
        return sum(c * t ** k for k, c in enumerate(f))

    def velocity(t):
        return v0 + sum(c * (t ** (k + 1) - t0 ** (k + 1)) / (k + 1) for k, c in enumerate(f))

    def position(t):
        return x0 + v0 * (t - t0) + sum(
            c * ((t ** (k + 2) - t0 ** (k + 2)) / ((k + 1) * (k + 2)) - t0 ** (k + 1) * (t - t0) / (k + 1))
            for k, c in enumerate(f))

    read = run(integrator, params, force, h, x0, v0, t0, 6)
    times = [t0 + n * h for n in range(1, 7)]
    size = (1 + abs(x0) + abs(v0) + sum(map(abs, f))) * 7 ** (degree + 2)
    return all(same(x, position(t), size, allowed) and same(v, velocity(t), size, allowed)
               for (x, v), t in zip(read, times))


def check_claims(integrator, rng):
    claims = integrator.claims
    check_oscillator(integrator, rng)
    if integrator.impulse or integrator.solves:
        if "trace" not in claims or "determinant" not in claims or "shortfall" in claims:
            raise Bad("an engine claims its trace and determinant")
        return
    if "shortfall" not in claims or "shortfall-velocity" not in claims:
        raise Bad("both shortfall lines are wanted")
    exact = claims.get("exact", -1)
    for params in parameter_sets(integrator, rng):
        for degree in range(exact + 1):
            if not exact_to(integrator, params, degree, rng):
                raise Bad(f"exact {exact}: not exact for degree {degree}")
        if exact_to(integrator, params, exact + 1, rng):
            raise Bad(f"exact {exact}: still exact for degree {exact + 1}" if "exact" in claims
                      else "exact for a constant force, but does not claim it")
        h, x0, v0, a = abs(some(rng)), some(rng), some(rng), some(rng)
        read = run(integrator, params, lambda x, v, t: a, h, x0, v0, Fraction(0), 6)
        for n, (x, v) in enumerate(read, 1):
            t = n * h
            env = {**params, "one": Fraction(1), "a": a, "x0": x0, "v0": v0, "h": h, "n": Fraction(n), "t": t}
            for word, found in (("shortfall", x0 + v0 * t + a * t * t / 2 - x), ("shortfall-velocity", v0 + a * t - v)):
                size = 1 + abs(x0) + abs(v0 * t) + abs(a * t * t)
                if not same(found, value(claims[word], env, None), size, tolerance(integrator)):
                    raise Bad(f"{word}: {found} after {n} steps, where {value(claims[word], env, None)} is claimed")


def pair(integrator, params, h, stiffness):
    """The map that takes the reading after two steps of x'' = -stiffness x to that after three: trace, determinant."""
    number = type(h)
    starts = ((number(1), number(0)), (number(0), number(1)))
    (p, q), (r, s) = [run(integrator, params, lambda x, v, t: -stiffness * x, h, x, v, 0 * h, 3)[1:] for x, v in starts]
    (a, c), (b, d) = p, r      # the columns after two steps
    (e, g), (f, i) = q, s      # and after three
    det = a * d - b * c
    if abs(det) < 1e-30:
        raise Bad("the readings after two steps are not independent")
    return (e * d - f * c - g * b + i * a) / det, (e * i - f * g) / det


def check_oscillator(integrator, rng):
    claims = integrator.claims
    for params in parameter_sets(integrator, rng) if "trace" in claims or "determinant" in claims else ():
        h, w = Fraction(rng.randint(1, 30), 31), Fraction(rng.randint(1, 30), 31)
        env = {**params, "one": Fraction(1), "h": h, "w": w, "z": h * w, "t": Fraction(0)}
        while any(value(difference, env, None) <= 0 for difference in integrator.assumptions):
            h /= 2  # what is assumed holds for short steps
            env |= {"h": h, "z": h * w}
        found = dict(zip(("trace", "determinant"), pair(integrator, params, h, w * w)))
        for word in found:
            if word in claims and not same(found[word], value(claims[word], env, None), 10, tolerance(integrator)):
                raise Bad(f"{word}: {float(found[word])}, where {float(value(claims[word], env, None))} is claimed")
    if "limit" in claims:
        check_limit(integrator)


def grows(integrator, params, z):
    """Whether a step of the oscillator with h w = z has an eigenvalue outside the unit circle."""
    if not integrator.states or "determinant" in integrator.claims:
        trace, determinant = pair(integrator, params, 1.0, z * z)
        rounding = 1e-9 if integrator.claims["limit"] == ("name", "infinity") else 1e-12
        return abs(determinant) > 1 + rounding or abs(trace) > 1 + determinant + rounding
    steps = 200 if any(statement[0] == "solve" for statement in integrator.step) else 4000
    x, v = run(integrator, params, lambda x, v, t: -z * z * x, 1.0, 1.0, z, 0.0, steps)[-1]
    return abs(x) + abs(v / z) > 1e3


def check_limit(integrator):
    params = {name: float(q) for name, q in parameters(integrator, {}).items()}
    claim = integrator.claims["limit"]
    infinite = claim == ("name", "infinity")
    limit = 100.0 if infinite else float(value(claim, {"one": Fraction(1)}, None))
    implicit = integrator.tableau or any(statement[0] == "solve" for statement in integrator.step)
    coarse = 12 if implicit or not {"trace", "determinant"} & set(integrator.claims) else 200
    for k in range(1, coarse):
        if limit and grows(integrator, params, limit * k / coarse):
            raise Bad(f"limit: unstable at {limit * k / coarse}")
    if not infinite and not grows(integrator, params, limit * (1 + 1e-6) if limit else 0.3):
        raise Bad("limit: stable just above it")


# --- Order -----------------------------------------------------------------------------------------------------------

def without_velocity(x, v, t):
    return math.cos(2 * t) - math.sin(x) - 0.4 * x * x + 0.3 * t * x


def with_velocity(x, v, t):
    return without_velocity(x, v, t) - 0.5 * v * abs(1 + 0.3 * v) + 0.2 * math.sin(x) * v


def reference(force, x, v, t, until, steps=4000):
    """Runge-Kutta-Nystroem by hand, with a step so small that its error does not count."""
    h = (until - t) / steps
    for n in range(steps):
        s = t + n * h
        k1 = force(x, v, s)
        k2 = force(x + h / 2 * v + h * h / 8 * k1, v + h / 2 * k1, s + h / 2)
        k3 = force(x + h / 2 * v + h * h / 8 * k1, v + h / 2 * k2, s + h / 2)
        k4 = force(x + h * v + h * h / 2 * k3, v + h * k3, s + h)
        x, v = x + h * v + h * h / 6 * (k1 + k2 + k3), v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return x, v


TRUTH = {}


def observed_order(integrator, force):
    x0, v0, t0, until = 0.7, -0.4, 0.3, 1.8
    if force not in TRUTH:
        TRUTH[force] = reference(force, x0, v0, t0, until)
    params = {name: float(q) for name, q in parameters(integrator, {}).items()}
    errors = []
    coarse = 40 if ORDER[integrator.name][0] < 6 else 14  # floats have 16 digits
    for steps in (coarse, 2 * coarse):
        x, v = run(integrator, params, force, (until - t0) / steps, x0, v0, t0, steps)[-1]
        errors.append(math.hypot(x - TRUTH[force][0], v - TRUTH[force][1]))
    return math.log2(errors[0] / errors[1])


def trees(order):
    """All rooted trees of this order, each a sorted tuple of its branches."""
    def forests(total, largest):
        if total == 0:
            yield ()
            return
        for size in range(min(total, largest), 0, -1):
            for tree in trees(size):
                for rest in forests(total - size, size):
                    yield (tree, *rest)
    return {tuple(sorted(forest)) for forest in forests(order - 1, order - 1)}


def size(tree):
    return 1 + sum(map(size, tree))


def density(tree):
    return size(tree) * math.prod(map(density, tree))


def tableau_order(a, b, allowed):
    """The order by the conditions sum b_i phi_i(tree) = 1/gamma(tree), for general first-order systems."""
    def phi(tree):
        values = [Fraction(1)] * len(a)
        for branch in tree:
            inner = phi(branch)
            values = [value * sum(p * q for p, q in zip(row, inner)) for value, row in zip(values, a)]
        return values
    order = 0
    while all(same(sum(p * q for p, q in zip(b, phi(tree))), Fraction(1, density(tree)), 1, allowed)
              for tree in trees(order + 1)):
        order += 1
    return order


def check_order(integrator):
    if integrator.name not in ORDER:
        raise Bad("no order is known for it: add it to ORDER")
    wanted = ORDER[integrator.name]
    claims = integrator.series_claims
    claimed = claims.get(("order", ""))
    if (claims.get(("order", "a(x,t)"), claimed), claimed) != tuple(wanted):
        raise Bad(f"the orders claimed are {claims}, {wanted} are known")
    if claims.get(("embedded-order", "")) != EMBEDDED_ORDER.get(integrator.name):
        raise Bad("the embedded order claimed is not the one known")
    seen = [observed_order(integrator, force) for force in (without_velocity, with_velocity)]
    for p, q, what in zip(wanted, seen, ("a(x, t)", "a(x, v, t)")):
        if abs(p - q) > (0.2 if p < 6 else 0.35):
            raise Bad(f"order {q:.2f} seen for {what}, {p} expected")
    if integrator.tableau:
        env = {"one": Fraction(1), **parameters(integrator, {})}
        rows, weights = integrator.tableau
        c = [value(left, env, None) for left, _ in rows]
        a = [[value(entry, env, None) for entry in entries] for _, entries in rows]
        if not all(same(sum(row), node, 1, tolerance(integrator)) for row, node in zip(a, c)):
            raise Bad("a row of the tableau does not sum to its c")
        known = {"b": wanted[1], "embedded": EMBEDDED_ORDER.get(integrator.name)}
        for key, entries in weights.items():
            order = tableau_order(a, [value(entry, env, None) for entry in entries], tolerance(integrator))
            if order != known[key]:
                raise Bad(f"the weights {key} are of order {order}, {known[key]} expected")
    return seen


# --- Kinship: what the literature says of pairs of methods, exactly --------------------------------------------------

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


# --- The whole -------------------------------------------------------------------------------------------------------

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
