# SPDX-License-Identifier: GPL-3.0-or-later
"""The expressions and statements of the .integrator language a second time: a reader that shares nothing with the library.

An expression is a nested tuple: ("+", l, r), ("neg", e), ("^", e, n), ("num", q), ("name", s), ("force", x, v, t),
("call", function, arguments)."""

import re
from fractions import Fraction


class Bad(Exception):
    """The file is not a valid integrator, or a claim does not hold."""


FUNCTIONS = {"sqrt": 1, "exp": 1, "log": 1, "pow": 2, "max": 2, "min": 2}

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
            inside = self.peek() == ("sign", "(") and self.take()
            negative = self.peek() == ("sign", "-") and self.take()
            kind, exponent = self.take()
            if inside:
                self.take(")")
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
        if kind == "name" and text in FUNCTIONS and self.peek() == ("sign", "("):
            self.take("(")
            arguments = [self.expression()]
            while self.peek() == ("sign", ","):
                self.take(",")
                arguments.append(self.expression())
            self.take(")")
            if len(arguments) != FUNCTIONS[text]:
                raise Bad(f"{text} takes {FUNCTIONS[text]} values")
            return ("call", text, arguments)
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
        """Each is ("set", name, e), ("solve", [(name, dimension, e)]), ("substeps", count, [statements]),
        ("limit", "speed" or "move", e) or ("when", e, [statements])."""
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
            elif name == "limit":
                what = self.name()
                if what not in ("speed", "move"):
                    raise Bad(f"limit {what}")
                body.append(("limit", what, self.expression()))
            elif name == "when":
                if self.name() != "speed":
                    raise Bad("when compares the speed")
                self.take(">")
                speed = self.expression()
                self.take("{")
                inner = self.statements("}")
                self.take("}")
                body.append(("when", speed, inner))
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
