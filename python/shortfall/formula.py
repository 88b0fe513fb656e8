# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas that the command answers with."""

from __future__ import annotations

import ast
import math
import re
from fractions import Fraction
from typing import Any, Dict

from .errors import UsageError
from .number import number_text


class Formula(str):
    """A formula in the .integrator language: text that can be evaluated and shown.

    >>> f = Formula("x0 + v0*t + 1/2*a*t^2")
    >>> f.at(x0=0, v0=3, a=-10, t="1/10")
    Fraction(1, 4)
    >>> f.latex
    'x_{0} + v_{0} \\\\, t + \\\\frac{1}{2} \\\\, a \\\\, t^{2}'
    """

    __slots__ = ()

    def at(self, **letters: Any) -> Any:
        """Its value: a Fraction while everything is rational, otherwise a float."""
        known: Dict[str, Any] = {}
        for name, content in letters.items():
            known[name] = content if isinstance(content, Fraction) else Fraction(
                content if isinstance(content, str) else number_text(content))
        return _evaluated(_tree(self), known)

    @property
    def latex(self) -> str:
        return _latex(_tree(self))[0]

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"


def _tree(text: str) -> ast.expr:
    plain = text.replace("^", "**").replace("'", "_prime")
    plain = re.sub(r"\blambda\b", "lambda_", plain)
    try:
        return ast.parse(plain, mode="eval").body
    except (SyntaxError, RecursionError, MemoryError):
        raise UsageError(f"'{text[:60]}' is no formula that can be evaluated") from None


_FUNCTIONS = {f: getattr(math, f) for f in
              ("sqrt", "exp", "pow", "cos", "sin", "acos", "atan", "cosh", "sinh", "acosh", "log")}
_FUNCTIONS.update({"max": max, "min": min})


def _evaluated(node: ast.expr, letters: Dict[str, Any]) -> Any:
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return Fraction(repr(node.value))
    if isinstance(node, ast.Name):
        name = node.id.replace("_prime", "'")
        name = "lambda" if name == "lambda_" else name
        if name not in letters:
            raise UsageError(f"the formula has the letter {name}, which was not given")
        return letters[name]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        value = _evaluated(node.operand, letters)
        return -value if isinstance(node.op, ast.USub) else value
    if isinstance(node, ast.BinOp):
        left, right = _evaluated(node.left, letters), _evaluated(node.right, letters)
        if isinstance(node.op, ast.Add):
            return left + right
        if isinstance(node.op, ast.Sub):
            return left - right
        if isinstance(node.op, ast.Mult):
            return left * right
        if isinstance(node.op, ast.Div):
            return left / right
        if isinstance(node.op, ast.Pow):
            return left ** int(right) if right == int(right) else float(left) ** float(right)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _FUNCTIONS and not node.keywords:
        arguments = [_evaluated(argument, letters) for argument in node.args]
        if node.func.id in ("max", "min"):
            return _FUNCTIONS[node.func.id](*arguments)
        if node.func.id == "sqrt" and isinstance(arguments[0], Fraction) and arguments[0] >= 0:
            root = Fraction(math.isqrt(arguments[0].numerator), math.isqrt(arguments[0].denominator))
            if root * root == arguments[0]:
                return root
        return _FUNCTIONS[node.func.id](*(float(argument) for argument in arguments))
    raise UsageError("this part of the formula has no number: " + ast.dump(node)[:60])


_GREEK = {"alpha", "beta", "gamma", "delta", "theta", "xi", "chi", "lambda", "rho", "phi", "omega"}


def _letter(name: str) -> str:
    name = name.replace("_prime", "'")
    primes = len(name) - len(name.rstrip("'"))
    stem, _, index = name.rstrip("'").partition("_")
    if not index:
        match = re.fullmatch(r"([A-Za-z]+)(\d+)", stem)
        if match:
            stem, index = match.groups()
    if stem in _GREEK:
        stem = "\\" + stem
    elif len(stem) > 1:
        stem = f"\\mathrm{{{stem}}}"
    return stem + "'" * primes + (f"_{{{index}}}" if index else "")


def _latex(node: ast.expr) -> "tuple[str, int]":
    """With how tightly it binds: 0 a sum, 1 a sign, 2 a product, a quotient or a power, 3 an atom."""
    def bound(part: ast.expr, least: int) -> str:
        text, binding = _latex(part)
        return text if binding >= least else f"\\left({text}\\right)"

    if isinstance(node, ast.Constant):
        return str(node.value), 3
    if isinstance(node, ast.Name):
        return _letter(node.id), 3
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.UAdd):
        return _latex(node.operand)
    if isinstance(node, ast.UnaryOp):
        return "-" + bound(node.operand, 2), 1
    if isinstance(node, ast.BinOp):
        if isinstance(node.op, (ast.Add, ast.Sub)):
            sign = " + " if isinstance(node.op, ast.Add) else " - "
            return _latex(node.left)[0] + sign + bound(node.right, 2), 0
        if isinstance(node.op, ast.Mult):
            left, binding = _latex(node.left)  # a sign may lead a product
            left = left if binding >= 1 else f"\\left({left}\\right)"
            return left + " \\, " + bound(node.right, 2), 1 if left.startswith("-") else 2
        if isinstance(node.op, ast.Div):
            if isinstance(node.left, ast.UnaryOp) and isinstance(node.left.op, ast.USub):  # the sign stands before the fraction
                return f"-\\frac{{{bound(node.left.operand, 2)}}}{{{_latex(node.right)[0]}}}", 1
            return f"\\frac{{{_latex(node.left)[0]}}}{{{_latex(node.right)[0]}}}", 2
        if isinstance(node.op, ast.Pow):
            return f"{bound(node.left, 3)}^{{{_latex(node.right)[0]}}}", 2
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        arguments = ", ".join(_latex(argument)[0] for argument in node.args)
        if node.func.id == "sqrt":
            return f"\\sqrt{{{arguments}}}", 3
        return f"\\operatorname{{{node.func.id}}}\\left({arguments}\\right)", 3
    return "\\text{?}", 3
