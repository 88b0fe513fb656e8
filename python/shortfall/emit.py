# SPDX-License-Identifier: GPL-3.0-or-later
"""Traced values as statements of the .integrator language."""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import Dict, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from .errors import TraceError
from .value import Value

_SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(5)
_SIGNS = {"add": (" + ", _SUM), "subtract": (" - ", _SUM), "multiply": ("*", _PRODUCT), "divide": ("/", _PRODUCT)}

#: Longer formulas are cut into named lines.
LONGEST_FORMULA = 16
#: More operations are no step that anybody wrote down.
MOST_OPERATIONS = 20000
#: Names that mean something in the language.
TAKEN = frozenset(
    "a x v h t n integrator alias source param root of near approx state impulse hold assume solves start step finish "
    "tableau splitting expect solve substeps limit speed move when kick drift embedded sqrt exp pow max min log sin "
    "cos sinh cosh acos acosh atan sum".split()
)


def unused(stem: str, taken: Set[str]) -> str:
    """The first of stem1, stem2, ... that is free; taken from then on."""
    name = next(n for n in (f"{stem}{i}" for i in itertools.count(1)) if n not in taken)
    taken.add(name)
    return name


def expression(top: Value, names: Optional[Mapping[int, str]] = None) -> str:
    """A value as a formula; values whose id has a name are said by it."""
    return _piece(top, names or {}, top)[0]


def _piece(node: Value, names: Mapping[int, str], top: Value) -> Tuple[str, int]:
    if node is not top and id(node) in names:
        return names[id(node)], _ATOM

    def bound(operand: Value, least: int, signed: bool = False) -> str:
        text, binding = _piece(operand, names, top)
        return f"({text})" if binding < least or (text.startswith("-") and not signed) else text

    if node.op == "number":
        if "/" in node.text:
            return node.text, _PRODUCT
        return node.text, _SIGN if node.text.startswith("-") else _ATOM
    if node.op in ("name", "approx"):
        return names.get(id(node), node.text), _ATOM
    if node.op == "negate":
        return "-" + bound(node.operands[0], _SIGN), _SIGN
    if node.op == "power":
        return f"{bound(node.operands[0], _ATOM)}^{node.text}", _POWER
    if node.op in ("force", "call"):
        return f"{node.text}({', '.join(_piece(o, names, top)[0] for o in node.operands)})", _ATOM
    sign, binding = _SIGNS[node.op]
    left, right = node.operands
    return bound(left, binding, signed=True) + sign + bound(right, binding + 1), binding


class _Graph:
    """The values that lead to some results, each once however often it was computed, operands first."""

    def __init__(self, results: Iterable[Value]):
        self.nodes: List[Value] = []
        self._known: Dict[tuple, Value] = {}
        self._of: Dict[int, Value] = {}
        self._kept: List[Value] = []  # ids stay theirs
        self.results = [self._unique(result) for result in results]
        self.uses: Dict[int, int] = {id(node): 0 for node in self.nodes}
        for node in self.nodes:
            for operand in node.operands:
                self.uses[id(operand)] += 1
        for result in self.results:
            self.uses[id(result)] += 1
        self.named = self._to_name()

    def _unique(self, top: Value) -> Value:
        stack = [top]
        while stack:
            node = stack[-1]
            if id(node) in self._of:
                stack.pop()
                continue
            left = [operand for operand in node.operands if id(operand) not in self._of]
            if left:
                stack.extend(reversed(left))
                continue
            stack.pop()
            operands = tuple(self._of[id(operand)] for operand in node.operands)
            key = (node.op, node.text, tuple(id(operand) for operand in operands))
            if key not in self._known:
                if len(self.nodes) >= MOST_OPERATIONS:
                    raise TraceError(
                        f"the step makes more than {MOST_OPERATIONS} operations; write loops as `substeps` in the "
                        ".integrator language"
                    )
                unique = Value(node.op, operands, node.text, node.sort, node.trace)
                self._known[key] = unique
                self.nodes.append(unique)
            self._kept.append(node)
            self._of[id(node)] = self._known[key]
        return self._of[id(top)]

    def _to_name(self) -> Set[int]:
        """Values that are used more than once, or that would make a formula too long."""
        named: Set[int] = set()
        size: Dict[int, int] = {}
        for node in self.nodes:
            if not node.operands:
                size[id(node)] = 0
                continue
            size[id(node)] = 1 + sum(0 if id(o) in named else size[id(o)] for o in node.operands)
            cheap = node.sort == "scalar" and size[id(node)] <= 2
            if (self.uses[id(node)] > 1 and not cheap) or size[id(node)] > LONGEST_FORMULA:
                named.add(id(node))
        return named

    def before(self, top: Value, known: Mapping[int, str]) -> List[Value]:
        """The named values that a formula needs and that have no name yet, in their order."""
        found: Set[int] = set()
        seen: Set[int] = set()
        stack = list(top.operands)
        while stack:
            node = stack.pop()
            if id(node) in seen or id(node) in known:
                continue
            seen.add(id(node))
            if id(node) in self.named:
                found.add(id(node))
            stack.extend(node.operands)
        return [node for node in self.nodes if id(node) in found]


