# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the modules and what they include of each other, as the code's #include lines are, in docs/images/architecture.svg.

A module stands one row above the highest that it includes. An arrow is left out where a longer way says the same.
Usage: make_architecture.py REPOSITORY PICTURE            writes the picture
       make_architecture.py --check REPOSITORY PICTURE    fails when it is stale
"""
import html
import os
import re
import sys

WIDTH, HEIGHT, GAP_X, GAP_Y, MARGIN = 168, 46, 26, 44, 20


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
    width = 2 * MARGIN + widest * WIDTH + (widest - 1) * GAP_X
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
    for name in sorted(seen):
        for other in sorted(seen[name]):
            if any(other in reachable(between, seen) for between in seen[name] if between != other):
                continue
            (x, y), (u, v) = at[name], at[other]
            out.append(f'<path d="M{x + WIDTH / 2:g} {y + HEIGHT:g}L{u + WIDTH / 2:g} {v - 2:g}" stroke="#555" fill="none" marker-end="url(#head)"/>')
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
