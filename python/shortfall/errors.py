# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong, one class for each exit code of the command."""

from __future__ import annotations

from typing import Dict, Optional, Type


class ShortfallError(Exception):
    """Something that shortfall says instead of an answer: one sentence, and the command's exit code.

    >>> error = error_of(4, "shortfall: no launch exists")
    >>> error.exit_code, error.message, type(error).__name__
    (4, 'no launch exists', 'NotDerivable')
    """

    exit_code: Optional[int] = None

    def __init__(self, message: str, exit_code: Optional[int] = None):
        super().__init__(message)
        self.message = message
        if exit_code is not None:
            self.exit_code = exit_code


class BinaryNotFound(ShortfallError):
    """The command is not where it was looked for."""


class TraceError(ShortfallError, TypeError):
    """A Python function that does something that an integrator cannot do."""


class Refuted(ShortfallError):
    """A claim is refuted, or a tolerance missed."""

    exit_code = 1


class UsageError(ShortfallError, ValueError):
    """An argument that the command does not take."""

    exit_code = 2


class BadInputFile(ShortfallError, ValueError):
    """A file, or a traced function, with a mistake in it."""

    exit_code = 3


class NotDerivable(ShortfallError):
    """There is no such thing, or it is out of shortfall's reach; the message says why."""

    exit_code = 4


class FileError(ShortfallError, OSError):
    """A file cannot be read or written."""

    exit_code = 5

    def __str__(self) -> str:
        return self.message


class InternalError(ShortfallError):
    """A bug of shortfall's own."""

    exit_code = 70


_CLASSES: Dict[int, Type[ShortfallError]] = {
    c.exit_code: c for c in (Refuted, UsageError, BadInputFile, NotDerivable, FileError, InternalError) if c.exit_code
}


def error_of(exit_code: int, text: str) -> ShortfallError:
    """The exception for what the command wrote to its standard error."""
    message = text.strip()
    if message.startswith("shortfall: "):
        message = message[len("shortfall: ") :]
    if not message:
        message = f"shortfall ended with exit code {exit_code} and said nothing"
    return _CLASSES.get(exit_code, ShortfallError)(message, exit_code)
