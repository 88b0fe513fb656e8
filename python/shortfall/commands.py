# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands as functions.

Options are keyword arguments named as in the command's help, with _ for -: `substeps=4`, `dt="1/50"`,
`param={"beta": "1/4"}`, `all_engines=True`.  Numbers are text, int, Fraction or short decimals, and stay exact.
"""

from __future__ import annotations

import os
from typing import Any, Optional

from .binary import Call, IntegratorLike
from .result import Result, answered


def run(command: str, *arguments: IntegratorLike, timeout: Optional[float] = None, **options: Any) -> Result:
    """Any command of shortfall that answers as JSON: run("clock", dt="1/60f", until="24h").

    Raises a ShortfallError, with the command's exit code and message, where there is no answer.
    """
    return answered(Call(command, arguments, options, timeout))


def code(integrator: IntegratorLike = "symplectic-euler", lang: str = "python", **options: Any) -> str:
    """The correction as code of a language: csharp, cpp, gdscript, python, rust, javascript."""
    from .errors import error_of

    answer = Call("correct", (integrator,), {"lang": lang, **options}, None).answer()
    if answer.exit_code != 0:
        raise error_of(answer.exit_code, answer.err)
    return answer.out


def derive(integrator: IntegratorLike = "symplectic-euler", force: str = "constant", **options: Any) -> Result:
    """The exact motion after n steps, its shortfall (exact minus computed), the corrections, with proofs.

    >>> import shortfall as sf
    >>> d = sf.derive("symplectic-euler")
    >>> d.shortfall.position
    '-1/2*a*h*t'
    >>> d.corrections[0].target, d.corrections[0].add
    ('v0', '-1/2*a*h')
    >>> d.position.at(x0=0, v0=1, a=-10, h="1/10", t=1)
    Fraction(-9, 2)
    """
    return run("derive", integrator, force=force, **options)


def jump(integrator: IntegratorLike = "symplectic-euler", height: Any = None, **options: Any) -> Result:
    """How far a jump falls short, why, and the launch that makes it right.

    >>> import shortfall as sf
    >>> j = sf.jump(height=1.7, dt="0.02")
    >>> j.correction.launch, round(float(j.shortfall.total), 6)
    (Fraction(981, 10000), 0.057271)
    """
    return run("jump", integrator, height=height, **options)


def correct(integrator: IntegratorLike = "symplectic-euler", force: str = "constant", **options: Any) -> Result:
    """The correction kit alone: what to add to launch, read-out, force or step."""
    return run("correct", integrator, force=force, **options)


def order(integrator: IntegratorLike = "symplectic-euler", **options: Any) -> Result:
    """How many terms of the exact motion a step gets right, for each class of forces.

    >>> import shortfall as sf
    >>> sf.order("rk4").classes.general
    4
    """
    return run("order", integrator, **options)


def modified(integrator: IntegratorLike = "symplectic-euler", **options: Any) -> Result:
    """The equation that a step really solves, for every smooth force; its Hamiltonian."""
    return run("modified", integrator, **options)


def stability(integrator: IntegratorLike = "symplectic-euler", **options: Any) -> Result:
    """For which steps an oscillation stays bounded, exactly.

    >>> import shortfall as sf
    >>> sf.stability("velocity-verlet").limit.formula
    Fraction(2, 1)
    """
    return run("stability", integrator, **options)


def verify(integrator: IntegratorLike, x: Optional[str] = None, v: Optional[str] = None, force: str = "constant",
           **options: Any) -> Result:
    """Proves or refutes a formula for the motion after n steps; a refuted one is a result whose `ok` is False.

    >>> import shortfall as sf
    >>> sf.verify("explicit-euler", x="x0 + v0*t + 1/2*a*t^2 - 1/2*a*h*t").ok
    True
    >>> sf.verify("explicit-euler", x="x0 + v0*t").verdicts[0].counter_example.computed
    Fraction(1, 100)
    """
    return run("verify", integrator, x=x, v=v, force=force, **options)


def budget(integrator: IntegratorLike = "symplectic-euler", **options: Any) -> Result:
    """What part of an error is the method's, the constants', the arithmetic's, the sampling's."""
    return run("budget", integrator, **options)


def trade(scene: "str | os.PathLike[str]", **options: Any) -> Result:
    """Accuracy against speed in a scene: errors beside what they cost."""
    return run("trade", scene, **options)


def advise(scene: "str | os.PathLike[str]", **options: Any) -> Result:
    """The cheapest thing that is good enough for a scene: what to model, how to step it."""
    return run("advise", scene, **options)


def audit(file: IntegratorLike, **options: Any) -> Result:
    """Are the claims of a tableau or an .integrator file true, and what is probably mistyped?"""
    return run("audit", file, **options)


def list(kind: Optional[str] = None, **options: Any) -> Result:  # noqa: A001  the command's name
    """The integrators that come with shortfall.

    >>> import shortfall as sf
    >>> "rk4" in [i.name for i in sf.list().integrators]
    True
    """
    return run("list", *(() if kind is None else (kind,)), **options)


def show(integrator: IntegratorLike, **options: Any) -> Result:
    """One integrator: its file, and whether its claims hold."""
    return run("show", integrator, **options)
