# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers are objects: exact numbers, tables, pictures of themselves."""

import os
import sys
import unittest
from fractions import Fraction
from unittest import mock

import shortfall as sf


class Results(unittest.TestCase):
    def test_rationals_are_fractions_and_formulas_can_be_evaluated(self):
        j = sf.jump(height="1.7")
        self.assertEqual(j.dt, Fraction(1, 50))
        self.assertEqual(j.correction.launch, Fraction(981, 10000))
        d = sf.derive("explicit-euler", force="poly:1")
        at = dict(x0=1, v0="-1/2", f0=3, f1="2/7", h="1/10", t="1/2", n=5)
        self.assertEqual(d.exact.position.at(**at) - d.position.at(**at), d.shortfall.position.at(**at))

    def test_every_command_answers(self):
        for result, member in (
            (sf.derive("rk4", force="spring:k=1", dt="1/10", steps=3, x0=1), "position"),
            (sf.jump("rapier", height=1.7, substeps=8), "correction"),
            (sf.correct("symplectic-euler", force="poly:2"), "corrections"),
            (sf.order("heun"), "classes"),
            (sf.modified("symplectic-euler", order=3, hamiltonian=True), "hamiltonian"),
            (sf.stability("rk4"), "limit"),
            (sf.verify("heun", x="x0 + v0*t + 1/2*a*t^2"), "verdicts"),
            (sf.budget("symplectic-euler", height=1.7, dt="0.02f", formats=["f32"]), "budgets"),
            (sf.audit(lambda x, v, t, a, h: (x + h * v, v + h * a(x, v, t))), "claims"),
            (sf.list("engines"), "integrators"),
            (sf.show("rk4"), "claims"),
            (sf.run("clock", dt="1/60f", until="24h"), "schema"),
        ):
            self.assertTrue(result.ok, result)
            self.assertIn(member, result)
            self.assertTrue(result._repr_html_().startswith("<div"))

    def test_scenes(self):
        from pathlib import Path

        scene = Path(__file__).resolve().parents[2] / "scenes" / "jump.toml"
        advice = sf.advise(scene)
        self.assertEqual(advice.scene, "jump")
        self.assertIn("observables", advice)
        trade = sf.trade(scene, repeats=0, integrators=["symplectic-euler"], no_peers=True)
        self.assertGreater(len(trade.records("observables")), 0)

    def test_a_refuted_formula_is_an_answer(self):
        refuted = sf.verify("explicit-euler", x="x0 + v0*t")
        self.assertFalse(refuted.ok)
        self.assertEqual(refuted.exit_code, 1)

    def test_printed_it_is_what_the_terminal_says(self):
        self.assertIn("x₀ + v₀ t + ½ a t² + ½ a h t", str(sf.derive("symplectic-euler")))
        self.assertIn("position='x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t'", repr(sf.derive("symplectic-euler")))

    def test_latex_is_the_derivation(self):
        text = sf.derive("symplectic-euler")._repr_latex_()
        self.assertTrue(text.startswith("\\begin{align*}"))
        self.assertIn(r"&= -\frac{1}{2} \, a \, h \, t &&", text)
        self.assertIsNone(sf.list()._repr_latex_())

    def test_formulas_as_latex(self):
        for plain, latex in (
            ("-1/2*a*h*t", r"-\frac{1}{2} \, a \, h \, t"),
            ("x0 - (a + b)*c", r"x_{0} - \left(a + b\right) \, c"),
            ("(a + b)^2/sqrt(2)", r"\frac{\left(a + b\right)^{2}}{\sqrt{2}}"),
            ("lambda^2 - alpha_m", r"\lambda^{2} - \alpha_{m}"),
            ("f0 - -a", r"f_{0} - \left(-a\right)"),
            ("(1/2)^n", r"\left(\frac{1}{2}\right)^{n}"),
            ("(x^2)^3", r"\left(x^{2}\right)^{3}"),
            ("+x", "x"),
            ("-(1/2)*x", r"-\frac{1}{2} \, x"),
        ):
            self.assertEqual(sf.Formula(plain).latex, latex)

    def test_two_functions_of_one_name_are_two(self):
        euler, explicit = (lambda x, v, t, a, h: (x + h*(v + h*a(x, v, t)), v + h*a(x, v, t)),
                           lambda x, v, t, a, h: (x + h*v, v + h*a(x, v, t)))
        port = sf.run("port", euler, explicit, height=1.7, dt="60Hz")
        self.assertNotEqual(port.launch, port.ported.launch)
        self.assertEqual(port.launch, sf.run("port", "symplectic-euler", "explicit-euler", height=1.7, dt="60Hz").launch)
        self.assertNotIn(os.sep + "0" + os.sep, port.text())

    def test_formulas_evaluate_by_the_languages_rules(self):
        self.assertEqual(sf.Formula("-h^2").at(h=3), -9)
        self.assertEqual(sf.Formula("2^3").at(), 8)
        self.assertEqual(sf.Formula("sqrt(9/4)").at(), Fraction(3, 2))
        self.assertAlmostEqual(sf.Formula("sqrt(h)").at(h=2), 2**0.5)
        for wrong in ("__import__('os')", "h.real", "[h]", "h if h else h"):
            with self.assertRaises(sf.UsageError):
                sf.Formula(wrong).at(h=1)
        with self.assertRaises(sf.UsageError):
            sf.Formula("a*h").at(h=1)

    def test_html_escapes_what_it_shows(self):
        result = sf.derive("symplectic-euler")
        hostile = sf.Result(result._call, {"schema": "x", "title": "<script>alert(1)</script>", "rows": [{"<b>": "&"}]}, 0)
        text = hostile._repr_html_()
        self.assertNotIn("<script>", text)
        self.assertIn("&lt;script&gt;", text)
        self.assertIn("&lt;b&gt;", text)

    def test_rows_and_frames(self):
        rows = sf.derive("symplectic-euler").records("corrections")
        self.assertEqual([row["kind"] for row in rows], ["launch", "read-out"])
        with self.assertRaises(sf.UsageError) as caught:
            sf.derive("symplectic-euler").records("corections")
        self.assertIn("corrections", caught.exception.message)
        try:
            import pandas  # noqa: F401
        except ImportError:
            with self.assertRaises(ImportError) as missing:
                sf.order("rk4").to_frame()
            self.assertIn("records()", str(missing.exception))
        else:
            self.assertEqual(list(sf.derive("symplectic-euler").to_frame("corrections")["target"]), ["v0", "v"])

    def test_frames_are_asked_of_pandas(self):
        pandas = mock.MagicMock()
        with mock.patch.dict(sys.modules, {"pandas": pandas}):
            sf.derive("symplectic-euler").to_frame("corrections")
        (rows,), _ = pandas.DataFrame.call_args
        self.assertEqual(rows[0]["add"], "-1/2*a*h")

    def test_code_of_a_language(self):
        self.assertIn("def launch_velocity(", sf.code("symplectic-euler", "python"))
        with self.assertRaises(sf.UsageError):
            sf.code("symplectic-euler", "cobol")


if __name__ == "__main__":
    unittest.main()
