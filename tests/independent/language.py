# SPDX-License-Identifier: GPL-3.0-or-later
"""The .integrator language a second time: a reader, and a check of sorts and dimensions. It shares nothing with the
library; see catalogue.py. Made for files that are meant well: limits and messages are not its business."""

import re
from fractions import Fraction


class Bad(Exception):
    """The file is not a valid integrator, or a claim does not hold."""


# --- Expressions: nested tuples ("+", l, r), ("neg", e), ("^", e, n), ("num", q), ("name", s), ("force", x, v, t) ----

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|([A-Za-z_][A-Za-z0-9_]*)|(.))")


def tokens(text):
    found = []
    for line in text.split("\n"):
        line = line.rstrip()
        at = 0
        while at < len(line):
            match = TOKEN.match(line, at)
            at = match.end()
            number, name, sign = match.groups()
            found.append(("num", Fraction(number)) if number else ("name", name) if name else ("sign", sign))
        found.append(("end", "\n"))
    joined, depth = [], 0  # a line goes on inside parentheses and after a final &
    for token in found:
        depth += {("sign", "("): 1, ("sign", ")"): -1}.get(token, 0)
        if token == ("end", "\n") and (depth or not joined or joined[-1] in (("sign", "&"), token)):
            continue
        joined.append(token)
    return joined


class Reader:
    def __init__(self, text):
        self.tokens, self.at = tokens(text), 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")

    def take(self, sign=None):
        token = self.peek()
        if sign and token != ("sign", sign):
            raise Bad(f"expected '{sign}', found '{token[1]}'")
        self.at += 1
        return token

    def name(self):
        kind, text = self.take()
        if kind != "name":
            raise Bad(f"expected a name, found '{text}'")
        return text

    def expression(self):
        left = self.product()
        while self.peek() in (("sign", "+"), ("sign", "-")):
            left = (self.take()[1], left, self.product())
        return left

    def product(self):
        left = self.unary()
        while self.peek() in (("sign", "*"), ("sign", "/")):
            left = (self.take()[1], left, self.unary())
        return left

    def unary(self):
        if self.peek() == ("sign", "-"):
            self.take()
            return ("neg", self.unary())
        return self.power()

    def power(self):
        base = self.atom()
        if self.peek() == ("sign", "^"):
            self.take()
            negative = self.peek() == ("sign", "-") and self.take()
            kind, exponent = self.take()
            if kind != "num" or exponent.denominator != 1:
                raise Bad("an exponent is a whole number")
            return ("^", base, int(-exponent if negative else exponent))
        return base

    def atom(self):
        kind, text = self.take()
        if kind == "num":
            return ("num", text)
        if kind == "name" and text == "a" and self.peek() == ("sign", "("):
            self.take("(")
            arguments = [self.expression()]
            for _ in range(2):
                self.take(",")
                arguments.append(self.expression())
            self.take(")")
            return ("force", *arguments)
        if kind == "name":
            return ("name", text)
        if (kind, text) == ("sign", "("):
            inside = self.expression()
            self.take(")")
            return inside
        raise Bad(f"unexpected '{text.strip() or 'end of line'}'")

    def dimension(self):
        """1, L, L/T, L/T^2, 1/T: a pair of exponents."""
        length = time = 0
        sign = 1
        while True:
            kind, text = self.take()
            exponent = 1
            if self.peek() == ("sign", "^"):
                self.take()
                exponent = int(self.take()[1])
            length += sign * exponent * (text == "L")
            time += sign * exponent * (text == "T")
            if (kind, text) not in (("name", "L"), ("name", "T"), ("num", Fraction(1))):
                raise Bad(f"'{text}' is no dimension")
            if self.peek() not in (("sign", "*"), ("sign", "/")):
                return (length, time)
            sign = 1 if self.take()[1] == "*" else -1

    def statements(self, closing=None):
        """Each is ("set", name, e), ("solve", [(name, dimension, e)]) or ("substeps", count, [statements])."""
        body = []
        while True:
            while self.peek() == ("end", "\n"):
                self.take()
            if self.peek() == ("end", "") or (closing and self.peek() == ("sign", closing)):
                return body
            name = self.name()
            if name == "solve":
                unknowns = [self.unknown()]
                while self.peek() == ("sign", "&"):
                    self.take()
                    unknowns.append(self.unknown())
                body.append(("solve", unknowns))
            elif name == "substeps":
                count = self.take()
                self.take("{")
                inner = self.statements("}")
                self.take("}")
                body.append(("substeps", ("num" if count[0] == "num" else "name", count[1]), inner))
            else:
                self.take("=")
                body.append(("set", name, self.expression()))
            if self.peek()[0] != "end" and not (closing and self.peek() == ("sign", closing)):
                raise Bad(f"unexpected '{self.peek()[1]}' after a statement")

    def unknown(self):
        name = self.name()
        self.take(":")
        dimension = self.dimension()
        self.take("=")
        return (name, dimension, self.expression())


