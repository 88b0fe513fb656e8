# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact error of time integrators: what it is, why, and how to repair it.

A thin client: a Python function is traced into an integrator, and the command `shortfall` answers.

>>> import shortfall as sf
>>> d = sf.derive(lambda x, v, t, a, h: (x + h*(v + h*a(x, v, t)), v + h*a(x, v, t)))
>>> d.shortfall.position
'-1/2*a*h*t'
"""

from .binary import binary
from .commands import (advise, audit, budget, code, correct, derive, jump, list, modified, order, run, show, stability,
                       trade, verify)
from .errors import (BadInputFile, BinaryNotFound, FileError, InternalError, NotDerivable, Refuted, ShortfallError,
                     TraceError, UsageError)
from .formula import Formula
from .functions import approx, exp, maximum, minimum, pow, sqrt
from .number import exact
from .result import Record, Result
from .tracing import Integrator, trace

__version__ = "0.1.0"

__all__ = [
    "BadInputFile", "BinaryNotFound", "FileError", "Formula", "Integrator", "InternalError", "NotDerivable", "Record",
    "Refuted", "Result", "ShortfallError", "TraceError", "UsageError", "advise", "approx", "audit", "binary", "budget",
    "code", "correct", "derive", "exact", "exp", "jump", "list", "maximum", "minimum", "modified", "order", "pow", "run",
    "show", "sqrt", "stability", "trace", "trade", "verify",
]
