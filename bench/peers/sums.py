# SPDX-License-Identifier: GPL-3.0-or-later
# The sums of powers in SymPy. Reads lines "go(WAY, TIMES)" and "show(WAY)"; answers each with a line "=done".
import sys

import sympy
from sympy.core.cache import clear_cache

k, n = sympy.symbols("k n", integer=True, positive=True)
QQ = sympy.QQ
HIGHEST = 50


def summed():
    """SymPy's own function. Its cache is emptied, or the second round would only look the first one up."""
    clear_cache()
    return [sympy.summation(k**m, (k, 0, n - 1)) for m in range(1, HIGHEST + 1)]


def integrated():
    """The recurrence of faulhaber.hpp, on lists of SymPy's rationals."""
    s = [QQ(0), QQ(1)]
    sums = []
    for m in range(1, HIGHEST + 1):
        integral = [QQ(0), QQ(0)] + [c * QQ(m, j + 1) for j, c in enumerate(s) if j > 0]
        integral[1] = -sum(integral)
        s = integral
        sums.append(s)
    return sums


WAYS = [summed, integrated]


def go(way, times):
    for _ in range(times):
        WAYS[way - 1]()


def show(way):
    for s in WAYS[way - 1]():
        lowest_first = s if isinstance(s, list) else sympy.Poly(s, n).all_coeffs()[::-1]
        print(*lowest_first)


print("SymPy", sympy.__version__, "with", sympy.external.gmpy.GROUND_TYPES, "numbers")
print("=done", flush=True)
for line in sys.stdin:
    word, _, numbers = line.strip().rstrip(")").partition("(")
    {"go": go, "show": show}[word](*map(int, numbers.split(",")))
    print("=done", flush=True)