def whole(text):
    """The expression that fills the text."""
    reader = Reader(text)
    expression = reader.expression()
    while reader.peek() == ("end", "\n"):
        reader.take()
    if reader.peek() != ("end", ""):
        raise Bad(f"unexpected '{reader.peek()[1]}' in '{text.strip()}'")
    return expression


# --- Files -----------------------------------------------------------------------------------------------------------

class Integrator:
    def __init__(self, text):
        self.name, self.about, self.aliases, self.sources = None, [], [], []
        self.params, self.states, self.claims = {}, {}, {}
        blocks, block = {}, None
        for raw in text.replace("\r\n", "\n").split("\n"):
            line = raw.split("#")[0].rstrip()
            if self.name is None and raw.startswith("#"):
                self.about.append(raw[1:].strip())
            word, _, rest = line.strip().partition(" ")
            if line.strip() in ("start", "step", "finish", "tableau", "expect"):
                block = line.strip()
                if block in blocks:
                    raise Bad(f"two blocks {block}")
                blocks[block] = []
            elif block:
                blocks[block].append(line)
            elif word:
                self.head(word, rest.strip())
        if self.name is None:
            raise Bad("no integrator line")
        if ("step" in blocks) == ("tableau" in blocks):
            raise Bad("a file has either step or tableau")
        code = {key: Reader("\n".join(lines)).statements() for key, lines in blocks.items()
                if key in ("start", "step", "finish")}
        self.start, self.finish = code.get("start", []), code.get("finish", [])
        self.tableau = self.rows(blocks["tableau"]) if "tableau" in blocks else None
        self.step = code["step"] if "step" in blocks else None
        for line in blocks.get("expect", []):
            word, _, rest = line.strip().partition(" ")
            if not word:
                continue
            if word not in ("exact", "shortfall", "shortfall-velocity") or word in self.claims:
                raise Bad(f"claim '{word}'")
            self.claims[word] = int(rest) if word == "exact" else whole(rest)
        self.check()

    def head(self, word, rest):
        if word == "integrator":
            if self.name or not re.fullmatch(r"[a-z][a-z0-9-]*", rest):
                raise Bad(f"name '{rest}'")
            self.name = rest
        elif word == "alias":
            self.aliases.append(rest)
        elif word == "source":
            self.sources.append(rest)
        elif word == "param":
            left, _, right = rest.partition("=")
            name, _, dimension = (part.strip() for part in left.partition(":"))
            self.params[name] = (Reader(dimension).dimension() if dimension else (0, 0), whole(right))
        elif word == "state":
            name, _, dimension = (part.strip() for part in rest.partition(":"))
            self.states[name] = Reader(dimension).dimension()
        else:
            raise Bad(f"unknown word '{word}'")

    @staticmethod
    def rows(lines):
        rows, weights = [], {}
        for line in lines:
            if not line.strip():
                continue
            left, bar, right = line.partition("|")
            if not bar:
                raise Bad("a row of a tableau has a bar")
            entries = [whole(entry) for entry in right.split()]
            if left.strip() in ("b", "embedded"):
                weights[left.strip()] = entries
            else:
                rows.append((whole(left), entries))
        if "b" not in weights or any(len(entries) > len(rows) for _, entries in rows + list(weights.items())):
            raise Bad("the tableau is not well formed")
        return rows, weights

    # Dimensions and sorts. None as a dimension is that of a bare 0, which fits every one.

    def check(self):
        known = {"h": ("scalar", (0, 1)), "t": ("scalar", (0, 1)), "x": ("vector", (1, 0)), "v": ("vector", (1, -1))}
        for name, (dimension, default) in self.params.items():
            self.expect_type(default, known, ("scalar", dimension))
            known[name] = ("scalar", dimension)
        fixed = set(known) - {"x", "v"}
        started = dict(known)
        self.check_block(self.start, started, fixed)
        for name, dimension in self.states.items():
            if started.get(name) != ("vector", dimension):
                raise Bad(f"state {name} is not started, or not as a {dimension}")
            known[name] = ("vector", dimension)
        for block in (self.step or [], self.finish):
            self.check_block(block, dict(known), fixed)
        claims = {key: value for key, value in known.items() if key in self.params or key in ("h", "t")}
        claims |= {"n": ("scalar", (0, 0)), "a": ("vector", (1, -2))}
        claims |= {"x0": ("vector", (1, 0)), "v0": ("vector", (1, -1))}
        for word, dimension in (("shortfall", (1, 0)), ("shortfall-velocity", (1, -1))):
            if word in self.claims:
                sort, found = self.type_of(self.claims[word], claims)
                if found is not None and (sort, found) != ("vector", dimension):
                    raise Bad(f"{word} is a {sort} of dimension {found}")

    def check_block(self, body, known, fixed):
        for statement in body:
            if statement[0] == "set":
                _, name, expression = statement
                if name in fixed:
                    raise Bad(f"{name} may not be assigned")
                found = self.type_of(expression, known)
                wanted = {"x": ("vector", (1, 0)), "v": ("vector", (1, -1))}.get(name)
                wanted = wanted or (("vector", self.states[name]) if name in self.states else None)
                if wanted and found != wanted:
                    raise Bad(f"{name} is {wanted}, not {found}")
                known[name] = found
            elif statement[0] == "solve":
                known |= {name: ("vector", dimension) for name, dimension, _ in statement[1]}
                for name, dimension, expression in statement[1]:
                    self.expect_type(expression, known, ("vector", dimension))
            else:
                self.check_block(statement[2], known, fixed)

    def expect_type(self, expression, known, wanted):
        found = self.type_of(expression, known)
        if found != wanted and found[1] is not None:
            raise Bad(f"{wanted} expected, {found} found")

    def type_of(self, e, known):
        kind = e[0]
        if kind == "num":
            return ("scalar", None if e[1] == 0 else (0, 0))
        if kind == "name":
            if e[1] not in known:
                raise Bad(f"unknown name {e[1]}")
            return known[e[1]]
        if kind == "neg":
            return self.type_of(e[1], known)
        if kind == "^":
            sort, dimension = self.type_of(e[1], known)
            if sort == "vector":
                raise Bad("a vector has no powers")
            return ("scalar", dimension and (dimension[0] * e[2], dimension[1] * e[2]))
        if kind == "force":
            for argument, wanted in zip(e[1:], (("vector", (1, 0)), ("vector", (1, -1)), ("scalar", (0, 1)))):
                self.expect_type(argument, known, wanted)
            return ("vector", (1, -2))
        left, right = self.type_of(e[1], known), self.type_of(e[2], known)
        if kind in "+-":
            if left[1] is None or right[1] is None:
                return right if left[1] is None else left
            if left != right:
                raise Bad(f"cannot add {left} and {right}")
            return left
        if right[0] == "vector" and (kind == "/" or left[0] == "vector"):
            raise Bad("vectors are neither multiplied nor divided by")
        sign = 1 if kind == "*" else -1
        dimension = left[1] and right[1] and (left[1][0] + sign * right[1][0], left[1][1] + sign * right[1][1])
        return ("vector" if "vector" in (left[0], right[0]) else "scalar", dimension)
