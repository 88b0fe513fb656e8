# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file of the catalogue claims of itself under `expect`, held against its own exact steps; see catalogue.py."""

from fractions import Fraction

from expressions import Bad
from interpreter import parameters, run, value


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