class _Overwritten(Exception):
    """A formula would read what has been assigned already."""


def statements(targets: Sequence[str], results: Sequence[Value], taken: Set[str], approximations: Dict[str, str]) -> List[str]:
    """Lines that give each target its result.

    param  taken           names that are not free
    param  approximations  from decimals to their names; gets those that are new
    """
    graph = _Graph(results)
    base: Dict[int, str] = {}
    for node in graph.nodes:
        if node.op == "approx":
            if node.text not in approximations:
                approximations[node.text] = unused("c", taken)
            base[id(node)] = approximations[node.text]
    pairs = [(t, r) for t, r in zip(targets, graph.results) if not (r.op == "name" and r.text == t)]
    best: Optional[List[str]] = None
    orders: Iterable[Tuple[Tuple[str, Value], ...]] = itertools.permutations(pairs) if len(pairs) <= 4 else [tuple(pairs)]
    for order in orders:
        try:
            lines = _lines(graph, order, base, set(taken))
        except _Overwritten:
            continue
        if best is None or len(lines) < len(best):
            best = lines
    return best if best is not None else _through_copies(graph, pairs, base, set(taken))


def _reads(node: Value, names: Mapping[int, str]) -> Set[str]:
    """The names of the step's own variables in a formula."""
    found: Set[str] = set()
    stack = [node]
    first = True
    while stack:
        here = stack.pop()
        if not first and id(here) in names:
            continue
        first = False
        if here.op == "name":
            found.add(here.text)
        stack.extend(here.operands)
    return found


def _lines(graph: _Graph, order: Sequence[Tuple[str, Value]], base: Mapping[int, str], taken: Set[str]) -> List[str]:
    names = dict(base)
    overwritten: Set[str] = set()
    lines: List[str] = []

    def say(name: str, node: Value) -> None:
        if id(node) in names and node.op != "approx":
            lines.append(f"{name} = {names[id(node)]}")
            return
        if _reads(node, names) & overwritten:
            raise _Overwritten
        lines.append(f"{name} = {expression(node, names)}")

    for target, result in order:
        for node in graph.before(result, names):
            local = _local(node, taken)
            say(local, node)
            names[id(node)] = local
        say(target, result)
        overwritten.add(target)
        if result.operands and id(result) not in names:
            names[id(result)] = target
    return lines


def _through_copies(graph: _Graph, pairs: Sequence[Tuple[str, Value]], base: Mapping[int, str], taken: Set[str]) -> List[str]:
    """The last one needs no copy: nothing is read after it."""
    copies = []
    for target, _ in pairs[:-1]:
        copies.append(f"{target}_new" if f"{target}_new" not in taken else unused(f"{target}_new", taken))
        taken.add(copies[-1])
    lines = _lines(graph, [(t, result) for t, (_, result) in zip([*copies, pairs[-1][0]], pairs)], base, taken)
    return lines + [f"{target} = {copy}" for copy, (target, _) in zip(copies, pairs)]


def _local(node: Value, taken: Set[str]) -> str:
    if node.op == "force":
        return unused("a", taken)
    return unused("u" if node.sort == "vector" else "s", taken)
