# SPDX-License-Identifier: GPL-3.0-or-later
"""From a Python function to an integrator."""

from __future__ import annotations

import inspect
import os
import re
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple

from .emit import TAKEN, statements
from .errors import TraceError
from .number import number_text
from .value import Value, value

Step = Callable[..., Any]

_ROLES = {"x": "x", "v": "v", "t": "t", "h": "h", "dt": "h", "a": "a"}


@dataclass(frozen=True)
class Integrator:
    """A step written down in the .integrator language; every command takes it.

    >>> from shortfall import trace
    >>> print(trace(lambda x, v, t, a, h: (x + h*v, v + h*a(x, v, t)), name="explicit").text, end="")
    integrator explicit
    <BLANKLINE>
    step
      x_new = x + h*v
      v = v + h*a(x, v, t)
      x = x_new
    """

    name: str
    text: str

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the file, for `shortfall derive FILE`."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text)

    def __str__(self) -> str:
        return self.text


class _Force:
    """a(x, v, t) while a step is traced."""

    def __init__(self, trace: object):
        self._trace = trace

    def __call__(self, *arguments: Any, **named: Any) -> Value:
        if len(arguments) != 3 or named:
            raise TraceError("the force is called as a(x, v, t): position, velocity and time")
        x, v, t = (value(argument) for argument in arguments)
        for argument, word in ((x, "position"), (v, "velocity")):
            if argument.sort != "vector":
                raise TraceError(f"the force a(x, v, t) was called with a scalar as its {word}")
        if t.sort != "scalar":
            raise TraceError("the force a(x, v, t) was called with a vector as its time")
        return Value("force", (x, v, t), text="a", sort="vector", trace=self._trace)

    def _wrong(self, *_: Any) -> Any:
        raise TraceError("a is the force, a function: write a(x, v, t)")

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = __neg__ = _wrong


def trace(
    step: Step,
    *,
    name: Optional[str] = None,
    states: Optional[Mapping[str, str]] = None,
    start: Optional[Step] = None,
    finish: Optional[Step] = None,
    dimensions: Optional[Mapping[str, str]] = None,
    assume: "str | Sequence[str]" = (),
    solves: Optional[str] = None,
) -> Integrator:
    """The integrator that a function is.

    The function takes what it needs of x, v, t, a, h by these names and returns the new (x, v); a(x, v, t) is the
    force divided by the mass.  Further arguments with defaults become parameters.  It is called twice with values
    that write down what is done to them: one operation of Python's is one of the integrator's, and what is computed
    twice becomes a named line.

    states      what is carried from step to step besides x and v, with its dimension: {"a0": "L/T^2"}; the step
                takes it by its name and returns (x, v, a0)
    start       gives the states their first values: a function of x, v, t, a, h that returns them (or, with what
                it changes of x and v, a dict)
    finish      how x and v are read out: returns (x, v)
    dimensions  of parameters that are no pure numbers: {"c": "1/T"}
    assume      what closed forms may take for granted: "1 - c*h > 0"
    solves      the acceleration that is meant, when it is not a(x, v, t): "a(x, v, t) - c*v"

    >>> def kick_drift(x, v, t, a, h):
    ...     v = v + h*a(x, v, t)
    ...     return x + h*v, v
    >>> print(trace(kick_drift).text, end="")
    integrator kick-drift
    <BLANKLINE>
    step
      v = v + h*a(x, v, t)
      x = x + h*v
    >>> trace(lambda x, v, t, a, h: (x + 1/3*h*v, v))
    Traceback (most recent call last):
    ...
    shortfall.errors.TraceError: the float 0.3333333333333333 is not exact; write fractions.Fraction(1, 3) or sf.exact("1/3")
    """
    carried = dict(states or {})
    taken: Set[str] = set(TAKEN) | set(carried)
    for state in carried:
        if state in TAKEN or not re.fullmatch(r"[a-z][a-z0-9_]*", state):
            raise TraceError(f"'{state}' cannot be the name of a state; take one such as a0")
    if carried and start is None:
        raise TraceError(f"the states {', '.join(carried)} need a first value: give start=, a function that returns it")
    parameters: Dict[str, str] = {}
    for function in (start, step, finish):
        if function is not None:
            parameters.update(_parameters(function, carried))
    taken |= set(parameters)
    approximations: Dict[str, str] = {}
    blocks: List[str] = []
    targets = ("x", "v", *carried)
    for word, function, wanted in (("start", start, tuple(carried)), ("step", step, targets), ("finish", finish, ("x", "v"))):
        if function is None:
            continue
        known = () if word == "start" else tuple(carried)
        lines = _traced(word, function, known, parameters, wanted, taken, approximations)
        taken |= set(approximations.values())
        again = _traced(word, function, known, parameters, wanted, taken, dict(approximations))
        if lines != again:
            raise TraceError(
                f"the {word} does something else when it is called again: it reads what changes outside of it "
                "(a counter, a random number); an integrator does the same every step"
            )
        blocks.append("".join(f"  {line}\n" for line in lines))
        blocks[-1] = f"\n{word}\n" + blocks[-1]
    title = _name(step) if name is None else _checked(name)
    text = "".join(f"# {line}\n" for line in _description(step)) + f"integrator {title}\n"
    for parameter, default in parameters.items():
        dimension = (dimensions or {}).get(parameter)
        text += f"  param {parameter}{f' : {dimension}' if dimension else ''} = {default}\n"
    for other in dimensions or {}:
        if other not in parameters:
            raise TraceError(f"dimensions names '{other}', which is no parameter of the step; states say theirs in states=")
    for decimal, letter in approximations.items():
        text += f"  approx {letter} = {decimal}\n"
    for state, dimension in carried.items():
        text += f"  state {state} : {dimension}\n"
    for assumption in (assume,) if isinstance(assume, str) else assume:
        text += f"  assume {assumption}\n"
    if solves is not None:
        text += f"  solves {solves}\n"
    return Integrator(title, text + "".join(blocks))


