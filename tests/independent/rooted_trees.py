# SPDX-License-Identifier: GPL-3.0-or-later
"""Rooted trees, and the special trees of Nystroem methods, by their recursive definitions; see order_conditions.py."""

import math

TREES = {1: [()]}


def forests(total, largest, index):
    """Multisets of trees with `total` nodes altogether, made of trees not after the index-th of size `largest`."""
    if total == 0:
        yield ()
        return
    for size in range(min(largest, total), 0, -1):
        known = trees(size)
        last = index if size == largest else len(known) - 1
        for i in range(last, -1, -1):
            for rest in forests(total - size, size, i):
                yield (known[i],) + rest


def trees(order):
    """All rooted trees with so many nodes; a tree is the tuple of the subtrees at its root."""
    if order not in TREES:
        TREES[order] = list(forests(order - 1, order - 1, len(trees(order - 1)) - 1))
    return TREES[order]


def nodes(tree):
    return 1 + sum(map(nodes, tree))


def density(tree):
    return nodes(tree) * math.prod(map(density, tree))


def nystroem_trees(order):
    """Special Nystroem trees with `order` nodes, a fat one at the root: below a fat node hang meagre ones, each of which
    carries one fat node or none (its end: the velocity). A tree is the tuple of what hangs below its root; None is a
    bare meagre node."""
    if order not in NYSTROEM:
        def below(total, atoms, start):
            if total == 0:
                yield ()
                return
            for i in range(start, len(atoms)):
                size, atom = atoms[i]
                if size <= total:
                    for rest in below(total - size, atoms, i):
                        yield (atom,) + rest
        atoms = [(1, None)] + [(1 + n, tree) for n in range(1, order - 1) for tree in nystroem_trees(n)]
        NYSTROEM[order] = list(below(order - 1, atoms, 0))
    return NYSTROEM[order]


NYSTROEM = {1: [()]}


def nystroem_nodes(tree):
    return 1 + sum(1 if child is None else 1 + nystroem_nodes(child) for child in tree)


def nystroem_density(tree):
    """A meagre node with a fat one upon it has one node more than the fat one's tree."""
    return nystroem_nodes(tree) * math.prod(
        1 if c is None else (nystroem_nodes(c) + 1) * nystroem_density(c) for c in tree)
