# SPDX-License-Identifier: GPL-3.0-or-later
"""Random Runge-Kutta-like steps: what is derived of the traced function is what the function itself does in Fractions.

The very function that is traced is also called with Fractions, step by step, so that neither the tracing nor the
derivation can be wrong without a difference.
"""

import random
import unittest
from fractions import Fraction

import shortfall as sf


def random_step(r):
    """A step of random coefficients and stages, which may use what came before in every way."""
    stages = r.randint(1, 4)

    def weight():
        return Fraction(r.randint(-4, 4), r.choice((1, 2, 3, 5)))

    rows = [([weight() for _ in range(i)], [weight() for _ in range(i)], weight()) for i in range(stages)]
    last_x, last_v = [weight() for _ in range(stages)], [weight() for _ in range(stages)]
    in_new_velocity, spread, damp = r.random() < 0.5, r.choice((1, 2, 3)), r.choice((0, 0, Fraction(1, 4)))

    def step(x, v, t, a, h):
        k, l = [], []
        for of_x, of_v, c in rows:
            at, speed = x, v
            for w, ki in zip(of_x, k):
                at = at + h * w * ki
            for w, li in zip(of_v, l):
                speed = speed + w * (h * li)
            k.append(speed)
            l.append(a(at, speed, t + c * h) - damp * (at - x) / h**2)
        for _ in range(spread):
            v = v + h * sum(w * li for w, li in zip(last_v, l)) / spread
        slopes = [v] * len(k) if in_new_velocity else k
        return x + h * sum(w * ki for w, ki in zip(last_x, slopes)), v

    return step


def stepped(step, force, x, v, h, n):
    for i in range(n):
        x, v = step(x, v, i * h, force, h)
    return x, v


class RandomSteps(unittest.TestCase):
    def test_what_is_derived_of_a_traced_step_is_what_it_does(self):
        for seed in range(12):
            with self.subTest(seed=seed):
                r = random.Random(seed)
                step = random_step(r)
                letters = {name: Fraction(r.randint(-9, 9), r.randint(1, 7)) for name in ("x0", "v0", "f0", "f1")}
                h, n = Fraction(1, r.randint(2, 9)), r.randint(1, 5)

                def force(x, v, t):
                    return letters["f0"] + letters["f1"] * t

                x, v = stepped(step, force, letters["x0"], letters["v0"], h, n)
                # The motion of one that magnifies what it is given has no such formula; it is run with numbers below.
                try:
                    d = sf.derive(step, force="poly:1")
                except sf.NotDerivable:
                    continue
                if n < int(d.valid_from):
                    continue
                at = dict(letters, h=h, n=n, t=n * h)
                self.assertEqual(_value(d.position, at), x)
                self.assertEqual(_value(d.velocity, at), v)

    def test_under_a_damped_spring_with_numbers(self):
        for seed in range(12):
            with self.subTest(seed=seed):
                r = random.Random(1000 + seed)
                step = random_step(r)
                k, c = Fraction(r.randint(1, 5)), Fraction(1, r.randint(2, 4))
                x0, v0 = Fraction(r.randint(-5, 5), 4), Fraction(r.randint(-5, 5), 3)
                h, n = Fraction(1, r.randint(2, 9)), r.randint(1, 4)
                x, v = stepped(step, lambda x, v, t: -k * x - c * v, x0, v0, h, n)
                d = sf.derive(step, force=f"damped-spring:k={k},c={c}", dt=h, steps=n, x0=x0, v0=v0)
                for found, wanted in ((d.position, x), (d.velocity, v)):
                    if isinstance(found, Fraction):
                        self.assertEqual(found, wanted)
                    else:  # too long to be printed exactly
                        self.assertAlmostEqual(float(found), float(wanted))


def _value(formula, letters):
    return formula if isinstance(formula, Fraction) else formula.at(**letters)


if __name__ == "__main__":
    unittest.main()
