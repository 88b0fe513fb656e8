# SPDX-License-Identifier: GPL-3.0-or-later
"""An interpreter of .integrator files for one particle on a line, exactly with fractions or with floats. It shares
nothing with the library; see catalogue.py."""

import math
from decimal import Decimal, localcontext
from fractions import Fraction

from expressions import Bad

DIGITS = 120  # to which irrational numbers are rounded where everything else is a fraction


def called(function, arguments):
    """sqrt, exp, log, pow, max, min; of fractions exactly where that is possible, else to DIGITS digits."""
    if function in ("max", "min"):
        return (max if function == "max" else min)(arguments)
    if not isinstance(arguments[0], Fraction):
        return getattr(math, function)(*arguments)
    with localcontext() as context:
        context.prec = DIGITS + 10
        first, *rest = [Decimal(q.numerator) / Decimal(q.denominator) for q in arguments]
        if function == "sqrt":
            q = arguments[0]
            p, r = math.isqrt(q.numerator), math.isqrt(q.denominator)
            exact = p * p == q.numerator and r * r == q.denominator
            return Fraction(p, r) if exact else Fraction(first.sqrt())
        if function == "exp":
            return Fraction(first.exp())
        if function == "log":
            return Fraction(first.ln())
        if arguments[1].denominator == 1:
            return arguments[0] ** int(arguments[1])
        return Fraction((first.ln() * rest[0]).exp()) if first else Fraction(0)


def polynomial(e, name):
    """The coefficients of an expression in one name, lowest first."""
    kind = e[0]
    if kind == "num":
        return [e[1]]
    if kind == "name" and e[1] == name:
        return [Fraction(0), Fraction(1)]
    if kind == "neg":
        return [-c for c in polynomial(e[1], name)]
    if kind in ("^", "*"):
        left = polynomial(e[1], name)
        factors = [left] * e[2] if kind == "^" else [left, polynomial(e[2], name)]
        result = [Fraction(1)]
        for factor in factors:
            product = [Fraction(0)] * (len(result) + len(factor) - 1)
            for i, p in enumerate(result):
                for j, q in enumerate(factor):
                    product[i + j] += p * q
            result = product
        return result
    if kind in ("+", "-"):
        left, right = polynomial(e[1], name), polynomial(e[2], name)
        size, sign = max(len(left), len(right)), 1 if kind == "+" else -1
        left, right = (side + [Fraction(0)] * (size - len(side)) for side in (left, right))
        return [p + sign * q for p, q in zip(left, right)]
    if kind == "/":
        right = polynomial(e[2], name)
        if len(right) == 1 and right[0]:
            return [c / right[0] for c in polynomial(e[1], name)]
    raise Bad("a root solves a polynomial")


def root(left, right, name, near):
    """The real solution of left = right nearest to `near`, to DIGITS digits, with the sign change that proves it."""
    c = polynomial(("-", left, right), name)
    while c and not c[-1]:
        c.pop()
    guesses = [(0.4 + 0.9j) ** k * (1 + max(abs(float(q / c[-1])) for q in c)) for k in range(len(c) - 1)]

    def at(x):
        total = 0 * x
        for q in reversed(c):
            total = total * x + (q if isinstance(x, Fraction) else float(q))
        return total

    for _ in range(500):  # Durand and Kerner: all roots at once
        for i, z in enumerate(guesses):
            divisor = float(c[-1]) * math.prod(z - other for j, other in enumerate(guesses) if j != i)
            guesses[i] = z - at(z) / divisor
    real = [z.real for z in guesses if abs(z.imag) < 1e-9 * (1 + abs(z))]
    if not real or (near is None and len(real) > 1):
        raise Bad(f"the root {name} is not one number")
    x = Fraction(min(real, key=lambda r: abs(r - float(near or 0))))
    slope = [k * q for k, q in enumerate(c)][1:]
    for _ in range(9):  # Newton doubles the digits
        x -= at(x) / sum(q * x ** k for k, q in enumerate(slope))
        x = Fraction(round(x * 10 ** DIGITS), 10 ** DIGITS)
    width = Fraction(2, 10 ** DIGITS)
    if at(x - width) * at(x + width) >= 0:
        raise Bad(f"the root {name} has not been found")
    return x


def value(e, env, force):
    kind = e[0]
    if kind == "num":
        return e[1] if isinstance(env["one"], Fraction) else float(e[1])
    if kind == "name":
        return env[e[1]]
    if kind == "neg":
        return -value(e[1], env, force)
    if kind == "^":
        return value(e[1], env, force) ** e[2]
    if kind == "force":
        return force(*(value(argument, env, force) for argument in e[1:]))
    if kind == "call":
        return called(e[1], [value(argument, env, force) for argument in e[2]])
    left, right = value(e[1], env, force), value(e[2], env, force)
    if kind in "+-":
        return left + right if kind == "+" else left - right
    return left * right if kind == "*" else left / right


