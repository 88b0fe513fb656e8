# SPDX-License-Identifier: GPL-3.0-or-later
"""What a traced function computes with: values without numbers, which write down what is done to them."""

from __future__ import annotations

import numbers
from fractions import Fraction
from typing import Any, NoReturn, Optional, Tuple

from .errors import TraceError
from .number import exact, number_text

_BRANCH = (
    "a step may not branch on its values (if, while, and, or, max, min, comparisons): an integrator is one formula for "
    "all of them; write sf.maximum or sf.minimum, or the .integrator language's `when` and `limit`"
)
_NO_NUMBER = (
    "a traced value has no number, so that math.sin and other functions of numbers cannot follow it; a step may use "
    "+ - * / **, sf.sqrt, sf.exp, sf.pow, sf.maximum and sf.minimum, and the force a(x, v, t)"
)
_NO_PARTS = (
    "a traced vector has no components and is not changed in place: write the step once for the whole vector, "
    "and return the new values, such as (x, v)"
)


class Value:
    """A scalar or a vector of a step that is being traced; immutable."""

    __slots__ = ("op", "operands", "text", "sort", "trace")
    op: str  # number, name, approx, negate, add, subtract, multiply, divide, power, force, call
    operands: Tuple["Value", ...]
    text: str  # of a number, a name, a function, an exponent
    sort: str  # "scalar" or "vector"
    trace: Optional[object]  # which trace it belongs to; none for constants

    def __init__(self, op: str, operands: Tuple["Value", ...] = (), text: str = "", sort: str = "scalar",
                 trace: Optional[object] = None):
        for operand in operands:
            if operand.trace is None:
                continue
            if trace is None:
                trace = operand.trace
            elif trace is not operand.trace:
                raise TraceError(
                    "the step uses a value that it kept from an earlier call (in-place state): give what it carries "
                    'from step to step a name, sf.trace(step, states={"a0": "L/T^2"}, start=...), and return it'
                )
        for slot, content in zip(Value.__slots__, (op, operands, text, sort, trace)):
            object.__setattr__(self, slot, content)

    # Sums, products, powers: one operation of Python's is one of the step's.
    def __add__(self, other: Any) -> "Value":
        return _sum("add", self, other, "add", "to")

    def __radd__(self, other: Any) -> "Value":
        if is_zero(other):  # where sum(...) begins
            return self
        return _sum("add", other, self, "add", "to")

    def __sub__(self, other: Any) -> "Value":
        return _sum("subtract", self, other, "subtract", "from")

    def __rsub__(self, other: Any) -> "Value":
        return _sum("subtract", other, self, "subtract", "from")

    def __mul__(self, other: Any) -> "Value":
        return _product(self, value(other))

    def __rmul__(self, other: Any) -> "Value":
        return _product(value(other), self)

    def __truediv__(self, other: Any) -> "Value":
        return _quotient(self, value(other))

    def __rtruediv__(self, other: Any) -> "Value":
        return _quotient(value(other), self)

    def __neg__(self) -> "Value":
        return Value("negate", (self,), sort=self.sort)

    def __pos__(self) -> "Value":
        return self

    def __pow__(self, exponent: Any, modulus: Any = None) -> "Value":
        if self.sort == "vector":
            raise TraceError("a vector has no powers; only scalars such as h do")
        if isinstance(exponent, Value):
            raise TraceError("the exponent of ** has to be a whole number; write sf.pow(base, exponent) for others")
        if isinstance(exponent, bool) or not isinstance(exponent, numbers.Integral):
            if exact(exponent) == Fraction(1, 2):
                raise TraceError("the exponent of ** has to be a whole number; write sf.sqrt(...) for the root")
            if exact(exponent).denominator != 1:
                raise TraceError(
                    "the exponent of ** has to be a whole number; write sf.pow(base, exponent) for others"
                )
        count = int(exponent)
        if count < 0:
            return Value("divide", (number(1), self ** -count))
        return Value("power", (self,), text=str(count))

    def __rpow__(self, base: Any) -> "Value":
        raise TraceError("the exponent of ** has to be a whole number; write sf.pow(base, exponent) for others")

    # What an integrator cannot do.
    def _branch(self, *_: Any) -> NoReturn:
        raise TraceError(_BRANCH)

    __bool__ = __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _branch  # type: ignore[assignment]
    __hash__ = object.__hash__

    def _no_number(self, *_: Any) -> NoReturn:
        raise TraceError(_NO_NUMBER)

    __float__ = __int__ = __complex__ = __index__ = __round__ = __trunc__ = __floor__ = __ceil__ = _no_number
    __floordiv__ = __rfloordiv__ = __mod__ = __rmod__ = __divmod__ = __rdivmod__ = _no_number
    __and__ = __or__ = __xor__ = __invert__ = __lshift__ = __rshift__ = _no_number

    def __abs__(self) -> NoReturn:
        raise TraceError(
            "a step may not take the size of a value (abs, a length); the .integrator language has `limit speed` "
            "and `when speed > S` for what depends on a length"
        )

    def _no_parts(self, *_: Any) -> NoReturn:
        raise TraceError(_NO_PARTS)

    __getitem__ = __setitem__ = __delitem__ = __iter__ = __len__ = __contains__ = __reversed__ = _no_parts
    __matmul__ = __rmatmul__ = _no_parts

    def __setattr__(self, name: str, content: Any) -> NoReturn:
        raise TraceError(_NO_PARTS)

    def __getattr__(self, name: str) -> NoReturn:
        if name.startswith("__"):
            raise AttributeError(name)
        raise TraceError(f"a traced {self.sort} has no '{name}': a step adds, multiplies by scalars and calls a(x, v, t)")

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> "Value":
        from . import functions

        if method == "__call__" and not options:
            binary = {"add": "__add__", "subtract": "__sub__", "multiply": "__mul__", "divide": "__truediv__",
                      "true_divide": "__truediv__"}
            if ufunc.__name__ in binary and len(inputs) == 2:
                left, right = inputs
                if isinstance(left, Value):
                    return getattr(left, binary[ufunc.__name__])(right)
                return getattr(right, binary[ufunc.__name__].replace("__", "__r", 1))(left)
            if ufunc.__name__ in ("sqrt", "exp", "maximum", "minimum"):
                return getattr(functions, ufunc.__name__)(*inputs)
            if ufunc.__name__ == "negative":
                return -inputs[0]
            if ufunc.__name__ == "power" and isinstance(inputs[0], Value):
                return inputs[0] ** inputs[1]
        raise TraceError(f"numpy.{ufunc.__name__}: {_NO_NUMBER}")

    def __repr__(self) -> str:
        from .emit import expression

        return f"<{self.sort} {expression(self)}>"


