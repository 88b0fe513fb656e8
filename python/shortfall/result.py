# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command answers: its JSON, with names to reach it by."""

from __future__ import annotations

import html
import json
import re
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Mapping, Optional, Tuple

from .binary import Call
from .errors import UsageError, error_of
from .formula import Formula

_RATIONAL = re.compile(r"-?\d+(/[1-9]\d*)?")
_FORMULAS = frozenset(
    "position velocity add replace series formula claimed found trace determinant characteristic hamiltonian value".split()
)
_TEXTS = frozenset(
    "schema integrator name claim text latex why reason tree differential hex format title statement digits_text "
    "description version family kind target file obstruction".split()
)
#: Commands that are run again, as text, when their result is printed: quick and the same every time.
_REPEATABLE = frozenset("derive jump correct order modified stability verify audit list show damping spring clock".split())


def _converted(key: str, content: Any) -> Any:
    if isinstance(content, Mapping):
        return Record({k: _converted(k, v) for k, v in content.items()})
    if isinstance(content, list):
        return [_converted(key, item) for item in content]
    if isinstance(content, str) and key not in _TEXTS:
        if _RATIONAL.fullmatch(content):
            return Fraction(content)
        if key in _FORMULAS:
            return Formula(content)
    return content


class Record(Mapping[str, Any]):
    """An object of JSON whose members are attributes too; rationals are Fractions.

    >>> r = Record({"limit": 2})
    >>> r.limit, r["limit"], list(r)
    (2, 2, ['limit'])
    >>> r.limits  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ...
    AttributeError: there is no 'limits' here; there are: limit...
    """

    def __init__(self, members: Dict[str, Any]):
        self._members = members

    def __getattr__(self, name: str) -> Any:
        members = self.__dict__.get("_members", {})
        if name in members:
            return members[name]
        raise AttributeError(f"there is no '{name}' here; there are: {', '.join(members)}")

    def __getitem__(self, name: str) -> Any:
        return self._members[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self._members]

    def __float__(self) -> float:
        for name in ("decimal", "exact"):
            if name in self._members and self._members[name] is not None:
                return float(self._members[name])
        raise TypeError("this is no single number: it has " + ", ".join(self._members))

    def __repr__(self) -> str:
        return "Record(" + ", ".join(f"{k}={v!r}" for k, v in self._members.items()) + ")"


class Result(Record):
    """What a command answered.

    exit_code  0 done; 1 a claim is refuted or a tolerance missed; 4 not derivable, and the answer says why
    raw        the JSON as it came
    """

    def __init__(self, call: Call, raw: Dict[str, Any], exit_code: int):
        super().__init__({k: _converted(k, v) for k, v in raw.items()})
        self.raw = raw
        self.exit_code = exit_code
        self._call = call
        self._text: Optional[str] = None

    @property
    def ok(self) -> bool:
        """Whether the command ended with 0: nothing is refuted, nothing is missing."""
        return self.exit_code == 0

    @property
    def command(self) -> str:
        return self._call.command

    def text(self) -> str:
        """What the command says in a terminal."""
        if self._text is None:
            self._text = self._call.answer().out
        return self._text

    def __str__(self) -> str:
        if self.command in _REPEATABLE:
            return self.text().rstrip("\n")
        return repr(self)

    def __repr__(self) -> str:
        about = ", ".join(f"{k}={v!r}" for k, v in self.items() if k != "schema" and _short(v))
        return f"<shortfall {self.command}: {about}>"

    def records(self, field: Optional[str] = None) -> List[Dict[str, Any]]:
        """The rows of a table in the answer, by default of its first: {column: value}, nested names with dots.

        field  its name: "corrections", "terms"; with dots for inner ones
        """
        if field is None:
            field = next((k for k, v in self.items() if _is_table(v)), None)
            if field is None:
                return [_flat(self)]
        content: Any = self
        for part in field.split("."):
            if not isinstance(content, Mapping) or part not in content:
                tables = ", ".join(k for k, v in self.items() if _is_table(v)) or "none"
                raise UsageError(f"the answer of {self.command} has no table '{field}'; tables: {tables}")
            content = content[part]
        rows = content if isinstance(content, list) else [content]
        return [_flat(row) if isinstance(row, Mapping) else {field: row} for row in rows]

    def to_frame(self, field: Optional[str] = None) -> Any:
        """The same as a DataFrame of pandas."""
        try:
            import pandas
        except ImportError:
            raise ImportError("to_frame() needs pandas, which is not installed; records() gives the same rows") from None
        return pandas.DataFrame(self.records(field))

    def _repr_html_(self) -> str:
        title = html.escape(f"shortfall {self.command}")
        return f"<div class='shortfall'><b>{title}</b>{_html(self)}</div>"

    def _repr_latex_(self) -> Optional[str]:
        steps = self.raw.get("steps")
        if isinstance(steps, list) and steps and all(isinstance(s, dict) and "latex" in s for s in steps):
            lines = []
            for step in steps:
                left, equal, right = step["latex"].partition("=")
                reason = _latex_text(str(step.get("why", "")))
                lines.append(f"{left.strip()} &{equal}{right} && \\text{{{reason}}}")
            return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"
        formulas = [(k, v) for k, v in self.items() if isinstance(v, Formula)]
        if not formulas:
            return None
        return "\\begin{align*}\n" + " \\\\\n".join(f"\\text{{{_latex_text(k)}}} &= {v.latex}" for k, v in formulas) + "\n\\end{align*}"