def _signature(function: Step) -> inspect.Signature:
    if not callable(function):
        raise TraceError(f"a {type(function).__name__} is no function; give one of x, v, t, a, h")
    if inspect.iscoroutinefunction(function) or inspect.isgeneratorfunction(function):
        raise TraceError("a step is a plain function that returns (x, v), no generator and not async")
    try:
        return inspect.signature(function)
    except (TypeError, ValueError):
        raise TraceError("what this function takes cannot be seen; give a Python function of x, v, t, a, h") from None


def _parameters(function: Step, states: Mapping[str, str]) -> Dict[str, str]:
    """Arguments besides the usual ones, with the text of their defaults."""
    found: Dict[str, str] = {}
    for argument in _signature(function).parameters.values():
        if argument.kind in (argument.VAR_POSITIONAL, argument.VAR_KEYWORD):
            raise TraceError("a step names what it takes: x, v, t, a, h; *args and **kwargs say nothing")
        if argument.name in _ROLES or argument.name in states:
            continue
        if argument.default is argument.empty:
            raise TraceError(
                f"the argument '{argument.name}' is none of x, v, t, a, h; a parameter needs a default "
                f"({argument.name}=1), what is carried from step to step stands in states="
            )
        if argument.name in TAKEN or not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", argument.name):
            raise TraceError(f"'{argument.name}' cannot be the name of a parameter; it means something in the language")
        found[argument.name] = number_text(argument.default)
    return found


def _traced(
    word: str,
    function: Step,
    states: Tuple[str, ...],
    parameters: Mapping[str, str],
    wanted: Tuple[str, ...],
    taken: Set[str],
    approximations: Dict[str, str],
) -> List[str]:
    token = object()
    positional: List[Any] = []
    named: Dict[str, Any] = {}
    for argument in _signature(function).parameters.values():
        role = _ROLES.get(argument.name, argument.name)
        if role == "a":
            content: Any = _Force(token)
        elif role in ("x", "v") or role in states:
            content = Value("name", text=role, sort="vector", trace=token)
        elif role in ("t", "h") or role in parameters:
            content = Value("name", text=role, trace=token)
        else:
            raise TraceError(f"the {word} cannot take '{argument.name}', which has no value yet")
        if argument.kind == argument.POSITIONAL_ONLY:
            positional.append(content)
        else:
            named[argument.name] = content
    returned = function(*positional, **named)
    pairs = _results(word, returned, wanted)
    for target, result in pairs:
        if isinstance(result, Value) and result.trace is not None and result.trace is not token:
            raise TraceError(
                f"the {word} returns a value that it kept from an earlier call (in-place state): give what it carries "
                'from step to step a name, sf.trace(step, states={"a0": "L/T^2"}, start=...), and return it'
            )
        if not isinstance(result, Value) or result.sort != "vector":
            what = "a scalar" if isinstance(result, Value) else f"a {type(result).__name__}"
            raise TraceError(f"the {word} returns {what} as the new {target}, which has to be a vector made of x, v and a(x, v, t)")
    return statements([t for t, _ in pairs], [r for _, r in pairs], set(taken), approximations)


def _results(word: str, returned: Any, wanted: Tuple[str, ...]) -> List[Tuple[str, Any]]:
    shape = ", ".join(wanted) if len(wanted) != 1 else wanted[0]
    if returned is None:
        raise TraceError(f"the {word} returns nothing (is it in place?); it has to return the new values, ({shape})")
    if isinstance(returned, Mapping):
        names = ("x", "v", *wanted) if word == "start" else wanted
        for name in returned:
            if name not in names:
                raise TraceError(f"the {word} returns '{name}', which is none of {', '.join(dict.fromkeys(names))}")
        for name in wanted:
            if name not in returned:
                raise TraceError(f"the {word} does not return the new {name}")
        return list(returned.items())
    if len(wanted) == 1 and isinstance(returned, Value):
        return [(wanted[0], returned)]
    if not isinstance(returned, (tuple, list)):
        raise TraceError(f"the {word} returns one {type(returned).__name__}; it has to return ({shape})")
    if len(returned) != len(wanted):
        raise TraceError(f"the {word} returns {len(returned)} values; it has to return {len(wanted)}: ({shape})")
    return list(zip(wanted, returned))


def _description(function: Step) -> List[str]:
    text = inspect.getdoc(function) if inspect.isfunction(function) or inspect.ismethod(function) else None
    return [" ".join(line.split()) for line in (text or "").split("\n\n")[0].splitlines() if line.strip()]


def _name(function: Step) -> str:
    raw = getattr(function, "__name__", "traced")
    words = re.sub(r"[^a-z0-9]+", "-", raw.lower()).strip("-")
    return words if re.fullmatch(r"[a-z][a-z0-9-]*", words) and raw != "<lambda>" else "traced"


def _checked(name: str) -> str:
    if not re.fullmatch(r"[a-z][a-z0-9-]*", name):
        raise TraceError(f"'{name}' cannot be the name of an integrator: lower-case letters, digits and hyphens, a letter first")
    return name
