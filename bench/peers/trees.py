# SPDX-License-Identifier: GPL-3.0-or-later
# The order conditions of a tableau with Python's fractions, by the second implementation of tests/independent.
# Reads lines "go(ORDER, TIMES)" and answers "=done"; "wrong(ORDER)" says first how many conditions do not hold.
# Arguments: the folder of that implementation, the tableau.
import pathlib
import platform
import sys

sys.path.insert(0, sys.argv[1])
import order_conditions as independent  # noqa: E402

tableau = independent.Tableau(pathlib.Path(sys.argv[2]))
for order in range(1, 9):
    independent.trees(order)  # kept from turn to turn, as on the other side


def wrong(order):
    conditions = independent.Conditions(tableau, "b")
    return sum(conditions.fails(tree, independent.density(tree))
               for n in range(1, order + 1) for tree in independent.trees(n))


print("Python", platform.python_version(), "fractions.Fraction")
print("=done", flush=True)
for line in sys.stdin:
    name, arguments = line.strip().rstrip(")").split("(")
    order, *times = map(int, arguments.split(","))
    if name == "wrong":
        print(wrong(order))
    else:
        for _ in range(*times):
            wrong(order)
    print("=done", flush=True)