def number(content: Any) -> Value:
    """A constant."""
    return Value("number", text=number_text(content))


def value(content: Any) -> Value:
    """What stands beside a traced value: another, or a number."""
    if isinstance(content, Value):
        return content
    if isinstance(content, str):
        raise TraceError(f"the text {content!r} is no number; write sf.exact({content!r})")
    if callable(content):
        raise TraceError("a function stands where a value is wanted; the force is called as a(x, v, t)")
    return number(content)


def is_zero(content: Any) -> bool:
    return not isinstance(content, Value) and isinstance(content, numbers.Number) and content == 0


def _sum(op: str, left: Any, right: Any, word: str, joint: str) -> Value:
    a, b = value(left), value(right)
    if a.sort != b.sort:
        # 0 fits every vector.
        if b.op == "number" and b.text == "0":
            return a
        if a.op == "number" and a.text == "0":
            return b if op == "add" else -b
        # x + h adds h to x; x - h subtracts h from x.
        raise TraceError(f"cannot {word} a {b.sort} {joint} a {a.sort}")
    return Value(op, (a, b), sort=a.sort)


def _product(a: Value, b: Value) -> Value:
    if a.sort == b.sort == "vector":
        raise TraceError("two vectors may not be multiplied: a step multiplies a vector by a scalar only")
    return Value("multiply", (a, b), sort="vector" if "vector" in (a.sort, b.sort) else "scalar")


def _quotient(a: Value, b: Value) -> Value:
    if b.sort == "vector":
        raise TraceError("a step may not divide by a vector")
    if b.op == "number" and Fraction(b.text) == 0:
        raise TraceError("the step divides by 0")
    return Value("divide", (a, b), sort=a.sort)
