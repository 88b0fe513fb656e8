# SPDX-License-Identifier: GPL-3.0-or-later
"""The .integrator language a second time: a reader of files, and a check of sorts and dimensions. It shares nothing with
the library; see catalogue.py. Made for files that are meant well: limits and messages are not its business."""

import re
from fractions import Fraction

from expressions import Bad, Reader, whole


class Integrator:
    def __init__(self, text):
        self.name, self.about, self.aliases, self.sources = None, [], [], []
        self.params, self.states, self.claims = {}, {}, {}
        self.series_claims = {}  # (word, forces): number or True
        self.roots, self.approximations, self.impulse, self.hold = {}, {}, None, False
        self.assumptions, self.solves = [], None
        self.irrational = bool(re.search(r"^(?! *limit).*\b(sqrt|exp|pow|log) *\(|^ *root ", text, re.M))
        blocks, block = {}, None
        for raw in text.replace("\r\n", "\n").split("\n"):
            line = raw.split("#")[0].rstrip()
            if self.name is None and raw.startswith("#"):
                self.about.append(raw[1:].strip())
            word, _, rest = line.strip().partition(" ")
            if line.strip() in ("start", "step", "finish", "tableau", "splitting", "expect"):
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
        if sum(block in blocks for block in ("step", "tableau", "splitting")) != 1:
            raise Bad("a file has one of step, tableau, splitting")
        code = {key: Reader("\n".join(lines)).statements() for key, lines in blocks.items()
                if key in ("start", "step", "finish")}
        self.start, self.finish = code.get("start", []), code.get("finish", [])
        self.tableau = self.rows(blocks["tableau"]) if "tableau" in blocks else None
        self.step = code["step"] if "step" in blocks else None
        if "splitting" in blocks:
            self.step = self.lowered(blocks["splitting"])
        for line in blocks.get("expect", []):
            word, _, rest = line.strip().partition(" ")
            if not word:
                continue
            if word in ("order", "embedded-order", "symplectic", "symmetric"):
                self.claim_of_series(word, rest.strip())
                continue
            if word not in ("exact", "shortfall", "shortfall-velocity", "trace", "determinant", "limit") \
                    or word in self.claims:
                raise Bad(f"claim '{word}'")
            if word == "limit":
                self.printed_limit = rest.strip()
            self.claims[word] = int(rest) if word == "exact" else whole(rest)
        self.check()

    def claim_of_series(self, word, rest):
        """order P, order P if a(x, t), embedded-order P, symplectic, symmetric."""
        number, _, forces = rest.partition(" if ")
        key = (word, forces.replace(" ", ""))
        if key in self.series_claims or (word.startswith("sym") and rest):
            raise Bad(f"claim '{word} {rest}'")
        if key[1] not in ("", "a(x,v,t)", "a(x,t)", "a(x,v)", "a(x)", "a(t)", "T(p)+V(q)"):
            raise Bad(f"forces '{forces}'")
        self.series_claims[key] = int(number) if number else True

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
        elif word == "root":
            match = re.fullmatch(r"(\w+) of (.*)=(.*?)(?: near (\S+))?", rest)
            if not match:
                raise Bad(f"root '{rest}'")
            name, left, right, near = match.groups()
            self.roots[name] = (whole(left), whole(right), near and Fraction(near))
        elif word == "approx":
            name, _, decimal = (part.strip() for part in rest.partition("="))
            if not re.fullmatch(r"-?\d+\.\d+", decimal):
                raise Bad(f"approx '{rest}'")
            self.approximations[name] = decimal
        elif word == "impulse":
            name, _, dimension = (part.strip() for part in rest.partition(":"))
            if self.impulse or Reader(dimension).dimension() != (1, -1):
                raise Bad(f"impulse '{rest}'")
            self.impulse = name
        elif word == "hold" and rest == "a":
            self.hold = True
        elif word == "assume":
            left, sign, right = re.fullmatch(r"([^<>]*)([<>])([^<>]*)", rest).groups()
            self.assumptions.append(("-", whole(left), whole(right)) if sign == ">" else ("-", whole(right), whole(left)))
        elif word == "solves" and not self.solves:
            self.solves = whole(rest)
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

    @staticmethod
    def lowered(lines):
        """The statements of a splitting: time advances with the drifts."""
        body, time = [], ("name", "t")
        for line in lines:
            word, _, rest = line.strip().partition(" ")
            if not word:
                continue
            part = ("*", whole(rest), ("name", "h"))
            if word == "kick":
                force = ("force", ("name", "x"), ("name", "v"), time)
                body.append(("set", "v", ("+", ("name", "v"), ("*", part, force))))
            elif word == "drift":
                body.append(("set", "x", ("+", ("name", "x"), ("*", part, ("name", "v")))))
                time = ("+", time, part)
            else:
                raise Bad(f"'{word}' in a splitting")
        if not body:
            raise Bad("a splitting without rows")
        return body

    # Dimensions and sorts. None as a dimension is that of a bare 0, which fits every one.

    def check(self):
        known = {"h": ("scalar", (0, 1)), "t": ("scalar", (0, 1)), "x": ("vector", (1, 0)), "v": ("vector", (1, -1))}
        for name, (dimension, default) in self.params.items():
            if self.type_of(default, known) != ("scalar", (0, 0)):  # a bare number is one in metres and seconds
                self.expect_type(default, known, ("scalar", dimension))
            known[name] = ("scalar", dimension)
        for name in (*self.roots, *self.approximations):
            if name in known:
                raise Bad(f"{name} is declared twice")
            known[name] = ("scalar", (0, 0))
        for name, (left, right, _) in self.roots.items():
            for side in (left, right):
                self.expect_type(side, {name: ("scalar", (0, 0))}, ("scalar", (0, 0)))
        scalars = {key: value for key, value in known.items() if key not in ("x", "v")}
        for difference in self.assumptions:
            self.type_of(difference, scalars)
        if self.solves:
            self.expect_type(self.solves, {key: value for key, value in known.items() if key != "h"},
                             ("vector", (1, -2)))
        if self.impulse:
            known[self.impulse] = ("vector", (1, -1))
        fixed = set(known) - {"x", "v"}
        started = dict(known)
        self.check_block(self.start, started, fixed)
        for name, dimension in self.states.items():
            if started.get(name) != ("vector", dimension):
                raise Bad(f"state {name} is not started, or not as a {dimension}")
            known[name] = ("vector", dimension)
        for block in (self.step or [], self.finish):
            self.check_block(block, dict(known), fixed)
        claims = {key: value for key, value in known.items() if value[0] == "scalar"}
        claims |= {"n": ("scalar", (0, 0)), "a": ("vector", (1, -2))}
        claims |= {"x0": ("vector", (1, 0)), "v0": ("vector", (1, -1))}
        for word, dimension in (("shortfall", (1, 0)), ("shortfall-velocity", (1, -1))):
            if word in self.claims:
                sort, found = self.type_of(self.claims[word], claims)
                if found is not None and (sort, found) != ("vector", dimension):
                    raise Bad(f"{word} is a {sort} of dimension {found}")
        claims |= {"w": ("scalar", (0, -1)), "z": ("scalar", (0, 0)), "infinity": ("scalar", (0, 0))}
        for word in ("trace", "determinant", "limit"):
            if word in self.claims:
                self.expect_type(self.claims[word], claims, ("scalar", (0, 0)))

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
            elif statement[0] == "limit":
                self.expect_measure(statement[2], known, (1, -1) if statement[1] == "speed" else (1, 0))
            elif statement[0] == "when":
                self.expect_measure(statement[1], known, (1, -1))
                self.check_block(statement[2], dict(known), fixed)
            else:
                self.check_block(statement[2], known, fixed)

    def expect_measure(self, expression, known, dimension):
        """A speed or a length; a bare number is one in m/s or m."""
        if self.type_of(expression, known) not in (("scalar", dimension), ("scalar", (0, 0)), ("scalar", None)):
            raise Bad(f"a scalar of dimension {dimension} expected")

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
        if kind == "call":
            types = [self.type_of(argument, known) for argument in e[2]]
            if any(sort != "scalar" for sort, _ in types):
                raise Bad(f"{e[1]} takes scalars")
            dimensions = [dimension for _, dimension in types]
            if e[1] == "sqrt":
                return ("scalar", dimensions[0] and tuple(Fraction(d) / 2 for d in dimensions[0]))
            if e[1] in ("max", "min"):
                given = [dimension for dimension in dimensions if dimension is not None]
                if any(dimension != given[0] for dimension in given):
                    raise Bad(f"{e[1]} compares alike")
                return ("scalar", given[0] if given else None)
            if dimensions[0] not in (None, (0, 0)) or (e[1] == "pow" and dimensions[1] not in (None, (0, 0), (0, 1))):
                raise Bad(f"dimensions of {e[1]}")
            return ("scalar", (0, -1) if e[1] == "log" else (0, 0))
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
