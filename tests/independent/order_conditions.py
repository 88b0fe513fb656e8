#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The order conditions of Runge-Kutta and Nystroem tableaus, written a second time, from the textbook definition.

It shares nothing with the library and needs Python's standard library only. Rooted trees are made as nested tuples; the
elementary weight Phi(t) and the density gamma(t) are computed by their recursive definitions (Butcher 1963; Hairer,
Norsett & Wanner (1993), II.2, Definitions 2.10 and 2.16): a method has order p when Phi(t) = 1/gamma(t) for every tree
with at most p nodes. Nystroem methods for y'' = f(t, y): the special Nystroem trees, with one condition for the position
and one for the velocity (II.14, Theorem 14.13).

Of every file it checks, against what the file claims:

  order, embedded_order   all conditions up to it hold, and one of the next order does not
  stage_order             B(q) and C(q) hold, and not both for q + 1
  c                       the sums of the rows of A
  symplectic, symmetric   b_i a_ij + b_j a_ji = b_i b_j; a_(s+1-i)(s+1-j) + a_ij = b_j. Both ways: a "true" is refuted by
                          one pair that fails, a "false" by their all holding
  A-stable, L-stable      |R| <= 1 at 600 points of the imaginary axis and of the left half plane (numbers: this can only
                          refute; the proof is the library's), R at infinity

Numbers are fractions when all entries are rational. Decimals that stand for other numbers, and square roots, are taken to
120 digits; an equation then holds when its residual is no larger than what one unit of the last printed digit of every
such entry can make of it. The bound is computed, condition by condition, from the same sums with absolute values.

    tests/independent/order_conditions.py [--quiet] [FILE or FOLDER ...]
    tests/independent/order_conditions.py --trees N      how many rooted trees there are
"""

import ast
import json
import math
import re
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
from rooted_trees import density, nystroem_density, nystroem_trees, trees  # noqa: E402

getcontext().prec = 120
SLACK = Decimal(10) ** -100  # of arithmetic with square roots, in units of 1
ROUNDED_FROM = 8  # a decimal with so many digits after the point stands for another number


class Wrong(Exception):
    """The file does not hold what it claims."""


# --- Numbers ---------------------------------------------------------------------------------------------------------

class NumberText(str):
    """A JSON number as it stands in the file."""


def evaluated(node, number):
    """An entry such as 1/4-sqrt(3)/6, as a number of the given type."""
    if isinstance(node, ast.Expression):
        return evaluated(node.body, number)
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        raise AssertionError("numbers are replaced before")
    if isinstance(node, ast.Call) and node.func.id == "n":
        text = node.args[0].value
        return Fraction(text) if number is Fraction else Decimal(text)
    if isinstance(node, ast.Call) and node.func.id == "sqrt":
        inside = evaluated(node.args[0], number)
        if number is Fraction:
            root = Fraction(math.isqrt(inside.numerator), math.isqrt(inside.denominator))
            if root * root != inside:
                raise ValueError("irrational")
            return root
        return inside.sqrt()
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -evaluated(node.operand, number)
    a, b = evaluated(node.left, number), evaluated(node.right, number)
    kind = type(node.op)
    if kind is ast.Pow:
        return a ** int(b)
    return a + b if kind is ast.Add else a - b if kind is ast.Sub else a * b if kind is ast.Mult else a / b


def entry(text, decimals, places_known):
    """The value of an entry as a Fraction, or None when it is irrational; its value as a Decimal; and one unit of its
    last digit when it stands for another number, else 0: a long decimal, or, in a file with `digits`, a long fraction."""
    text = str(text).strip()
    if places_known is not None and re.search(r"\d{%d}" % ROUNDED_FROM, text):
        return None, Decimal(Fraction(text).numerator) / Fraction(text).denominator, Decimal(10) ** -int(places_known)
    digits = re.fullmatch(r"[-+]?\d*\.?(\d*)(?:[eE]([-+]?\d+))?", text)
    places = len(digits[1]) - int(digits[2] or 0) if digits and "." in text else 0
    rounded = bool(digits) and "." in text and (
        len(digits[1]) >= ROUNDED_FROM if decimals is None else decimals == "rounded")
    unit = Decimal(10) ** -places if rounded else Decimal(0)
    tree = ast.parse(re.sub(r"(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)", r'n("\1")', text.replace("^", "**")), mode="eval")
    try:
        exact = evaluated(tree, Fraction)
    except ValueError:
        exact = None
    return exact, evaluated(tree, Decimal), unit


# --- Elementary weights ----------------------------------------------------------------------------------------------

class Weights:
    """The elementary weights of a tableau: for every tree the vector of its stages' values, memoised."""

    def __init__(self, a, one):
        self.a, self.one, self.known = a, one, {}

    def stages(self, tree):
        if tree not in self.known:
            value = [self.one] * len(self.a)
            for child in tree:
                inner = self.stages(child)
                value = [v * sum((w * x for w, x in zip(row, inner) if w), self.one * 0)
                         for v, row in zip(value, self.a)]
            self.known[tree] = value
        return self.known[tree]

    def at_root(self, b, tree):
        return sum((w * x for w, x in zip(b, self.stages(tree)) if w), self.one * 0)


# --- Tableaus --------------------------------------------------------------------------------------------------------

def filled(rows, stages):
    """Rows of A from any of the forms in which a triangular one may be given."""
    if len(rows) == stages - 1:
        rows = [[]] + rows
    lengths = [len(row) for row in rows]
    if lengths not in ([stages] * stages, list(range(stages)), list(range(1, stages + 1))):
        raise Wrong(f"the rows of A have {lengths} entries, b has {stages}")
    return [row + ["0"] * (stages - len(row)) for row in rows]


class Tableau:
    def __init__(self, path):
        data = json.loads(path.read_text(), parse_float=NumberText, parse_int=NumberText)
        self.path, self.claims = path, data
        self.nystroem = data.get("kind") == "nystroem"
        decimals = data.get("decimals")
        stages = len(data["b"])
        table = {"A": filled(data["Abar" if self.nystroem else "A"], stages), "b": [data["b"]]}
        for key in ("bhat", "bbar", "bbarhat", "c"):
            if key in data:
                table[key] = [data[key]]
                if len(data[key]) != stages:
                    raise Wrong(f"{key} has {len(data[key])} entries, b has {stages}")
        read = {key: [[entry(e, decimals, data.get("digits")) for e in row] for row in rows] for key, rows in table.items()}
        entries = [e for rows in read.values() for row in rows for e in row]
        self.exact = all(e[0] is not None and not e[2] for e in entries)
        self.printed = any(e[2] for e in entries)
        self.one = Fraction(1) if self.exact else Decimal(1)
        part = 0 if self.exact else 1
        self.values = {key: [[e[part] for e in row] for row in rows] for key, rows in read.items()}
        self.units = {key: [[e[2] for e in row] for row in rows] for key, rows in read.items()}
        self.a, self.b = self.values["A"], self.values["b"][0]
        self.stages = stages

    def row(self, key):
        return self.values[key][0] if key in self.values else None

    def number(self, claim, missing=None):
        return int(self.claims[claim]) if claim in self.claims else missing

    def zero(self, residual, bound):
        """Whether a residual is zero, or cannot be told from zero."""
        return residual == 0 if self.exact else abs(residual) <= bound + SLACK

    def sizes(self, key):
        """|entries|, and the same with one unit of the last printed digit more."""
        small = [[abs(e) for e in row] for row in self.values[key]]
        return small, [[e + u for e, u in zip(r, s)] for r, s in zip(small, self.units[key])]


class Conditions:
    """The residuals of the conditions of a weight vector, and how large they may be."""

    def __init__(self, tableau, key):
        self.t, self.b, self.key = tableau, tableau.row(key), key
        self.weights = Weights(tableau.a, tableau.one)
        if not tableau.exact:
            (self.small, self.large) = (Weights(m, tableau.one) for m in tableau.sizes("A"))
            (self.b_small, self.b_large) = (m[0] for m in tableau.sizes(key))

    def fails(self, tree, density_):
        residual = self.weights.at_root(self.b, tree) - self.t.one / density_
        bound = 0 if self.t.exact else self.large.at_root(self.b_large, tree) - self.small.at_root(self.b_small, tree)
        return not self.t.zero(residual, bound)

    def broken(self, order):
        """A tree of this order whose condition fails, or None."""
        return next((t for t in trees(order) if self.fails(t, density(t))), None)

    def order(self, highest):
        for order in range(1, highest + 1):
            if self.broken(order) is not None:
                return order - 1
        return highest


def check_order(conditions, claimed, what):
    found = conditions.order(claimed + 1)
    if found == claimed:
        return
    broken = conditions.broken(found + 1) if found < claimed else None
    raise Wrong(f"{what} {claimed} is claimed, the conditions say " +
                (f"{found}; the tree {broken} fails" if broken is not None else f"at least {claimed + 1}"))


def check_row_sums(t):
    c = t.row("c")
    if c is None:
        return
    for i, (row, units) in enumerate(zip(t.a, t.units["A"])):
        bound = sum(units) + t.units["c"][0][i]
        if not t.zero(sum(row) - c[i], bound):
            raise Wrong(f"c[{i + 1}] = {c[i]}, but row {i + 1} of A has the sum {sum(row)}")


def power(x, n, one):
    return one if n == 0 else x * power(x, n - 1, one)


def stage_order(t):
    """The largest q with B(q) and C(q), from c = A 1."""
    def residuals(a, b, k, sign):
        """Row sums of w c^(k-1) and the right-hand sides c^k / k, subtracted or (for a bound) added."""
        c = [sum(row) for row in a]
        rows = [(row, power(ci, k, t.one)) for row, ci in zip(a, c)] + [(b, t.one)]
        return [sum(w * power(cj, k - 1, t.one) for w, cj in zip(row, c)) + sign * right / k for row, right in rows]

    q = 0
    while q < 2 * t.stages:
        found = residuals(t.a, t.b, q + 1, -1)
        bounds = [0] * len(found)
        if not t.exact:
            (a, a_more), (b, b_more) = t.sizes("A"), t.sizes("b")
            bounds = [y - x for x, y in zip(residuals(a, b[0], q + 1, 1), residuals(a_more, b_more[0], q + 1, 1))]
        if not all(map(t.zero, found, bounds)):
            return q
        q += 1
    return q


def all_zero(t, residual):
    """Whether residual(a, b, sign) vanishes for all pairs of stages; with sign 1 and absolute values it is a bound."""
    s = range(t.stages)
    bounds = {}
    if not t.exact:
        (a, a_more), (b, b_more) = t.sizes("A"), t.sizes("b")
        bounds = {(i, j): residual(a_more, b_more[0], i, j, 1) - residual(a, b[0], i, j, 1) for i in s for j in s}
    return all(t.zero(residual(t.a, t.b, i, j, -1), bounds.get((i, j), 0)) for i in s for j in s)


def is_symplectic(t):
    return all_zero(t, lambda a, b, i, j, sign: b[i] * a[i][j] + b[j] * a[j][i] + sign * b[i] * b[j])


def is_symmetric(t):
    """The stages in reverse give the adjoint; methods whose stages have to be permuted otherwise are not among these."""
    last = t.stages - 1
    return all_zero(t, lambda a, b, i, j, sign: a[last - i][last - j] + a[i][j] + sign * b[j])


def solved(matrix, right):
    """Gaussian elimination with complex numbers."""
    n = len(right)
    m = [list(row) + [r] for row, r in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(m[i][k]))
        m[k], m[pivot] = m[pivot], m[k]
        if abs(m[k][k]) < 1e-300:
            return None
        for i in range(n):
            if i != k and m[i][k]:
                factor = m[i][k] / m[k][k]
                m[i] = [x - factor * y for x, y in zip(m[i], m[k])]
    return [m[i][n] / m[i][i] for i in range(n)]


def stability(t, z):
    """R(z) = 1 + z b (1 - z A)^-1 1."""
    a = [[float(e) for e in row] for row in t.a]
    matrix = [[(i == j) - z * a[i][j] for j in range(t.stages)] for i in range(t.stages)]
    k = solved(matrix, [1.0] * t.stages)
    return math.inf if k is None else 1 + z * sum(float(w) * x for w, x in zip(t.b, k))


def check_stability(t):
    points = [complex(-re, 10 ** (e / 20)) for re in (0, 0.3, 3, 30) for e in range(-40, 60)]
    points += [-10 ** (e / 50) for e in range(-100, 100)]  # where the poles of diagonally implicit methods lie
    within = all(abs(stability(t, z)) <= 1 + 1e-9 for z in points)
    if "A-stable" in t.claims and t.claims["A-stable"] != within:
        raise Wrong(f"A-stable is claimed {t.claims['A-stable']}, the points say {within}")
    if "L-stable" in t.claims:
        vanishes = within and abs(stability(t, -1e9)) < 1e-6
        if t.claims["L-stable"] != vanishes:
            raise Wrong(f"L-stable is claimed {t.claims['L-stable']}, R(-1e9) says {vanishes}")


# --- Nystroem methods ------------------------------------------------------------------------------------------------

def nystroem_stages(t, tree, known):
    if tree not in known:
        c = t.row("c")
        value = [t.one] * t.stages
        for child in tree:
            inner = c if child is None else [
                sum((w * x for w, x in zip(row, nystroem_stages(t, child, known))), t.one * 0) for row in t.a]
            value = [v * x for v, x in zip(value, inner)]
        known[tree] = value
    return known[tree]


def nystroem_order(t, b, bbar, highest):
    """The smaller of the orders of position and velocity."""
    known = {}
    worst = max((u for rows in t.units.values() for row in rows for u in row), default=Decimal(0))
    for order in range(1, highest + 1):
        bound = 0 if t.exact else worst * 100
        for tree in nystroem_trees(order):
            phi = nystroem_stages(t, tree, known)
            velocity = sum(w * x for w, x in zip(b, phi)) - t.one / nystroem_density(tree)
            if not t.zero(velocity, bound):
                return order - 1
        for tree in nystroem_trees(order - 1) if order > 1 else []:
            phi = nystroem_stages(t, tree, known)
            position = sum(w * x for w, x in zip(bbar, phi)) - t.one / (nystroem_density(tree) * order)
            if not t.zero(position, bound):
                return order - 1
    return highest


# --- Files -----------------------------------------------------------------------------------------------------------

def check(path):
    t = Tableau(path)
    for key in ("name", "source", "order"):
        if key not in t.claims:
            raise Wrong(f"the key {key} is missing")
    if t.claims["name"] != path.stem:
        raise Wrong(f"the file is called {path.name} and the method {t.claims['name']}")
    if t.nystroem:
        for claim, b, bbar in (("order", "b", "bbar"), ("embedded_order", "bhat", "bbarhat")):
            if claim in t.claims:
                found = nystroem_order(t, t.row(b), t.row(bbar), t.number(claim) + 1)
                if found != t.number(claim):
                    raise Wrong(f"{claim} {t.number(claim)} is claimed, the conditions say {found}")
        return t
    check_row_sums(t)
    check_order(Conditions(t, "b"), t.number("order"), "order")
    if ("bhat" in t.claims) != ("embedded_order" in t.claims):
        raise Wrong("bhat and embedded_order stand together")
    if "bhat" in t.claims:
        check_order(Conditions(t, "bhat"), t.number("embedded_order"), "embedded_order")
    if "stage_order" in t.claims and stage_order(t) != t.number("stage_order"):
        raise Wrong(f"stage_order {t.number('stage_order')} is claimed, it is {stage_order(t)}")
    for claim, test in (("symplectic", is_symplectic), ("symmetric", is_symmetric)):
        if claim in t.claims and t.claims[claim] != test(t):
            raise Wrong(f"{claim} is claimed {t.claims[claim]}, the equations say {test(t)}")
    check_stability(t)
    return t


def main(arguments):
    if arguments[:1] == ["--trees"]:
        print(len(trees(int(arguments[1]))))
        return 0
    quiet = "--quiet" in arguments
    paths = [Path(a) for a in arguments if a != "--quiet"]
    files = sorted(f for p in paths for f in (p.glob("*.json") if p.is_dir() else [p]))
    counts = [len(trees(n)) for n in range(1, 11)]
    if counts != [1, 1, 2, 4, 9, 20, 48, 115, 286, 719]:  # Cayley (1857); the On-Line Encyclopedia, A000081
        raise SystemExit("the trees are wrong")
    if [len(nystroem_trees(n)) for n in range(1, 11)] != [1, 1, 2, 3, 6, 10, 20, 36, 72, 137]:
        raise SystemExit("the Nystroem trees are wrong")
    failed = exact = 0
    for file in files:
        try:
            t = check(file)
            exact += t.exact
            kind = "exact" if t.exact else "to the digits printed" if t.printed else "to 100 digits"
            if not quiet:
                print(f"ok    {file.name}: order {t.claims['order']}, {t.stages} stages, {kind}")
        except Wrong as wrong:
            failed += 1
            print(f"WRONG {file.name}: {wrong}")
    print(f"{len(files) - failed} tableaus hold what they claim ({exact} exactly), {failed} do not")
    return 1 if failed or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
