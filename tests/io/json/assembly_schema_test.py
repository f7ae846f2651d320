"""The schema accepts every example and refuses what the reader refuses."""
import json
import pathlib
import re
import sys

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[3]

PIPE = {"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 1}}


def document(part):
    return {"units": "mm", "tolerance": 0.05, "parts": [part]}


REFUSED = [
    {"units": "mm", "tolerance": 1, "values": {"m": 1}, "parts": [PIPE]},
    {"units": "mm", "tolerance": 1, "values": {"a": None}, "parts": [PIPE]},
    {"units": "mm", "tolerance": 1, "values": {"a": [[1]]}, "parts": [PIPE]},
    document({**PIPE, "for": {"i": 0}}),
    document({**PIPE, "for": {"i": 1e9}}),
    document({**PIPE, "for": {}}),
    document({"parts": [PIPE], "name": "a"}),
    document({**PIPE, "colour": "red"}),
    document({"for": {"i": 1}, "name": "a", "parts": [PIPE]}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "size": "DN100", "radius": 1}}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1, "schedule": 40}}),
    [],
    {},
    {"units": "mile", "tolerance": 1, "parts": [PIPE]},
    {"units": "mm", "tolerance": 0, "parts": [PIPE]},
    {"units": "mm", "tolerance": 1, "parts": []},
    {"units": "mm", "tolerance": 1, "segments": 2, "parts": [PIPE]},
    {"units": "mm", "tolerance": 1, "segments": 12.5, "parts": [PIPE]},
    {"units": "mm", "tolerance": 1, "part": [], "parts": [PIPE]},
    document({"name": "a"}),
    document({"name": "a.b", "sphere": {"center": [0, 0, 0], "radius": 1}}),
    document({"name": "a", "sphere": {"center": [0, 0], "radius": 1}}),
    document({"name": "a", "sphere": {"center": [0, 0, 0], "radius": -1}}),
    document({"name": "a", "tee": {}}),
    document({**PIPE, "cap": {"at": "b.end"}}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0]}}),
    document({"name": "a", "pipe": {"from": "b.end", "to": [1, 0, 0], "radius": 1}}),
    document({"name": "a", "pipe": {"from": "b.middle", "length": 1}}),
    document({"name": "a", "cone": {"from": "b.end", "length": 1, "radii": [1, 2]}}),
    document({"name": "a", "elbow": {"from": "b.end", "bend_radius": 2, "angle": 360, "toward": [1, 0, 0]}}),
    document({"name": "a", "cyclic_blend": {"from": "b.end", "to": "c.start", "radius_law": "R3", "k": 1, "l": 1}}),
    document({"name": "a", "cyclic_blend": {"from": "b.end", "to": "c.start", "radius_law": "R1", "k": 1, "l": "best"}}),
    document({"name": "a", "cyclic_blend": {"from": "b.end", "to": "c.start", "radius_law": "R1", "k": 1}}),
    document({"name": "a", "cap": {"at": 1}}),
    document({"name": "a", "cyclide_blend": {"from": "b.end"}}),
    document({"name": "a", "cyclide_chain": {"spheres": [[0, 0, 0], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"slope": 1, "spheres": [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"from": "b.end", "direction": [1, 0, 0], "spheres": [[1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"joints": "caps", "spheres": [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"joints": "kneecaps", "tangents": [{"sphere": 2, "tangent": [1, 0, 0, 0]}], "spheres": [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"wall": 0, "spheres": [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1, 2]}}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1, 0], "axis": [0, 0, 1]}}),
    document({"name": "a", "spline": {"through": [], "closed": False}}),
    document({"name": "a", "ringed_blend": {"from": "b.end", "to": "c.start", "bidegree": [3, 2]}}),
    document({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "plate": "flat"}}}),
    document({"name": "a", "two_cone_blend": {"from": "b.end", "to": "c.start"}}),
    document({"name": "a", "flange": {"at": "b.end", "radius": 1}}),
    document({"name": "a", "flange": {"at": "b.end", "size": "DN100", "class": 600}}),
    document({"name": "a", "head": {"from": "b.end"}}),
    document({"name": "a", "head": {"from": "b.end", "form": "flat"}}),
    document({"name": "a", "head": {"from": "b.end", "form": "torispherical"}}),
    document({"name": "a", "head": {"from": "b.end", "form": "kloepper", "depth": 1}}),
    document({"name": "a", "head": {"from": [0, 0, 0], "form": "kloepper"}}),
    document({"name": "a", "tee": {"from": "b.end", "length": 2}}),
    document({"name": "a", "tee": {"from": "b.end", "radius": 1, "length": 2, "branch": {"direction": [0, 0, 1], "length": 2, "radius": 1}}}),
    document({"name": "a", "tee": {"from": "b.end", "length": 2, "branch": {"direction": [0, 0, 1], "length": 2}}}),
    document({"name": "a", "valve": {"from": [0, 0, 0], "length": 2, "body": {"radius": 2, "length": 1}}}),
    document({**PIPE, "wall_side": "inside"}),
    document({**PIPE, "insulation": -1}),
]

