# SPDX-License-Identifier: GPL-3.0-or-later
"""What is no integrator is refused in one sentence that says what to write instead."""

import math
import os
import random
import unittest
from unittest import mock

import shortfall as sf


class Refusals(unittest.TestCase):
    def refused(self, f, *words, **options):
        with self.assertRaises(sf.TraceError) as caught:
            sf.trace(f, **options)
        message = caught.exception.message
        self.assertNotIn("\n", message)
        for word in words:
            self.assertIn(word, message)

    def test_branches(self):
        self.refused(lambda x, v, t, a, h: (x, v) if h > 0 else (x, x / h), "may not branch", "sf.maximum")
        self.refused(lambda x, v, t, a, h: (x + (h or 1) * v, v), "may not branch")
        self.refused(lambda x, v, t, a, h: (x + max(h, 0) * v, v), "sf.maximum")
        self.refused(lambda x, v, t, a, h: (x, v) if h == 0 else (x, v), "may not branch")
        self.refused(lambda x, v, t, a, h: (x + h * v / abs(v), v), "limit speed")
        self.refused(lambda x, v, t, a, h: (x, v)[h], "no number")

    def test_floats_that_were_rounded(self):
        self.refused(lambda x, v, t, a, h: (x + 1 / 3 * h * v, v), "fractions.Fraction(1, 3)", 'sf.exact("1/3")')
        self.refused(lambda x, v, t, a, h: (x + (0.1 + 0.2) * h * v, v), "Fraction(3, 10)")
        self.refused(lambda x, v, t, a, h: (x + math.sqrt(2) * h * v, v), "sf.sqrt(2)")
        self.refused(lambda x, v, t, a, h: (x + 0.1786178958448091 * h * v, v), 'sf.approx("0.1786178958448091")')
        self.refused(lambda x, v, t, a, h: (x + math.inf * h * v, v), "inf")
        self.refused(lambda x, v, t, a, h, c=1 / 3: (x + c * h * v, v), "Fraction(1, 3)")
        with self.assertRaises(sf.TraceError):
            sf.derive("rk4", dt=1 / 60)

    def test_functions_that_are_not_known(self):
        self.refused(lambda x, v, t, a, h: (x + math.sin(h) * v, v), "math.sin", "sf.exp")
        self.refused(lambda x, v, t, a, h: (x + int(h) * v, v), "no number")
        self.refused(lambda x, v, t, a, h: (x + v.norm() * v, v), "'norm'")
        self.refused(lambda x, v, t, a, h: (x + h % 2 * v, v), "no number")

    def test_what_has_no_sense_for_vectors(self):
        self.refused(lambda x, v, t, a, h: (x * v, v), "two vectors")
        self.refused(lambda x, v, t, a, h: (x + h, v), "cannot add a scalar to a vector")
        self.refused(lambda x, v, t, a, h: (x - 1, v), "cannot subtract a scalar from a vector")
        self.refused(lambda x, v, t, a, h: (h / x, v), "divide by a vector")
        self.refused(lambda x, v, t, a, h: (x**2, v), "no powers")
        self.refused(lambda x, v, t, a, h: (x + h**0.5 * v, v), "sf.sqrt")
        self.refused(lambda x, v, t, a, h: (x + h / 0 * v, v), "divides by 0")
        self.refused(lambda x, v, t, a, h: (x + h * v, v + h * a), "a(x, v, t)")
        self.refused(lambda x, v, t, a, h: (x + h * v, v + h * a(x)), "a(x, v, t)")
        self.refused(lambda x, v, t, a, h: (x + h * v, v + h * a(h, v, t)), "scalar as its position")

    def test_in_place_state(self):
        def mutates(x, v, t, a, h):
            x[0] = v

        kept = []

        def remembers(x, v, t, a, h):
            kept.append(a(x, v, t))
            return x + h * v, v + h * kept[0]

        class Body:
            force = None

        body = Body()

        def hides(x, v, t, a, h):
            before, body.force = body.force, a(x, v, t)
            return x + h * v, v + h * (body.force if before is None else before)

        count = [0]

        def counts(x, v, t, a, h):
            count[0] += 1
            return x + count[0] * h * v, v

        self.refused(mutates, "not changed in place")
        self.refused(remembers, "in-place state", "states=")
        self.refused(hides, "in-place state", "states=")
        self.refused(counts, "when it is called again")
        self.refused(lambda x, v, t, a, h: (x + random.randrange(10**9) * h * v, v), "random")
        self.refused(lambda x, v, t, a, h: None, "returns nothing", "(x, v)")

    def test_wrong_results(self):
        self.refused(lambda x, v, t, a, h: x, "one Value", "(x, v)")
        self.refused(lambda x, v, t, a, h: (x, v, v), "returns 3 values", "(x, v)")
        self.refused(lambda x, v, t, a, h: (x, h), "a scalar as the new v")
        self.refused(lambda x, v, t, a, h: (x, 0), "a int as the new v")
        self.refused(lambda x, v, t, a, h: {"x": x}, "new v")
        self.refused(lambda x, v, t, a, h: {"x": x, "v": v, "w": v}, "'w'")

    def test_wrong_arguments(self):
        self.refused(lambda x, v, step: (x, v), "'step'", "default")
        self.refused(lambda *everything: everything, "*args")
        self.refused(42, "no function")
        self.refused(lambda x, v: (x, v), "first value", states={"a0": "L/T^2"})
        self.refused(lambda x, v: (x, v), "cannot be the name", name="Own Step")
        self.refused(lambda x, v: (x, v), "'c'", dimensions={"c": "1/T"})

    def test_too_long(self):
        def endless(x, v, t, a, h):
            for i in range(20000):
                x = x + h / (i + 1) * v
            return x, v

        self.refused(endless, "substeps")

    def test_a_loop_that_depends_on_a_value_is_left(self):
        def waits(x, v, t, a, h):
            while t < 1:
                t = t + h
            return x, v

        self.refused(waits, "may not branch")

    def test_dimensions_are_the_commands_business_and_are_pointed_at(self):
        with self.assertRaises(sf.BadInputFile) as caught:
            sf.derive(lambda x, v, t, a, h: (x + v, v))
        self.assertEqual(caught.exception.exit_code, 3)
        self.assertRegex(caught.exception.message, r"^traced\.integrator:4:9: cannot add")


