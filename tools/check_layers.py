#!/usr/bin/env python3
"""Fails on an include against the arrow kernel <- blends <- io <- cli, on libraries in the wrong
room, and on files that outgrew their limit (docs/architecture.md)."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ["kernel", "blends", "io", "cli"]
GUESTS = ["tests", "bench", "examples"]  # may use every public header

# Where a library may be included, as prefixes of paths; everything else in angle brackets is free.
LIBRARIES = {
    "CGAL/": ["kernel/src/", "kernel/include/dupin/interop/", "tests/kernel/", "bench/",
              "tests/io/formats/foreign_cgal_test.cpp"],
    "boost/": ["kernel/src/", "kernel/include/dupin/interop/", "tests/kernel/",
               "tests/blends/numbers/", "bench/"],
    "tbb/": ["kernel/src/", "blends/src/", "tests/kernel/", "bench/"],
    "nlohmann/": ["io/src/", "tests/"],
    "expat.h": ["io/src/"],
    "zip.h": ["io/src/"],
    "CLI/": ["cli/"],
}
LIMITS = [  # first match wins: (pattern, most lines)
    (re.compile(r"^\w+/include/.*\.h$"), 200),
    (re.compile(r"^tests/.*"), 600),
    (re.compile(r".*"), 600),
]
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def room_of(path):
    return path.split("/", 1)[0]


def fault_of_include(path, quoted, angled):
    """What is wrong with one include, or None."""
    room = room_of(path)
    name = quoted or angled
    if name.startswith("dupin/"):
        if not quoted:
            return "our own headers are included in quotes"
        target = name.split("/")[1]
        if target == "interop":
            inside = path.startswith(("kernel/src/", "kernel/include/dupin/interop/"))
            return None if inside or room in GUESTS else "only users may include dupin/interop"
        if room in ROOMS and ROOMS.index(target) > ROOMS.index(room):
            return f"{room} must not know {target}"
        return None
    if quoted and name.startswith("src/"):
        allowed = room == "tests" and path.endswith("_internal_test.cpp")
        return None if allowed else "only *_internal_test.cpp may see private headers"
    for library, prefixes in LIBRARIES.items():
        if name.startswith(library) and not path.startswith(tuple(prefixes)):
            return f"{library} is allowed only in {', '.join(prefixes)}"
    return None


def faults_of(path, text):
    lines = text.splitlines()
    limit = next(most for pattern, most in LIMITS if pattern.match(path))
    if len(lines) > limit:
        yield f"{path}: {len(lines)} lines, at most {limit}"
    for number, line in enumerate(lines, 1):
        if match := INCLUDE.match(line):
            if fault := fault_of_include(path, *match.groups()):
                yield f"{path}:{number}: {fault}"
        if re.search(r"\b(TODO|FIXME|XXX)\b", line):
            yield f"{path}:{number}: an unfinished note"


def main():
    faults = []
    for folder in ROOMS + GUESTS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                path = file.relative_to(ROOT).as_posix()
                faults += faults_of(path, file.read_text(encoding="utf-8"))
    print("\n".join(faults) if faults else "layers: clean")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