ACCEPTED = [
    {"units": "mm", "tolerance": "=1/20", "values": {"a": "DN100", "b": 2, "c": ["=b", 3]}, "parts": [PIPE]},
    document({**PIPE, "for": {"i": 3, "j": [1, "x"], "k": "=n"}}),
    document({"for": {"i": 3}, "parts": [PIPE, {"for": {"j": 2}, "parts": [PIPE]}]}),
    document({"name": "a", "pipe": {"from": "=here", "to": [0, "=b", 1], "size": "NPS 4", "schedule": "XS"}}),
    document({"name": "a", "elbow": {"from": [0, 0, 0], "direction": [1, 0, 0], "to": [1, 2, 3], "size": "DN100"}}),
    document({"name": "a", "cyclide_blend": {"from": "b.end", "to": "c.start"}}),
    document({"name": "a", "cyclide_chain": {"joints": "kneecaps", "wall": 0.1, "spheres": [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"joints": "kneecaps", "from": "b.end", "spheres": [[0, 0, 0, 1], [1, 0, 0, 1]]}}),
    document({"name": "a", "cyclide_chain": {"from": "b.end", "spheres": [[1, 0, 0, 1], [2, 0, 0, 1]], "tangents": [{"sphere": 1, "tangent": [1, 0, 0, 0]}]}}),
    document({"name": "a", "cone": {"from": "b.end", "length": 1, "end_semi_axes": [2, 1], "axis": [0, 0, 1]}}),
    document({"name": "a", "elbow": {"from": [0, 0, 0], "direction": [1, 0, 0], "to": [1, 2, 3], "semi_axes": [2, 1], "axis": [0, 0, 1]}}),
    document({"name": "a", "ringed_blend": {"from": "b.end", "to": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 1, "ruling": [0, 1, 1]}, "k": "auto"}}),
    document({"name": "a", "wall": 0, "sphere": {"center": [0, 0, 0], "radius": 1}}),
    document({"name": "a", "solid": True, "sphere": {"center": [0, 0, 0], "radius": 1}}),
    {"$schema": "https://example.org/assembly.schema.json", **document(PIPE)},
    document({"name": "a", "comment": "", "elbow": {"from": "b.end", "to": [1, 2, 3]}}),
    document({"name": "a", "elbow": {"from": "b.end", "corner": [1, 2, 3], "to": [1, 2, 4]}}),
    document({"name": "a", "elbow": {"from": [0, 0, 0], "direction": [1, 0, 0], "radius": 1, "bend_radius": 3, "angle": 90, "toward": [0, 1, 0]}}),
    document({"name": "a", "cone": {"from": [0, 0, 0], "direction": [0, 1, 0], "length": 3, "radii": [1, 2]}}),
    document({"name": "a", "cap": {"at": "b.start"}}),
    document({"wall": 3, "wall_side": "outwards", "insulation": 0, "parts": [PIPE]}),
    {"units": "mm", "tolerance": 1, "wall": 3, "wall_side": "centred", "insulation": 50, "patches": {"a.start": "inlet"}, "parts": [PIPE]},
    document({**PIPE, "component": {"name": "t", "kind": "TEE", "line": 7}}),
    document({"name": "a", "pipe": {"on": "b", "at": 3, "direction": [0, 0, 1], "length": 2, "size": "DN50"}}),
    document({"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "outside_diameter": 2, "inside_diameter": 1.5}}),
    document({"name": "a", "flange": {"at": "b.end", "size": "DN100", "class": 150}}),
    document({"name": "a", "flange": {"on": "b", "at": 0, "radius": 2, "thickness": 1}}),
    document({"name": "a", "flange": {"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 2, "thickness": 1}}),
    document({"name": "a", "head": {"from": "b.end", "form": "ellipsoidal", "depth": 1}}),
    document({"name": "a", "head": {"from": [0, 0, 0], "direction": [1, 0, 0], "size": "DN100", "form": "torispherical", "crown": 9, "knuckle": 2}}),
    document({"name": "a", "head": {"from": "b.end", "form": "korbbogen"}}),
    document({"name": "a", "tee": {"from": "b.end", "length": 2, "branch": {"direction": [0, 0, 1], "length": 2, "size": "DN50", "schedule": 40}, "fillet": 1}}),
    document({"name": "a", "valve": {"from": [0, 0, 0], "direction": [1, 0, 0], "radius": 1, "length": 2, "body": {"radius": 2, "length": 1}, "stem": {"direction": [0, 0, 1], "length": 3, "radius": 0.3}}}),
    document({"name": "a", "cyclic_blend": {"from": "b.end", "to": "c.start", "k": 1, "l": "auto"}}),
    document({"name": "a", "cyclic_blend": {"from": "b.end", "to": "c.start", "radius_law": "R1", "k": 1, "l": "auto", "continuity": "G2"}}),
]


KEYS = ROOT / "blends" / "include" / "dupin" / "blends" / "part_shape.h"


FITTINGS = ROOT / "io" / "src" / "json" / "fittings.cpp"
BESIDE = {"name", "comment", "wall", "wall_side", "insulation", "component", "solid", "for", "colour"}


def keys_of_parts():
    """Of one part, and of several together."""
    fittings = re.search(r"kFittings\{(.*)\}", FITTINGS.read_text()).group(1)
    return set(re.findall(r'\bPartKey<"(\w+)"', KEYS.read_text())) | set(re.findall(r'"(\w+)"', fittings))


def faults_of_keys(schema):
    """A part takes exactly one of the keys that there are, and each is defined."""
    part, keys = schema["definitions"]["part"], keys_of_parts()
    lists = {
        "properties of a part": set(part["properties"]) - BESIDE,
        "choices of a part": {key for choice in part["oneOf"] for key in choice["required"]},
        "definitions": keys & set(schema["definitions"]),
    }
    return [f"the {what} differ from {KEYS.name} by {key}"
            for what, found in lists.items() for key in sorted(found ^ keys)]


def main():
    schema = json.loads((ROOT / "io" / "assembly.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults = faults_of_keys(schema)
    examples = sorted((ROOT / "examples").glob("*.json"))
    if len(examples) < 8:
        faults.append(f"only {len(examples)} examples found")
    for path in examples:
        faults += [f"{path.name}: {error.message}" for error in validator.iter_errors(json.loads(path.read_text()))]
    faults += [f"refuses {value}" for value in ACCEPTED if not validator.is_valid(value)]
    faults += [f"accepts {value}" for value in REFUSED if validator.is_valid(value)]
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main())