class Errors(unittest.TestCase):
    def test_exit_codes_become_exceptions(self):
        for call, kind, code in (
            (lambda: sf.derive("nosuch"), sf.UsageError, 2),
            (lambda: sf.derive("rk4", wrong=1), sf.UsageError, 2),
            (lambda: sf.derive("rk4", force="sprong"), sf.UsageError, 2),
            (lambda: sf.derive("no/such/file.integrator"), sf.ShortfallError, None),
            (lambda: sf.run("nosuch"), sf.UsageError, 2),
            (lambda: sf.derive("--help"), sf.ShortfallError, None),
        ):
            with self.assertRaises(kind) as caught:
                call()
            if code is not None:
                self.assertEqual(caught.exception.exit_code, code)
            self.assertTrue(caught.exception.message)
            self.assertFalse(caught.exception.message.startswith("shortfall: "))

    def test_what_is_not_derivable_is_said(self):
        with self.assertRaises(sf.NotDerivable) as caught:
            sf.code("explicit-euler", "python", force="general")
        self.assertEqual(caught.exception.exit_code, 4)

    def test_no_binary(self):
        with mock.patch.dict(os.environ, {"SHORTFALL": "/no/such/shortfall"}):
            with self.assertRaises(sf.BinaryNotFound) as caught:
                sf.derive("rk4")
            self.assertIn("/no/such/shortfall", caught.exception.message)

    def test_a_numbers_beside_the_wrong_thing(self):
        for wrong in (3, None, object()):
            with self.assertRaises(sf.ShortfallError):
                sf.derive(wrong)


if __name__ == "__main__":
    unittest.main()
