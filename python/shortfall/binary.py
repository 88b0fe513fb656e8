# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the command is, and how it is called."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Callable, List, Mapping, NamedTuple, Optional, Sequence, Union

from .errors import BinaryNotFound, ShortfallError, UsageError
from .number import number_text
from .tracing import Integrator, trace

#: A name, a path, a traced integrator, or a Python function that is traced.
IntegratorLike = Union[str, "os.PathLike[str]", Integrator, Callable[..., Any]]


def binary() -> str:
    """The path of the command: the environment variable SHORTFALL, the PATH, or a build tree beside this package."""
    named = os.environ.get("SHORTFALL")
    if named:
        found = shutil.which(named)
        if found is None:
            raise BinaryNotFound(f"the environment variable SHORTFALL says '{named}', which is no program that can be run")
        return found
    found = shutil.which("shortfall")
    if found is not None:
        return found
    root = Path(__file__).resolve().parents[2]
    for candidate in (root / "build" / "release" / "shortfall", *sorted(root.glob("build/*/shortfall"))):
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    raise BinaryNotFound(
        "the command shortfall was not found: put it on your PATH, or its path into the environment variable SHORTFALL"
    )


class Answer(NamedTuple):
    """What the command wrote, and how it ended."""

    out: str
    err: str
    exit_code: int


class Call(NamedTuple):
    """A command with its arguments, to be run as JSON or as text."""

    command: str
    arguments: Sequence[Any]
    options: Mapping[str, Any]
    timeout: Optional[float]

    def answer(self, *more: str) -> Answer:
        with tempfile.TemporaryDirectory(prefix="shortfall-") as folder:
            words = [self.command]
            for position, argument in enumerate(self.arguments):
                words.append(_argument(argument, folder, str(position)))
            words += option_words(self.options)
            try:
                done = subprocess.run(
                    [binary(), *words, *more], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                    encoding="utf-8", errors="replace", timeout=self.timeout,
                )
            except subprocess.TimeoutExpired:
                raise ShortfallError(f"shortfall {self.command} took longer than {self.timeout} s") from None
            except ValueError as error:  # a NUL in an argument
                raise UsageError(f"shortfall {self.command}: {error}", 2) from None
            # A traced function has no file of its own.
            own = re.compile(re.escape(folder + os.sep) + r"\d+" + re.escape(os.sep))
            return Answer(own.sub("", done.stdout), own.sub("", done.stderr), done.returncode)


def _argument(argument: Any, folder: str, position: str) -> str:
    if isinstance(argument, Integrator) or (callable(argument) and not isinstance(argument, (str, os.PathLike))):
        integrator = argument if isinstance(argument, Integrator) else trace(argument)
        path = Path(folder) / position / f"{integrator.name}.integrator"  # two of them may have one name
        path.parent.mkdir()
        integrator.save(path)
        return str(path)
    if not isinstance(argument, (str, os.PathLike)):
        raise UsageError(
            f"a {type(argument).__name__} is no integrator; give a name, the path of a file, or a function of x, v, t, a, h"
        )
    word = os.fspath(argument)
    # A name that begins like an option would be read as one.
    return os.path.join(os.curdir, word) if word.startswith("-") else word


def option_words(options: Mapping[str, Any]) -> List[str]:
    """Keyword arguments as the command's options.

    >>> from fractions import Fraction
    >>> option_words({"force": "spring:k=4", "dt": Fraction(1, 10), "param": {"beta": 0.25}, "full": True, "g": None})
    ['--force=spring:k=4', '--dt=1/10', '--param=beta=0.25', '--full']
    >>> option_words({"all_engines": True, "formats": ["f32", "f64"]})
    ['--all-engines', '--formats=f32,f64']

    A list of lists gives the option again and again; where its name is a word of Python, it gets an underscore.

    >>> option_words({"from_": [(1, 0), (2, "1/2")], "dt": "1/2"})
    ['--from=1,0', '--from=2,1/2', '--dt=1/2']
    """
    words: List[str] = []
    for name, content in options.items():
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
            raise UsageError(f"'{name}' is no option", 2)
        option = "--" + name.rstrip("_").replace("_", "-")
        if content is None or content is False:
            continue
        if content is True:
            words.append(option)
        elif isinstance(content, Mapping):
            words += [f"{option}={key}={_text(item)}" for key, item in content.items()]
        elif isinstance(content, (list, tuple)) and content and all(isinstance(item, (list, tuple)) for item in content):
            for item in content:
                words += option_words({name: item})
        elif isinstance(content, (list, tuple)):
            words.append(f"{option}={','.join(_text(item) for item in content)}")
        else:
            words.append(f"{option}={_text(content)}")
    return words


def _text(content: Any) -> str:
    if isinstance(content, (str, os.PathLike)):
        return os.fspath(content)
    return number_text(content)
