# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of scalars that a step may use, and coefficients known to some digits."""

from __future__ import annotations

import re
from typing import Any

from .errors import TraceError
from .value import Value, value


def _call(name: str, *arguments: Any) -> Value:
    operands = tuple(value(argument) for argument in arguments)
    if any(operand.sort == "vector" for operand in operands):
        raise TraceError(f"sf.{name} takes scalars, not vectors")
    return Value("call", operands, text={"maximum": "max", "minimum": "min"}.get(name, name))


def sqrt(number: Any) -> Value:
    """The square root, exact where it is one of a rational number: sqrt(2)."""
    return _call("sqrt", number)


def exp(number: Any) -> Value:
    """e to a power: exp(-c*h)."""
    return _call("exp", number)


def pow(base: Any, exponent: Any) -> Value:  # noqa: A001  the language's name
    """A power with any exponent: pow(1 - c, h)."""
    return _call("pow", base, exponent)


def maximum(a: Any, b: Any) -> Value:
    """The larger of two scalars: maximum(0, 1 - c*h)."""
    return _call("maximum", a, b)


def minimum(a: Any, b: Any) -> Value:
    """The smaller of two scalars."""
    return _call("minimum", a, b)


def approx(decimal: str) -> Value:
    """A coefficient of which only the digits printed are known: approx("0.1786178958448091").

    What is derived is then "zero to k digits", never "proved".
    """
    if not isinstance(decimal, str) or not re.fullmatch(r"-?\d+\.\d+", decimal):
        raise TraceError(f'sf.approx takes the decimal as text, such as sf.approx("0.1786178958448091"), not {decimal!r}')
    return Value("approx", text=decimal)
