# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON schemas of share/output: one document each, what of it is used by an instance, and instances that are wrong."""

import copy
import json

from jsonschema import Draft202012Validator
from jsonschema.exceptions import best_match

UNEXPECTED = "unexpected"
#: What a value is replaced by, so that it has another type; nothing else may be accepted in its place.
OTHER = {str: 0.5, bool: "yes", int: "many", float: "many", list: "none", dict: "none", type(None): {UNEXPECTED: [None]}}


def bundled(folder, word):
    """The schema of a word as one document: what it refers to in common.schema.json stands among its own $defs."""
    def local(node, prefix):
        if isinstance(node, dict):
            found = {key: local(value, prefix) for key, value in node.items()}
            target = node.get("$ref")
            if isinstance(target, str):
                place, _, name = target.partition("#/$defs/")
                found["$ref"] = "#/$defs/" + ("common." if place or prefix else "") + name
            return found
        return [local(value, prefix) for value in node] if isinstance(node, list) else node

    def read(name):
        return json.loads((folder / f"{name}.schema.json").read_text(encoding="utf-8"))

    schema = local(read(word), "")
    if word != "common":
        common = local(read("common"), "common.")["$defs"]
        schema.setdefault("$defs", {}).update({f"common.{name}": definition for name, definition in common.items()})
    return schema


class Schema:
    """One document. Places in it are tuples of keys; those of common definitions are the same in every document."""

    def __init__(self, folder, word):
        self.word = word
        self.document = bundled(folder, word)
        Draft202012Validator.check_schema(self.document)
        self._validators = {}

    def validator(self, place=()):
        if place not in self._validators:
            part = self.at(place) if place else self.document
            whole = {"$defs": self.document.get("$defs", {}), "allOf": [part]} if place else part
            self._validators[place] = Draft202012Validator(whole)
        return self._validators[place]

    def accepts(self, instance):
        return self.validator().is_valid(instance)

    def why_not(self, instance):
        """What is wrong, deepest first."""
        best = best_match(self.validator().iter_errors(instance))
        return f"at {'/'.join(map(str, best.absolute_path)) or 'the top'}: {best.message[:300]}"

    def at(self, place):
        node = self.document
        for key in place:
            node = node[key]
        return node

    def name(self, place):
        """The same for a definition of common.schema.json, whoever refers to it."""
        if len(place) > 1 and place[0] == "$defs" and place[1].startswith("common."):
            return ("common", place[1][len("common."):], *place[2:])
        return (self.word, *place)

    # What there is -----------------------------------------------------------------------------------------------

    def alternatives(self, place=()):
        """Every property, every branch, every type and word of a choice: the names of what an output may have."""
        node = self.at(place) if place else self.document
        for key in node.get("properties", ()):
            yield (*self.name(place), "properties", key)
        for key in ("anyOf", "oneOf"):
            for i in range(len(node.get(key, ()))):
                yield (*self.name(place), key, i)
        for kind in node["type"] if isinstance(node.get("type"), list) else ():
            yield (*self.name(place), "type", kind)
        for word in node.get("enum", ()):
            yield (*self.name(place), "enum", word)
        for inner in self._inner(place, node):
            yield from self.alternatives(inner)
        for name in node.get("$defs", ()) if not place else ():
            yield from self.alternatives(("$defs", name))

    def undescribed(self, place=()):
        """Properties without a description."""
        node = self.at(place) if place else self.document
        yield from (".".join(map(str, (*self.name(place), key))) for key, value in node.get("properties", {}).items()
                    if not value.get("description", "").endswith((".", ",")))
        for inner in self._inner(place, node):
            yield from self.undescribed(inner)
        for name in node.get("$defs", ()) if not place else ():
            yield from self.undescribed(("$defs", name))

    @staticmethod
    def _inner(place, node):
        for key in node.get("properties", ()):
            yield (*place, "properties", key)
        for key in ("anyOf", "oneOf", "allOf"):
            for i in range(len(node.get(key, ()))):
                yield (*place, key, i)
        for key in ("items", "additionalProperties", "propertyNames"):
            if isinstance(node.get(key), dict):
                yield (*place, key)

    # What an instance has ----------------------------------------------------------------------------------------

    def used(self, instance, place=(), where=()):
        """(name of an alternative, place of the schema node, where in the instance) of all that a valid instance uses."""
        node = self.at(place) if place else self.document
        name = self.name(place)
        if "$ref" in node:
            yield from self.used(instance, tuple(node["$ref"][2:].split("/")), where)
        for i in range(len(node.get("allOf", ()))):
            yield from self.used(instance, (*place, "allOf", i), where)
        for key in ("anyOf", "oneOf"):
            for i in range(len(node.get(key, ()))):
                branch = (*place, key, i)
                if self.validator(branch).is_valid(instance):
                    yield (*name, key, i), None, where
                    yield from self.used(instance, branch, where)
        if isinstance(node.get("type"), list):
            yield (*name, "type", json_type(instance)), None, where
        if "enum" in node:
            yield (*name, "enum", instance), None, where
        if isinstance(instance, dict):
            yield from self._used_members(instance, node, place, where)
        if isinstance(instance, list) and "items" in node:
            for i, item in enumerate(instance):
                yield from self.used(item, (*place, "items"), (*where, i))

    def _used_members(self, instance, node, place, where):
        known = node.get("properties", {})
        for key, value in instance.items():
            if key in known:
                yield (*self.name(place), "properties", key), place, (*where, key)
                yield from self.used(value, (*place, "properties", key), (*where, key))
            elif isinstance(node.get("additionalProperties"), dict):
                yield from self.used(value, (*place, "additionalProperties"), (*where, key))
            if "propertyNames" in node:
                yield from self.used(key, (*place, "propertyNames"), where)


def json_type(instance):
    names = {bool: "boolean", int: "integer", float: "number", str: "string", type(None): "null", list: "array", dict: "object"}
    return names[type(instance)]


def mutations(instance, where, required):
    """(what was done, the instance with it) for one member of an object: taken away, of another type; a neighbour added."""
    def changed(change):
        other = copy.deepcopy(instance)
        holder = other
        for key in where[:-1]:
            holder = holder[key]
        change(holder, where[-1])
        return other

    value = instance
    for key in where:
        value = value[key]
    told = "/".join(map(str, where))
    if required:
        yield f"{told} taken away", changed(lambda holder, key: holder.pop(key))
    for wrong in (OTHER[type(value)], {UNEXPECTED: [None]}):
        yield f"{told} replaced by {json.dumps(wrong)}", changed(lambda holder, key, w=wrong: holder.__setitem__(key, w))
    yield f"{UNEXPECTED} beside {told}", changed(lambda holder, key: holder.__setitem__(UNEXPECTED, 1))
