# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the modules and what they include of each other, as the code's #include lines are, in docs/images/architecture.svg.

A module stands one row above the highest that it includes. An arrow is left out where a longer way says the same; one
that passes other rows runs in a lane of its own beside them.
Usage: make_architecture.py REPOSITORY PICTURE            writes the picture
       make_architecture.py --check REPOSITORY PICTURE    fails when it is stale
"""
import html
import os
import re
import sys

WIDTH, HEIGHT, GAP_X, GAP_Y, MARGIN, LANE = 168, 46, 26, 44, 20, 16


def module(path):
    parts = path.split("/")
    if parts[0] == "analysis" and len(parts) > 2:
        return parts[1]
    return parts[0] if parts[0] in ("cli", "notebooks-export") else None


def includes(repository):
    """{module: files}, {module: {module: how many of its lines include it}}."""
    files, seen = {}, {}
    for top in ("analysis", "cli", "notebooks-export"):
        for folder, _, names in os.walk(os.path.join(repository, top)):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), repository)
                here = module(path)
                if not here or not name.endswith((".cpp", ".hpp")):
                    continue
                files[here] = files.get(here, 0) + 1
                text = open(os.path.join(folder, name), encoding="utf-8").read()
                for included in re.findall(r'^#include "([^"]+)"', text, re.M):
                    there = module(included)
                    if there and there != here:
                        counts = seen.setdefault(here, {})
                        counts[there] = counts.get(there, 0) + 1
    return files, seen


def heights(files, seen):
    found = {}

    def height(name):
        if name not in found:
            found[name] = 1 + max((height(other) for other in seen.get(name, {})), default=-1)
        return found[name]

    for name in files:
        height(name)
    return found


def reachable(name, seen):
    result = set()
    for other in seen.get(name, {}):
        result |= {other} | reachable(other, seen)
    return result


def picture(repository):
    files, seen = includes(repository)
    level = heights(files, seen)
    rows = [sorted(name for name in files if level[name] == i) for i in range(max(level.values()) + 1)]
    widest = max(len(row) for row in rows)
    arrows = [(name, other) for name in sorted(seen) for other in sorted(seen[name])
              if not any(other in reachable(between, seen) for between in seen[name] if between != other)]
    # The lanes: right of the rows for what leads to the right half of its row, left for the others.
    lanes = {False: [], True: []}
    for name, other in arrows:
        if level[name] - level[other] > 1:
            row = rows[level[other]]
            lanes[2 * row.index(other) + 1 > len(row)].append((name, other))
    room = LANE * max(len(lanes[False]), len(lanes[True]))
    width = 2 * MARGIN + widest * WIDTH + (widest - 1) * GAP_X + 2 * room
    height = 2 * MARGIN + len(rows) * HEIGHT + (len(rows) - 1) * GAP_Y
    at = {}
    for i, row in enumerate(rows):
        left = (width - len(row) * WIDTH - (len(row) - 1) * GAP_X) / 2
        for k, name in enumerate(row):
            at[name] = (left + k * (WIDTH + GAP_X), height - MARGIN - HEIGHT - i * (HEIGHT + GAP_Y))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" font-family="sans-serif" role="img">',
           "<title>The modules of shortfall and what they include of each other</title>",
           '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           '<path d="M0 0L8 4L0 8z" fill="#555"/></marker></defs>',
           f'<rect width="{width}" height="{height}" fill="#fff"/>']
    def arrow(way):
        out.append(f'<path d="{way}" stroke="#555" fill="none" marker-end="url(#head)"/>')

    for name, other in arrows:
        (x, y), (u, v) = at[name], at[other]
        if level[name] - level[other] == 1:
            arrow(f"M{x + WIDTH / 2:g} {y + HEIGHT:g}L{u + WIDTH / 2:g} {v - 2:g}")
    def is_outermost(other, right):
        return other == rows[level[other]][-1 if right else 0]

    for right, beside in lanes.items():
        # The innermost lane first: so none crosses another.
        beside.sort(key=lambda pair: (-level[pair[1]], is_outermost(pair[1], right)))
        for k, (name, other) in enumerate(beside):
            (x, y), (u, v) = at[name], at[other]
            inside = room - LANE * (k + 1)
            lane = width - MARGIN - inside if right else MARGIN + inside
            out_of, into = (x + WIDTH, u + WIDTH + 2) if right else (x, u - 2)
            leaves = y + HEIGHT * (len(beside) - k) / (len(beside) + 1)
            if is_outermost(other, right):
                arrow(f"M{out_of:g} {leaves:g}H{lane:g}V{v + HEIGHT / 2:g}H{into:g}")
            else:  # others stand between: in from above
                arrow(f"M{out_of:g} {leaves:g}H{lane:g}V{v - GAP_Y / 3:g}H{u + WIDTH / 2:g}V{v - 2:g}")
    for name, (x, y) in sorted(at.items()):
        out.append(f'<rect x="{x:g}" y="{y:g}" width="{WIDTH}" height="{HEIGHT}" rx="5" fill="#e8f1f8" stroke="#0072b2"/>')
        out.append(f'<text x="{x + WIDTH / 2:g}" y="{y + 20:g}" text-anchor="middle" font-size="15">{html.escape(name)}</text>')
        out.append(f'<text x="{x + WIDTH / 2:g}" y="{y + 36:g}" text-anchor="middle" font-size="11" fill="#555">{files[name]} files</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    check = sys.argv[1:2] == ["--check"]
    repository, path = sys.argv[-2:]
    text = picture(repository)
    if not check:
        open(path, "w", encoding="utf-8").write(text)
        return 0
    # A file more or less is no other architecture.
    plain = [re.sub(r"\d+ files", "", t) for t in (text, open(path, encoding="utf-8").read())]
    if plain[0] == plain[1]:
        return 0
    print(f"{path} is stale: python3 tests/docs/make_architecture.py . {path}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
