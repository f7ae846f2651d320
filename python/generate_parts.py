"""generate_parts.py SCHEMA: prints dupin/_parts.py, the builder's methods, one for each key that a part of a document
may have. The schema is the one list of these keys, so that a new key is a method without further ado."""
import json
import keyword
import sys

HEAD = '''"""The builder's methods. Generated from io/assembly.schema.json by python/generate_parts.py."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar, Union

Self = TypeVar("Self", bound="PartMethods")

#: A number, or an expression that begins with "=".
Number = Union[float, int, str]
#: Three numbers: a list, a tuple, an array.
Vector = Any
#: "part.start" or "part.end".
Port = str


class PartMethods:
    """A method for each key of a part; see docs/assembly_format.md."""

    def _add_part(self, key: str, name: str, below: dict[str, Any], beside: dict[str, Any]) -> Any:
        raise NotImplementedError
'''
KINDS = {"vector": "Vector", "positive": "Number", "coordinate": "Number", "angle": "Number", "port": "Port",
         "size": "str", "schedule": "Union[int, str]", "semi_axes": "Sequence[Number]"}


def resolved(schema, node):
    while "$ref" in node:
        target = schema
        for step in node["$ref"].removeprefix("#/").split("/"):
            target = target[step]
        node = target
    return node


def shapes(schema, node):
    """The objects that may stand below a key: their properties, and which of them must."""
    node = resolved(schema, node)
    alternatives = node.get("oneOf") or node.get("anyOf") or [node]
    for alternative in alternatives:
        alternative = resolved(schema, alternative)
        if "properties" in alternative:
            yield alternative["properties"], alternative.get("required", [])
        elif "oneOf" in alternative or "anyOf" in alternative:
            yield from shapes(schema, alternative)


def kind_of(node):
    if "$ref" in node:
        return KINDS.get(node["$ref"].rsplit("/", 1)[-1], "Any")
    kinds = {"string": "str", "boolean": "bool", "integer": "int", "number": "float", "array": "Sequence[Any]",
             "object": "Mapping[str, Any]"}
    kind = node.get("type")
    return kinds.get(kind, "Any") if isinstance(kind, str) else "Any"


def word(name):
    return name + "_" if keyword.iskeyword(name) else name


def described(schema, key, found):
    text = resolved(schema, schema["definitions"]["part"]["properties"][key]).get("description", "")
    ways = []
    for properties, required in found:
        optional = [word(name) for name in properties if name not in required]
        way = ", ".join(word(name) for name in properties if name in required)
        ways.append(way + (f" [, {', '.join(optional)}]" if optional else ""))
    title = text.rstrip(".") + "." if text else f"A part with the key `{key}`."
    return title[0].upper() + title[1:] + "\n\n" + "\n".join(f"        {way}" for way in ways) + "\n        "


def keys_of(schema):
    """The keys that say what a part is, and those that may stand beside any of them, with their kinds."""
    choices = schema["definitions"]["part"]["oneOf"]
    part = schema["definitions"]["part"]["properties"]
    keys = [key for choice in choices for key in choice["required"]]
    beside = {word(key): kind_of(resolved(schema, part[key])) for key in part if key not in keys and key != "name"}
    return keys, beside


def method(schema, key, beside):
    found = list(shapes(schema, schema["definitions"]["part"]["properties"][key]))
    kinds = {}
    for properties, _ in found:
        for name, node in properties.items():
            kinds.setdefault(name, set()).add(kind_of(node))
    always = [name for name in kinds if all(name in required for _, required in found)]
    beside = {name: kind for name, kind in beside.items() if name not in kinds}

    def annotated(name):
        kind = " | ".join(sorted(kinds[name])) if "Any" not in kinds[name] else "Any"
        return f"{word(name)}: {kind}" + ("" if name in always else " | None = None" if kind != "Any" else " = None")

    arguments = [annotated(name) for name in always] + [annotated(name) for name in kinds if name not in always]
    arguments += [f"{name}: {kind} | None = None" if kind != "Any" else f"{name}: Any = None"
                  for name, kind in beside.items()]
    below = ", ".join(f'"{word(name)}": {word(name)}' for name in kinds)
    others = ", ".join(f'"{name}": {name}' for name in beside)
    joined = ",\n            ".join(arguments)
    return (f"\n    def {word(key)}(\n            self: Self, name: str, *,\n            {joined}) -> Self:\n"
            f'        """{described(schema, key, found)}"""\n'
            f'        return self._add_part("{key}", name, {{{below}}}, {{{others}}})\n')


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    keys, beside = keys_of(schema)
    print(HEAD + "".join(method(schema, key, beside) for key in keys), end="")


if __name__ == "__main__":
    main()