def _latex_text(text: str) -> str:
    return re.sub(r"([&%$#_{}])", r"\\\1", text.replace("\\", "")).replace("^", r"\^{}").replace("~", r"\~{}")


def _short(content: Any) -> bool:
    return content is not None and not isinstance(content, (Mapping, list)) and len(str(content)) <= 80


def _is_table(content: Any) -> bool:
    return isinstance(content, list) and bool(content) and all(isinstance(row, Mapping) for row in content)


def _flat(record: Mapping[str, Any], prefix: str = "") -> Dict[str, Any]:
    row: Dict[str, Any] = {}
    for key, content in record.items():
        if isinstance(content, Mapping):
            row.update(_flat(content, f"{prefix}{key}."))
        elif prefix + key != "schema":
            row[prefix + key] = content
    return row


def _html(content: Any, depth: int = 0) -> str:
    if isinstance(content, Mapping):
        rows = "".join(
            f"<tr><th style='text-align:left;vertical-align:top'>{html.escape(k)}</th><td style='text-align:left'>{_html(v, depth + 1)}</td></tr>"
            for k, v in content.items() if k not in ("schema", "latex") and v not in (None, [], {}))
        return f"<table>{rows}</table>"
    if _is_table(content):
        columns: List[str] = []
        for row in content:
            columns += [k for k in row if k not in columns and k != "latex"]
        head = "".join(f"<th>{html.escape(c)}</th>" for c in columns)
        body = "".join("<tr>" + "".join(f"<td style='text-align:left'>{_html(row.get(c), depth + 1)}</td>" for c in columns) + "</tr>"
                       for row in content)
        return f"<details{' open' if depth <= 1 and len(content) <= 12 else ''}><summary>{len(content)} rows</summary><table><tr>{head}</tr>{body}</table></details>"
    if isinstance(content, list):
        return html.escape(", ".join(str(item) for item in content))
    if isinstance(content, bool):
        return "yes" if content else "no"
    return "" if content is None else html.escape(str(content)).replace("\n", "<br>")


def answered(call: Call) -> Result:
    """The answer of a call; an exception when there is none."""
    answer = call.answer("--json")
    try:
        raw = json.loads(answer.out) if answer.out.strip() else None
    except ValueError:
        raw = None
    # Refuted claims (1) and what is not derivable (4) are answers, too, where the command gives one.
    if not isinstance(raw, dict) or answer.exit_code not in (0, 1, 4):
        raise error_of(answer.exit_code, answer.err or answer.out)
    return Result(call, raw, answer.exit_code)


__all__: Tuple[str, ...] = ("Record", "Result", "answered")
