# SPDX-License-Identifier: GPL-3.0-or-later
"""An interpreter of .integrator files for one particle on a line, exactly with fractions or with floats. It shares
nothing with the library; see catalogue.py."""

from fractions import Fraction

from language import Bad


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
    left, right = value(e[1], env, force), value(e[2], env, force)
    if kind in "+-":
        return left + right if kind == "+" else left - right
    return left * right if kind == "*" else left / right


def solution(update, guess):
    """The unknowns with update(unknowns) = unknowns: by elimination for fractions, where the force must be linear in
    x and v; by iteration to the last digits for floats, where the step must be small."""
    if not isinstance(guess[0], Fraction):
        for _ in range(300):
            new = update(guess)
            if all(abs(n - o) <= 4e-16 * (1 + abs(n)) for n, o in zip(new, guess)):
                return new
            guess = new
        raise Bad("an implicit stage does not settle")
    size = len(guess)
    origin = update([Fraction(0)] * size)
    columns = [update([Fraction(i == j) for i in range(size)]) for j in range(size)]
    rows = [[(i == j) - columns[j][i] + origin[i] for j in range(size)] + [origin[i]] for i in range(size)]
    for i in range(size):
        pivot = next((k for k in range(i, size) if rows[k][i]), None)
        if pivot is None:
            raise Bad("an implicit stage has no unique solution")
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [entry / rows[i][i] for entry in rows[i]]
        for k in range(size):
            if k != i and rows[k][i]:
                rows[k] = [p - rows[k][i] * q for p, q in zip(rows[k], rows[i])]
    found = [row[size] for row in rows]
    if update(found) != found:
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


def run(integrator, params, force, h, x0, v0, t0, steps):
    """The positions and velocities read out after 1..steps steps."""
    one = Fraction(1) if isinstance(h, Fraction) else 1.0
    env = {**params, "one": one, "h": h, "t": t0, "x": x0, "v": v0}
    execute(integrator.start, env, force)
    carried = {"one", "h", "x", "v", *params, *integrator.states}
    read = []
    for n in range(steps):
        env = {name: env[name] for name in carried} | {"t": t0 + n * h}
        if integrator.tableau:
            tableau_step(integrator.tableau, env, force)
        else:
            execute(integrator.step, env, force)
        shown = {name: env[name] for name in carried} | {"t": t0 + (n + 1) * h}
        execute(integrator.finish, shown, force)
        read.append((shown["x"], shown["v"]))
    return read


def parameters(integrator, chosen, number=Fraction):
    """All parameters: the chosen ones, and the defaults of the others."""
    env = {"one": number(1)}
    for name, (_, default) in integrator.params.items():
        env[name] = chosen[name] if name in chosen else value(default, env, None)
    return {name: env[name] for name in integrator.params}
