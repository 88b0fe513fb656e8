# SPDX-License-Identifier: GPL-3.0-or-later
"""Python functions become the integrator that their author wrote."""

import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import shortfall as sf


def step_of(f, **options):
    return sf.trace(f, **options).text.split("\nstep\n")[1]


class Tracing(unittest.TestCase):
    def test_the_order_of_operations_is_the_authors(self):
        def of(make):
            return step_of(lambda x, v, t, a, h: (x + make(h, h, t) * v, v)).strip()

        self.assertEqual(of(lambda p, q, r: p + (q + r)), "x = x + (h + (h + t))*v")
        self.assertEqual(of(lambda p, q, r: (p + q) + r), "x = x + (h + h + t)*v")
        self.assertEqual(of(lambda p, q, r: p - (q - r)), "x = x + (h - (h - t))*v")
        self.assertEqual(of(lambda p, q, r: p / (q / r)), "x = x + h/(h/t)*v")
        self.assertEqual(of(lambda p, q, r: p * (q * r)), "x = x + h*(h*t)*v")
        self.assertEqual(of(lambda p, q, r: -(p + q)), "x = x + (-(h + h)*v)")
        self.assertEqual(of(lambda p, q, r: (-p) ** 2), "x = x + (-h)^2*v")
        self.assertEqual(of(lambda p, q, r: -(p**2)), "x = x + (-h^2*v)")
        self.assertEqual(of(lambda p, q, r: p * -2), "x = x + h*(-2)*v")
        self.assertEqual(of(lambda p, q, r: p * Fraction(1, 3)), "x = x + h*(1/3)*v")
        self.assertEqual(of(lambda p, q, r: Fraction(1, 3) * p), "x = x + 1/3*h*v")
        self.assertEqual(of(lambda p, q, r: p**-2), "x = x + 1/h^2*v")
        self.assertEqual(of(lambda p, q, r: 0.1 * p), "x = x + 0.1*h*v")

    def test_what_is_computed_twice_becomes_a_named_line(self):
        def step(x, v, t, a, h):
            k = a(x, v, t)
            return x + h * v + h**2 / 2 * k, v + h * k

        self.assertEqual(
            step_of(step), "  a1 = a(x, v, t)\n  x = x + h*v + h^2/2*a1\n  v = v + h*a1\n"
        )

    def test_a_name_is_not_read_after_it_was_overwritten(self):
        text = step_of(lambda x, v, t, a, h: (x + h * v, v + h * a(x, v, t)))
        self.assertEqual(text, "  x_new = x + h*v\n  v = v + h*a(x, v, t)\n  x = x_new\n")
        # Swapped in size, so that no order of assignments does.
        self.assertEqual(step_of(lambda x, v, t, a, h: (h * v, x / h)), "  x_new = h*v\n  v = x/h\n  x = x_new\n")

    def test_states_start_and_finish(self):
        def step(x, v, t, a, h, a0):
            x = x + h * v + h**2 / 2 * a0
            a1 = a(x, v + h * a0, t + h)
            return x, v + h / 2 * (a0 + a1), a1

        verlet = sf.trace(step, name="own-verlet", states={"a0": "L/T^2"}, start=lambda x, v, t, a: a(x, v, t))
        mine, theirs = sf.order(verlet), sf.order("velocity-verlet")
        self.assertEqual(dict(mine.classes), dict(theirs.classes))
        self.assertEqual(sf.stability(verlet).trace, sf.stability("velocity-verlet").trace)
        read = sf.trace(lambda x, v, t, a, h: (x + h * v, v + h * a(x, v, t)), finish=lambda x, v, h: (x - h / 2 * v, v))
        self.assertIn("\nfinish\n  x = x - h/2*v\n", read.text)

    def test_parameters_have_defaults_and_dimensions(self):
        def step(x, v, t, a, h, c=0.1):
            """Damps after the kick."""
            v = (v + h * a(x, v, t)) * sf.maximum(0, 1 - c * h)
            return x + h * v, v

        damped = sf.trace(step, dimensions={"c": "1/T"}, assume="1 - c*h > 0", solves="a(x, v, t) - c*v")
        self.assertTrue(damped.text.startswith("# Damps after the kick.\nintegrator step\n  param c : 1/T = 0.1\n"))
        self.assertIn("max(0, 1 - c*h)", damped.text)
        self.assertTrue(sf.derive(damped).ok)

    def test_constants_may_be_made_outside_of_the_step(self):
        gamma = 1 - 1 / sf.sqrt(2)
        xi = sf.approx("0.1786178958448091")
        text = sf.trace(lambda x, v, t, a, h: (x + gamma * h * v + xi * h * v, v)).text
        self.assertIn("approx c1 = 0.1786178958448091", text)
        self.assertIn("x = x + (1 - 1/sqrt(2))*h*v + c1*h*v", text)
        self.assertIn("text", sf.show(sf.trace(lambda x, v, t, a, h: (x + gamma * h * v + xi * h * v, v))))

    def test_sums_and_augmented_assignments(self):
        def step(x, v, t, a, h):
            v += h * sum([a(x, v, t), a(x, v, t + h)]) / 2
            x += h * v
            return x, v

        self.assertEqual(step_of(step), "  v = v + h*(a(x, v, t) + a(x, v, t + h))/2\n  x = x + h*v\n")

    def test_loops_over_constants_are_written_out_and_long_formulas_cut(self):
        def step(x, v, t, a, h):
            for i in range(300):
                v = v + h / 300 * a(x, v, t + i * h / 300)
                x = x + h / 300 * v
            return x, v

        long = sf.trace(step)
        self.assertLess(max(map(len, long.text.splitlines())), 300)
        self.assertEqual(sf.show(long).ok, True)
        x0 = sf.derive(long).shortfall.position
        self.assertEqual(x0, "-1/600*a*h*t")  # that of symplectic Euler with 300 substeps

    def test_a_printed_step_can_be_saved_and_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "with blank and ü.integrator"
            mine = sf.trace(lambda x, v, t, a, h: (x + h * v, v + h * a(x, v, t)), name="mine")
            mine.save(path)
            self.assertEqual(sf.derive(path).raw, sf.derive(mine).raw)

    def test_dt_is_h_and_unused_arguments_may_be_left_out(self):
        self.assertEqual(step_of(lambda x, v, dt: (x + dt * v, v)), "  x = x + h*v\n")

    def test_numpy_scalars_are_numbers(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("numpy is not installed")
        text = step_of(lambda x, v, t, a, h: (x + numpy.float64(0.5) * h * v, v + numpy.sqrt(2 * h / h) * h * a(x, v, t)))
        self.assertIn("0.5*h*v", text)
        with self.assertRaises(sf.TraceError):
            sf.trace(lambda x, v, t, a, h: (x + numpy.sin(h) * v, v))


if __name__ == "__main__":
    unittest.main()
