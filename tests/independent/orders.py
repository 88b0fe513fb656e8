# SPDX-License-Identifier: GPL-3.0-or-later
"""The orders of the catalogue as the literature gives them, held against the order conditions and against what is seen
when the step is halved; see catalogue.py."""

import math
from fractions import Fraction

from claims import same, tolerance
from expressions import Bad
from interpreter import parameters, run, value
from rooted_trees import density, trees

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
EMBEDDED_ORDER = {"bogacki-shampine": 2, "dormand-prince": 4, "sdirk4": 3}


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
