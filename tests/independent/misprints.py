#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The planted misprints of tests/data/misprints are what they are said to be.

Of every file in misprints.json, with order_conditions.py for tableaus: what it claims does not hold, the first thing that
fails is the one named, and with the mend all of it holds. An integrator is run on an anharmonic, non-autonomous force
with steps of two lengths: the order seen is smaller than the one claimed, and with the mend it is the one claimed.

    tests/independent/misprints.py FOLDER
"""

import json
import re
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import order_conditions  # noqa: E402
import orders  # noqa: E402
from language import Integrator  # noqa: E402


class Unexpected(Exception):
    pass


def place(data, entry):
    """The list and index of an entry such as A[3][2], counted from 1."""
    key, *indices = re.findall(r"\w+", entry)
    rows, i = data[key], int(indices[0]) - 1
    if len(indices) == 1:
        return rows, i
    if len(rows) == len(data["b"]) - 1:  # the empty first row is left out
        i -= 1
    return rows[i], int(indices[1]) - 1


def mended_tableau(data, mends):
    for mend in mends:
        if "exchange" in mend:
            one, other = mend["exchange"]
            data[one], data[other] = data[other], data[one]
        elif "everywhere" in mend:
            def right(value):
                if isinstance(value, list):
                    return [right(v) for v in value]
                return mend["right"] if str(value) == mend["everywhere"] else value
            data = {key: right(value) for key, value in data.items()}
        elif "claim" in mend:
            if data[mend["claim"]] != mend["printed"]:
                raise Unexpected(f"the file does not claim {mend['claim']} {mend['printed']}")
            data[mend["claim"]] = mend["right"]
        else:
            row, i = place(data, mend["entry"])
            if str(row[i]) != mend["printed"]:
                raise Unexpected(f"{mend['entry']} is {row[i]} and not {mend['printed']}")
            row[i] = mend["right"]
    return data


def check_tableau(folder, misprint, scratch):
    path = folder / misprint["file"]
    try:
        order_conditions.check(path)
    except order_conditions.Wrong as wrong:
        said = str(wrong)
        if not said.startswith(misprint["fails"]):
            raise Unexpected(f"{misprint['fails']} should fail; {said}") from None
    else:
        raise Unexpected("it holds what it claims")
    data = json.loads(path.read_text(), parse_float=str)
    for key in ("A", "Abar"):
        if key in data:
            data[key] = [list(row) for row in data[key]]
    mended = scratch / misprint["file"]
    mended.write_text(json.dumps(mended_tableau(data, misprint["mend"])))
    try:
        order_conditions.check(mended)
    except order_conditions.Wrong as wrong:
        raise Unexpected(f"mended, it is still wrong: {wrong}") from None
    return said


def mended_integrator(text, mends):
    lines = text.split("\n")
    for mend in mends:
        if "exchange" in mend:
            other = {"kick": "drift", "drift": "kick "}
            lines = [re.sub(r"^  (kick|drift)\b", lambda m: "  " + other[m[1]], line) for line in lines]
            continue
        line = lines[mend["line"] - 1]
        if mend["printed"] not in line:
            raise Unexpected(f"line {mend['line']} is not {mend['printed']}")
        lines[mend["line"] - 1] = line.replace(mend["printed"], mend["right"])
    return "\n".join(lines)


def seen(path, order):
    integrator = Integrator(path.read_text())
    orders.ORDER[integrator.name] = (order, order)
    return orders.observed_order(integrator, orders.without_velocity)


def check_integrator(folder, misprint, scratch):
    path, order = folder / misprint["file"], misprint["order"]
    wrong = seen(path, order)
    if wrong > order - 0.5:
        raise Unexpected(f"order {wrong:.2f} is seen, {order} is claimed")
    mended = scratch / misprint["file"]
    mended.write_text(mended_integrator(path.read_text(), misprint["mend"]))
    right = seen(mended, order)
    if abs(right - order) > (0.2 if order < 6 else 0.35):  # floats have 16 digits
        raise Unexpected(f"mended, order {right:.2f} is seen; {order} is claimed")
    return f"order {wrong:.2f} seen, {order} claimed; mended {right:.2f}"


def main(arguments):
    folder = Path(arguments[0])
    misprints = json.loads((folder / "misprints.json").read_text())
    failed = 0
    listed = {m["file"] for m in misprints} | {"misprints.json", "README.md"}
    for stranger in {p.name for p in folder.iterdir()} ^ listed:
        failed += 1
        print(f"WRONG {stranger}: it is not both in the folder and in misprints.json")
    with tempfile.TemporaryDirectory() as scratch:
        for misprint in misprints:
            check = check_tableau if misprint["file"].endswith(".json") else check_integrator
            try:
                print(f"ok    {misprint['file']}: {check(folder, misprint, Path(scratch))}")
            except Unexpected as unexpected:
                failed += 1
                print(f"WRONG {misprint['file']}: {unexpected}")
    print(f"{len(misprints) - failed} misprints are found and mended, {failed} are not what they should be")
    return 1 if failed or not misprints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
