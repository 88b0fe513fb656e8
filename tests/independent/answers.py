#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command answers about the catalogue, held against the second implementation (interpreter.py).

  correct    every option that exists, under forces of degree 0 to 2 in t: applied to the steps of the interpreter, in
             fractions, position and velocity are exact after 1..7 steps; of `force alone` that does not exist under a
             constant force: none that makes one frame right makes the others right
  stability  inside every window the steps of a spring stay bounded, just outside they grow
  order      what the literature says of the method (orders.py)

    tests/independent/answers.py SHORTFALL FOLDER
"""

import json
import math
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
from claims import pair, parameter_sets, same, some, tolerance  # noqa: E402
from expressions import Bad, whole  # noqa: E402
from interpreter import parameters, run, value  # noqa: E402
from language import Integrator  # noqa: E402
from orders import ORDER  # noqa: E402

STEPS = 7


def answer(shortfall, *words):
    """The JSON of a command; none where it says that there is no answer (exit code 4)."""
    said = subprocess.run([shortfall, *words, "--json"], capture_output=True, text=True, timeout=120)
    if said.returncode not in (0, 4):
        raise Bad(f"{' '.join(words)} ended with {said.returncode}: {said.stderr.strip()}")
    return json.loads(said.stdout) if said.stdout.strip().startswith("{") else None


# --- Corrections -----------------------------------------------------------------------------------------------------

def corrected(integrator, params, corrections, f, h, x0, v0, steps):
    """The frames of a motion to which the corrections are applied."""
    letters = {"a": f[0], **{f"f{k}": c for k, c in enumerate(f)}}
    adds = [(c["kind"], c["target"], whole(c["add"])) for c in corrections]
    fixed = {**params, "one": Fraction(1), "h": h, **letters}

    def added(kind, targets, env):
        return sum((value(add, {**fixed, **env}, None) for k, target, add in adds if k == kind and target in targets), Fraction(0))

    def force(x, v, t):
        return sum(c * t ** k for k, c in enumerate(f)) + added("force", ("a", "f"), {"t": t, "x0": x0, "v0": v0})

    start = {"x0": x0, "v0": v0, "t": Fraction(0)}
    x, v = x0 + added("launch", ("x0",), start), v0 + added("launch", ("v0",), start)

    def term(t):
        env = {"t": t, "x0": x0, "v0": v0}
        return added("term", ("x",), env), added("term", ("v",), env)

    frames = []
    for n, (p, q) in enumerate(run(integrator, params, force, h, x, v, Fraction(0), steps, term), 1):
        env = {"t": n * h, "n": Fraction(n), "x": p, "x0": x0, "v0": v0}
        q += added("read-out", ("v",), {**env, "v": q})
        frames.append((p + added("read-out", ("x",), {**env, "v": q}), q))  # by the corrected velocity
    return frames


def true_motion(f, x0, v0, t):
    return (x0 + v0 * t + sum(c * t ** (k + 2) / ((k + 1) * (k + 2)) for k, c in enumerate(f)),
            v0 + sum(c * t ** (k + 1) / (k + 1) for k, c in enumerate(f)))


def check_corrections(shortfall, path, integrator, rng):
    applied = 0
    for degree in range(3):
        kit = answer(shortfall, "correct", str(path), "--force", f"poly:{degree}" if degree else "constant")
        if kit is None:
            continue
        allowed = tolerance(integrator)
        for option in kit["options"]:
            for params in parameter_sets(integrator, rng)[:2]:
                h, x0, v0 = abs(some(rng)), some(rng), some(rng)
                f = [some(rng) for _ in range(degree + 1)]
                size = (1 + abs(x0) + abs(v0) + sum(map(abs, f))) * (1 + STEPS * h) ** (degree + 2)
                if not option["exists"]:
                    if degree == 0 and option["name"] == "force alone" and not integrator.approximations:
                        check_no_force(integrator, params, f[0], h, x0, v0, size, allowed)
                    continue
                if not all(c["exact"] for c in option["corrections"]):
                    continue
                frames = corrected(integrator, params, option["corrections"], f, h, x0, v0, STEPS)
                for n, found in enumerate(frames, 1):
                    for what, p, q in zip(("position", "velocity"), found, true_motion(f, x0, v0, n * h)):
                        if not same(p, q, size, allowed):
                            raise Bad(f"degree {degree}, {option['name']}: the {what} is off by {float(p - q)} after {n} steps")
                applied += 1
    return applied


def check_no_force(integrator, params, a, h, x0, v0, size, allowed):
    """A motion is affine in what is added to a constant force: the first position gives the only candidate."""
    def frames(add):
        return run(integrator, params, lambda x, v, t: a + add, h, x0, v0, Fraction(0), STEPS)

    plain, pushed = frames(Fraction(0)), frames(Fraction(1))
    n = STEPS - 1
    slope = pushed[n][0] - plain[n][0]
    if not slope:
        return
    add = (true_motion([a], x0, v0, STEPS * h)[0] - plain[n][0]) / slope
    if all(same(p, q, size, allowed) for n, found in enumerate(frames(add), 1)
           for p, q in zip(found, true_motion([a], x0, v0, n * h))):
        raise Bad(f"'force alone' is said not to exist, but {float(add)} added to the force makes every frame right")


# --- Stability -------------------------------------------------------------------------------------------------------

def grows(integrator, params, z):
    """Whether the steps of a spring with h w = z run away, by floats."""
    try:
        if integrator.states and "determinant" not in integrator.claims:
            raise Bad("two readings do not say what the next will be")
        trace, determinant = pair(integrator, params, 1.0, z * z)
    except Bad:
        small = 1e-9  # below the speed at which an engine would limit it
        x, v = run(integrator, params, lambda x, v, t: -z * z * x, 1.0, small, small * z, 0.0, 5000)[-1]
        return not abs(x) + abs(v / z) < 1e3 * small
    root = math.sqrt(abs(trace * trace / 4 - determinant))
    largest = abs(trace) / 2 + root if trace * trace / 4 >= determinant else math.sqrt(abs(determinant))
    return largest > 1 + 1e-9


def check_windows(shortfall, path, integrator):
    told = answer(shortfall, "stability", str(path))
    if told is None or "windows" not in told:
        return 0
    params = {name: float(q) for name, q in parameters(integrator, {}).items()}
    windows = []
    for w in told["windows"]:
        windows.append((float(w["from"]["decimal"]) if w["from"] else 0.0, float(w["to"]["decimal"]) if w["to"] else math.inf))
    for low, high in windows:
        top = min(high, low + 50)
        if top - low < 1e-3:
            continue
        for share in (0.07, 0.31, 0.5, 0.77, 0.97):
            z = low + share * (top - low)
            if grows(integrator, params, z):
                raise Bad(f"stability: it grows at h w = {z}, inside of the window from {low} to {high}")
    ends = [high for _, high in windows if high < math.inf]
    for z in ends or ([] if windows else [0.3]):
        outside = z * (1 + 1e-3) if ends else z
        if not any(low <= outside <= high for low, high in windows) and not grows(integrator, params, outside):
            raise Bad(f"stability: it does not grow at h w = {outside}, outside of every window")
    return 1


# --- Order -----------------------------------------------------------------------------------------------------------

def check_order(shortfall, path, integrator):
    if integrator.name not in ORDER:
        return 0
    told = answer(shortfall, "order", str(path))
    if told is None:
        return 0
    for forces, order in zip(("velocity_independent", "general"), ORDER[integrator.name]):
        if told["classes"].get(forces, order) != order:
            raise Bad(f"order: {told['classes'][forces]} for {forces} forces, where the literature has {order}")
    return 1


def main(arguments):
    shortfall, folder = arguments[0], Path(arguments[1])
    rng = random.Random(20260901)
    failed, files, counts = 0, 0, [0, 0, 0]
    for path in sorted(folder.rglob("*.integrator")):
        integrator = Integrator(path.read_text(encoding="utf-8"))
        files += 1
        try:
            if not (integrator.impulse or integrator.solves or integrator.hold):
                counts[0] += check_corrections(shortfall, path, integrator, rng)
            if not integrator.hold:
                counts[1] += check_windows(shortfall, path, integrator)
            counts[2] += check_order(shortfall, path, integrator)
        except Bad as bad:
            failed += 1
            print(f"{path.name}: {bad}")
    print(f"{files} files: {counts[0]} corrections applied, {counts[1]} sets of windows and {counts[2]} orders compared; {failed} failed")
    # A folder without files, or a command that refuses everything, is no proof.
    return 1 if failed or counts[0] < 100 or counts[1] < 30 or counts[2] < 30 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
