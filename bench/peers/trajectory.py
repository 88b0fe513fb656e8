# SPDX-License-Identifier: GPL-3.0-or-later
# The exact trajectory of a spring with Python's fractions. Reads lines "go(STEPS, TIMES)"; answers each with "=done".
import platform
import sys
from fractions import Fraction


def trajectory(steps):
    h, x, v = Fraction(1, 50), Fraction(1), Fraction(0)
    for _ in range(steps):
        v -= h * x
        x += h * v
    return x


print("Python", platform.python_version(), "fractions.Fraction")
print("=done", flush=True)
for line in sys.stdin:
    steps, times = map(int, line.strip().removeprefix("go(").rstrip(")").split(","))
    for _ in range(times):
        trajectory(steps)
    print("=done", flush=True)
