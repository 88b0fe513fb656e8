# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers, taken exactly or refused."""

from __future__ import annotations

import decimal
import math
import numbers
from fractions import Fraction
from typing import Optional, Union

from .errors import TraceError

#: A float of more digits than these is taken for a number that was rounded, such as 1/3.
LONGEST_DECIMAL = 12

Number = Union[int, Fraction, float, decimal.Decimal]


def exact(number: Union[str, Number]) -> Fraction:
    """The exact number that a text means: "1/3", "0.1", "1e-3".

    >>> exact("1/3")
    Fraction(1, 3)
    >>> exact("0.1")
    Fraction(1, 10)
    >>> exact(1/3)
    Traceback (most recent call last):
    ...
    shortfall.errors.TraceError: the float 0.3333333333333333 is not exact; write fractions.Fraction(1, 3) or sf.exact("1/3")
    """
    if isinstance(number, str):
        try:
            return Fraction(number.replace(" ", ""))
        except (ValueError, ZeroDivisionError):
            raise TraceError(f"sf.exact({number!r}): that is no number; write one such as '1/3' or '0.1'") from None
    text = number_text(number)
    return Fraction(text)


def number_text(number: object) -> str:
    """A number as text that means exactly it: "2", "1/3", "0.1".

    A float is meant as the short decimal that Python prints for it; one that has none was rounded, and is refused.

    >>> number_text(0.1), number_text(2.0), number_text(Fraction(-1, 3)), number_text(1e-3)
    ('0.1', '2', '-1/3', '0.001')
    >>> number_text(math.sqrt(2))
    Traceback (most recent call last):
    ...
    shortfall.errors.TraceError: the float 1.4142135623730951 is not exact; write sf.sqrt(2)
    """
    if isinstance(number, bool):
        raise TraceError(f"{number} is no number; write 1 or 0")
    if isinstance(number, numbers.Integral):
        return str(int(number))
    if isinstance(number, numbers.Rational):
        return str(Fraction(number.numerator, number.denominator))
    if isinstance(number, decimal.Decimal):
        if not number.is_finite():
            raise TraceError(f"{number} is no number that a step can use")
        return _plain(number)
    if isinstance(number, numbers.Real):
        return _float_text(float(number))
    raise TraceError(f"a {type(number).__name__} is no real number; a step computes with numbers and vectors only")


def _plain(value: decimal.Decimal) -> str:
    """A decimal without an exponent and without zeros at its end."""
    text = format(value, "f")
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _float_text(value: float) -> str:
    if not math.isfinite(value):
        raise TraceError(f"{value} is no number that a step can use")
    if value == int(value) and abs(value) < 2**53:
        return str(int(value))
    shortest = decimal.Decimal(repr(value))
    if len(shortest.as_tuple().digits) > LONGEST_DECIMAL:
        raise TraceError(f"the float {value!r} is not exact; {_advice(value)}")
    return _plain(shortest)


def _advice(value: float) -> str:
    fraction = _meant_fraction(value)
    if fraction is not None:
        return f'write fractions.Fraction({fraction.numerator}, {fraction.denominator}) or sf.exact("{fraction}")'
    square = Fraction(value * value).limit_denominator(100)
    if value > 0 and square > 0 and math.sqrt(square) == value:
        inner = str(square) if square.denominator == 1 else f'sf.exact("{square}")'
        return f"write sf.sqrt({inner})"
    return (
        f'write it as fractions.Fraction(p, q) or sf.exact("p/q"), or, when only its digits are known, as '
        f'sf.approx("{value!r}")'
    )


def _meant_fraction(value: float) -> Optional[Fraction]:
    """The fraction of a small denominator, or short decimal, that was rounded to this float."""
    for largest in (1000, 10**6):
        fraction = Fraction(value).limit_denominator(largest)
        # A few roundings may lie between them: 0.1 + 0.2 was meant as 3/10.
        if fraction != 0 and abs(float(fraction) - value) <= 2 * math.ulp(value):
            return fraction
    return None