def solution(update, guess):
    """The unknowns with update(unknowns) = unknowns: by elimination, where the force must be linear in x and v; for
    floats by iteration to the last digits, if that settles."""
    exact = isinstance(guess[0], Fraction)
    if not exact:
        old = guess
        for k in range(100):
            new = update(old)
            change = max(abs(n - o) / (1 + abs(n)) for n, o in zip(new, old))
            if change <= 4e-16:
                return new
            if k > 6 and not change < 0.5:
                break
            old = new
    number, size = type(guess[0]), len(guess)
    origin = update([number(0)] * size)
    columns = [update([number(i == j) for i in range(size)]) for j in range(size)]
    rows = [[(i == j) - columns[j][i] + origin[i] for j in range(size)] + [origin[i]] for i in range(size)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda k: abs(rows[k][i]))
        if not rows[pivot][i]:
            raise Bad("an implicit stage has no unique solution")
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [entry / rows[i][i] for entry in rows[i]]
        for k in range(size):
            if k != i and rows[k][i]:
                rows[k] = [p - rows[k][i] * q for p, q in zip(rows[k], rows[i])]
    found = [row[size] for row in rows]
    if not all(n == o if exact else abs(n - o) <= 1e-6 * (1 + abs(n)) for n, o in zip(update(found), found)):
        raise Bad("the force is not linear, so an implicit stage cannot be solved exactly")
    return found


def execute(body, env, force):
    for statement in body:
        if statement[0] == "set":
            env[statement[1]] = value(statement[2], env, force)
        elif statement[0] == "solve":
            names = [name for name, _, _ in statement[1]]

            def update(unknowns):
                inner = {**env, **dict(zip(names, unknowns))}
                return [value(expression, inner, force) for _, _, expression in statement[1]]

            env.update(zip(names, solution(update, [0 * env["one"]] * len(names))))
        elif statement[0] == "limit":
            length = abs(env["v"]) if statement[1] == "speed" else abs(env["h"] * env["v"])
            most = value(statement[2], env, force)
            if length > most:
                env["v"] = most / length * env["v"]
        elif statement[0] == "when":
            if abs(env["v"]) > value(statement[1], env, force):
                before = set(env)
                execute(statement[2], env, force)
                for name in set(env) - before:
                    del env[name]
        else:
            count = int(value(statement[1], env, force))
            whole_h, begin = env["h"], env["t"]
            env["h"] = whole_h / count
            for k in range(count):
                env["t"] = begin + k * env["h"]
                execute(statement[2], env, force)
            env["h"], env["t"] = whole_h, begin + whole_h


def tableau_step(tableau, env, force):
    rows, weights = tableau
    number = {key: [value(entry, env, force) for entry in entries] for key, entries in weights.items()}
    c = [value(left, env, force) for left, _ in rows]
    a = [[value(entry, env, force) for entry in entries] for _, entries in rows]
    h, t, x, v = env["h"], env["t"], env["x"], env["v"]

    def update(flat):
        velocity, acceleration, new = flat[0::2], flat[1::2], []
        for i in range(len(rows)):
            x_i = x + h * sum(p * q for p, q in zip(a[i], velocity))
            v_i = v + h * sum(p * q for p, q in zip(a[i], acceleration))
            new += [v_i, force(x_i, v_i, t + c[i] * h)]
        return new

    flat = solution(update, [v, 0 * env["one"]] * len(rows))
    env["x"] = x + h * sum(p * q for p, q in zip(number["b"], flat[0::2]))
    env["v"] = v + h * sum(p * q for p, q in zip(number["b"], flat[1::2]))


def run(integrator, params, force, h, x0, v0, t0, steps, term=None):
    """The positions and velocities read out after 1..steps steps; term(t) is added to x and v at the end of the step
    that begins at t."""
    one = Fraction(1) if isinstance(h, Fraction) else 1.0
    env = {**params, "one": one, "h": h, "t": t0, "x": x0, "v": v0}
    execute(integrator.start, env, force)
    carried = {"one", "h", "x", "v", *params, *integrator.states}
    read = []
    given = force
    for n in range(steps):
        env = {name: env[name] for name in carried} | {"t": t0 + n * h}
        if integrator.impulse:
            env[integrator.impulse] = 0 * env["v"]
        if integrator.hold:  # one evaluation a step, whatever stands in the parentheses
            held = given(env["x"], env["v"], env["t"])
            force = lambda *_, held=held: held  # noqa: E731
        if integrator.tableau:
            tableau_step(integrator.tableau, env, force)
        else:
            execute(integrator.step, env, force)
        if term:
            env["x"], env["v"] = (q + more for q, more in zip((env["x"], env["v"]), term(t0 + n * h)))
        force = given
        shown = {name: env[name] for name in carried} | {"t": t0 + (n + 1) * h}
        execute(integrator.finish, shown, force)
        read.append((shown["x"], shown["v"]))
    return read


def parameters(integrator, chosen, number=Fraction):
    """All parameters: the chosen ones, and the defaults of the others."""
    env = {"one": number(1)}
    for name, (_, default) in integrator.params.items():
        env[name] = chosen[name] if name in chosen else value(default, env, None)
    constants = {name: root(left, right, name, near) for name, (left, right, near) in integrator.roots.items()}
    constants |= {name: Fraction(decimal) for name, decimal in integrator.approximations.items()}
    return {name: env[name] for name in integrator.params} | constants
