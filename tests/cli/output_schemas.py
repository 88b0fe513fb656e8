#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command prints with --json is what the schemas of share/output say.

  outputs    of every command of output_cases.py are valid, and end with the exit code that stands there
  words      what the sources write as "schema" has a schema file, and the other way round
  use        every property, branch and word of every schema occurs in some output: nothing is invented, nothing stale
  mutations  for every property an output in which it is missing, or of another type, or has a neighbour that nobody
             knows, is refused

    tests/cli/output_schemas.py SHORTFALL ROOT
"""

import json
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
try:
    from schema_tools import Schema, mutations  # noqa: E402
except ImportError:
    print("skipped: Python has no jsonschema (on Debian: python3-jsonschema)")
    sys.exit(0)
from output_cases import CASES, FILES, UNREACHED  # noqa: E402

WORD = re.compile(r'"shortfall\.([a-z-]+)/([0-9]+)"')


class Bad(Exception):
    pass


def strictly(text):
    """JSON without what only Python reads, and without a key that stands twice."""
    def no_constant(word):
        raise Bad(f"{word} is no JSON")

    def members(pairs):
        if len({key for key, _ in pairs}) < len(pairs):
            raise Bad(f"a key stands twice: {[key for key, _ in pairs]}")
        return dict(pairs)

    try:
        return json.loads(text, parse_constant=no_constant, object_pairs_hook=members)
    except ValueError as error:
        raise Bad(f"no JSON: {error}") from None


def written_words(root):
    """{word: version} as the sources have it."""
    words = {}
    for folder in ("cli", "notebooks-export"):
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            words.update(WORD.findall(path.read_text(encoding="utf-8")))
    return words


def outputs(shortfall, root):
    """(command, JSON, error) of every case."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for name in ("examples", "scenes", "tests"):
            (folder / name).symlink_to(root / name)
        for name, text in FILES.items():
            (folder / name).write_text(text, encoding="utf-8")
        for line in filter(None, CASES.splitlines()):
            code, _, command = line.partition(" ")
            said = subprocess.run([shortfall, *shlex.split(command), "--json"], cwd=folder, capture_output=True, text=True, timeout=300)
            try:
                if said.returncode != int(code):
                    raise Bad(f"exit code {said.returncode} instead of {code}: {said.stderr.strip()[:200]}")
                yield command, strictly(said.stdout), None
            except Bad as bad:
                yield command, None, str(bad)


def main(arguments):
    shortfall, root = str(Path(arguments[0]).resolve()), Path(arguments[1]).resolve()
    folder = root / "share" / "output"
    failed = []
    schemas = {path.name.removesuffix(".schema.json"): None for path in sorted(folder.glob("*.json"))}
    schemas = {word: Schema(folder, word) for word in schemas if word != "common"}
    words = written_words(root)
    for word in sorted(words.keys() ^ schemas.keys()):
        failed.append(f"{word}: written by the sources and described in share/output is not the same")
    alternatives = {name for schema in schemas.values() for name in schema.alternatives()}
    failed += sorted({f"{name}: no description" for schema in schemas.values() for name in schema.undescribed()})

    smallest = {}  # of each alternative the shortest output that has it, and where
    valid = 0
    for command, output, error in outputs(shortfall, root):
        word, _, version = (output or {}).get("schema", "").removeprefix("shortfall.").partition("/")
        if not error and (word not in schemas or words.get(word) != version):
            error = f"'schema' is {word}/{version}"
        if not error and not schemas[word].accepts(output):
            error = schemas[word].why_not(output)
        if error:
            failed.append(f"shortfall {command}: {error}")
            continue
        valid += 1
        size = len(json.dumps(output))
        for name, place, where in schemas[word].used(output):
            if name not in smallest or size < smallest[name][0]:
                smallest[name] = (size, schemas[word], output, place, where)

    for name in sorted(alternatives - smallest.keys() - UNREACHED.keys(), key=str):
        failed.append(f"no output has {' '.join(map(str, name))}")
    for name in sorted(UNREACHED.keys() - (alternatives - smallest.keys()), key=str):
        failed.append(f"UNREACHED lists {' '.join(map(str, name))}, which some output has, or no schema")

    refused = 0
    for size, schema, output, place, where in smallest.values():
        if place is None:
            continue
        required = where[-1] in (schema.at(place) if place else schema.document).get("required", ())
        for told, mutated in mutations(output, where, required):
            if schema.accepts(mutated):
                failed.append(f"{schema.word} accepts an output with {told}")
            refused += 1
    for line in failed[:60]:
        print(line)
    print(f"{valid} outputs are as {len(schemas)} schemas say, {len(smallest)} of {len(alternatives)} properties, branches and words seen, "
          f"{refused} mutations tried; {len(failed)} failures")
    return 1 if failed or not valid or not refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
