#!/usr/bin/env python3
"""The floor plan of the house, and what holds it (docs/architecture.md).

Rooms are kernel <- blends <- io <- cli; inside a room, folders are modules, and ARROWS says once
which folder may include which. Fails on an include against an arrow, on a private header that a
stranger includes by whatever spelling, on a namespace that is not its folder's, on libraries in
the wrong room, on circles, on files and folders that outgrew their limits, on a .cpp that has
neither a header of its name nor a test of its name, and on a name that stands for two types.
"""
import collections
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ["kernel", "blends", "io", "cli"]
GUESTS = ["tests", "bench", "examples", "python"]  # may use every public header

# Folder by folder, what it may include besides itself and the public headers of the rooms before.
ARROWS = {
    "kernel": {
        "support": [],
        "exact": ["support"],
        "predicates": ["exact"],
        "boxes": ["support"],
        "mesh": ["boxes", "exact", "support"],
        "checking": ["mesh", "boxes", "predicates", "exact", "support"],
        "arrangement": ["mesh", "boxes", "predicates", "exact", "support"],
        "booleans": ["arrangement", "boxes", "checking", "exact", "mesh", "support"],
        "healing": ["booleans", "arrangement", "checking", "mesh", "predicates", "support"],
        "rounding": ["healing", "arrangement", "checking", "mesh", "boxes", "predicates", "exact", "support"],
        "tiles": ["checking", "mesh", "exact", "support"],
        "districts": ["rounding", "checking", "boxes", "mesh", "exact", "support"],
        "meshing": ["rounding", "checking", "mesh", "boxes", "support"],
        "gaps": ["mesh", "boxes", "predicates", "exact", "support"],
        "views": ["mesh", "boxes", "support"],
        "cross_check": ["booleans", "checking", "mesh", "exact", "support"],
    },
    "blends": {
        "numbers": [],
        "curves": ["numbers"],
        "ringed": ["curves", "numbers"],
        "cyclide": ["ringed", "numbers"],
        "canal": ["cyclide", "ringed", "numbers"],
        "tessellation": ["cyclide", "ringed", "curves", "numbers"],
        "junction": ["tessellation", "cyclide", "ringed", "numbers"],
        "shading": ["canal", "cyclide", "ringed", "curves", "numbers"],
        "surfaces": ["tessellation", "canal", "cyclide", "ringed", "curves", "numbers"],
        "avoidance": ["surfaces", "cyclide", "ringed", "curves", "numbers"],
        "assembly": ["avoidance", "surfaces", "junction", "tessellation", "canal", "cyclide", "ringed", "curves",
                     "numbers"],
        "editing": ["assembly", "cyclide", "numbers"],
        "drawing": ["assembly", "shading", "surfaces", "canal", "cyclide", "ringed", "curves", "numbers"],
        "fitting": ["cyclide", "ringed", "numbers"],
        "network": ["assembly", "junction", "cyclide", "ringed", "numbers"],
        "verification": ["ringed", "canal", "numbers"],
        "certification": ["verification", "assembly", "canal", "surfaces", "tessellation", "cyclide",
                          "ringed", "curves", "numbers"],
    },
    "io": {
        "text": [],
        "drawings": ["files", "text"],
        "exchange": ["files", "text"],
        "occt": ["exchange", "text"],
        "files": ["text"],
        "formats": ["files", "text"],
        "streams": ["formats", "files", "text"],
        "json": ["drawings", "exchange", "formats", "files", "pcf", "text"],
        "graph": ["text"],
        "pcf": ["text"],
        "documents": ["json", "graph", "pcf"],
        "pages": ["json", "pcf", "text"],
    },
}

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
    "cairo": ["io/src/drawings/"],
    "CLI/": ["cli/"],
    "mpi.h": ["cli/mpi/"],
    "jemalloc/": ["cli/allocator/"],
    # OpenCASCADE's headers have no folder of their own.
    **{name: ["io/src/occt/", "tests/io/occt/"] for name in (
        "APIHeaderSection", "BOPAlgo", "BRep", "Bnd_", "GProp", "Geom", "IGES", "Interface_", "Message", "NCollection",
        "Precision.hxx", "Quantity_", "STEP", "Standard_", "StepData", "StepRepr", "StepVisual", "TCol", "TDF", "TDataStd",
        "TDocStd", "TopExp", "TopTools", "TopoDS", "Transfer_", "XCAF", "XSControl", "gp_")},
    "pybind11/": ["python/bindings/"],
}
MOST_LINES = [  # first match wins: (pattern, most lines)
    (re.compile(r"^(?!tests/).*\.h$"), 200),
    (re.compile(r".*"), 600),
]
MOST_FILES = 40  # in a folder
MOST_FLOORS = 9  # of the folders of a room
LARGEST_CIRCLE = 3  # of files with their headers
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
ANY_NAMESPACE = re.compile(r"(?:inline )?namespace (?:([\w:]+) )?\{(?!.*\})")
TYPE = re.compile(r"(?:template <.*> )?(?:enum class|struct|class|enum|union) (?:[A-Z_]+ )?([A-Za-z_][\w:]*)(?![\w:<])")
NAMESPACE = re.compile(r"^\s*(?:inline\s+)?namespace\s+([\w:]+)\s*\{")


def sources():
    """All headers and sources, as paths relative to the root."""
    for folder in ROOMS + GUESTS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                yield file.relative_to(ROOT).as_posix()


class House:
    """Which header is where."""

    def __init__(self, paths):
        self.paths = list(paths)
        self.private = {}  # name -> paths
        self.homes = {}  # room/name of a source -> folder
        for path in self.paths:
            parts = path.split("/")
            if parts[1:2] == ["src"] or parts[0] == "cli":
                name = parts[-1]
                if name.endswith(".h"):
                    self.private.setdefault(name, []).append(path)
                elif parts[1:2] == ["src"] and len(parts) == 4:  # not one of a table's rows
                    self.homes[f"{parts[0]}/{name[:-4]}"] = parts[2]

    def folder(self, path):
        """The room and folder of a private file, or of a public header by its source."""
        parts = path.split("/")
        if parts[1:2] == ["src"]:
            return parts[0], parts[2]
        if parts[1:2] == ["include"] and parts[-2] in ROOMS:
            return parts[0], self.homes.get(f"{parts[0]}/{parts[-1][:-2]}")
        return parts[0], None

    def included(self, path, quoted, angled):
        """The path of the file of ours that an include means, or None."""
        name = quoted or angled
        if name.startswith("dupin/"):
            room = name.split("/")[1]
            return f"{'kernel' if room == 'interop' else room}/include/{name}"
        base = name.rsplit("/", 1)[-1]
        beside = os.path.normpath(os.path.join(os.path.dirname(path), name))
        for candidate in (beside, f"{path.split('/')[0]}/src/{name}", f"tests/{name}",
                          f"cli/{name}" if path.startswith(("cli/", "tests/cli/")) else name,
                          os.path.normpath(name)):
            if candidate in self.paths:
                return candidate
        for candidate in self.private.get(base, []):
            # By any spelling: with too little or too much of the path in front.
            if quoted or candidate.endswith("/" + name):
                return candidate
        return None


def is_private(path):
    return "/src/" in path or path.startswith("cli/")


def fault_of_include(house, path, quoted, angled):
    """What is wrong with one include, or None."""
    room, folder = house.folder(path)
    name = quoted or angled
    target = house.included(path, quoted, angled)
    if target is None:
        for library, prefixes in LIBRARIES.items():
            if name.startswith(library) and not path.startswith(tuple(prefixes)):
                return f"{library} is allowed only in {', '.join(prefixes)}"
        return None
    if not quoted:
        return "our own headers are included in quotes"
    if name.startswith("dupin/interop"):
        inside = path.startswith(("kernel/src/", "kernel/include/dupin/interop/"))
        return None if inside or room in GUESTS else "only users may include dupin/interop"
    target_room, target_folder = house.folder(target)
    if room in GUESTS:
        may = re.search(r"_internal(_(test|fuzzer)\.cpp|\.h)$", path) or target_room in GUESTS or (
            path.startswith("tests/cli/") and target_room == "cli")  # the tool has no public headers
        return None if may or not is_private(target) else (
            f"{target} is private: only *_internal_test.cpp, *_internal_fuzzer.cpp and *_internal.h may "
            "include it")
    if target_room in GUESTS or ROOMS.index(target_room) > ROOMS.index(room):
        return f"{room} must not know {target_room}"
    if target_room != room:
        return f"{target} is private to {target_room}" if is_private(target) else None
    if folder and target_folder and target_folder != folder and (
            target_folder not in ARROWS[room].get(folder, [])):
        return f"no arrow leads from {room}/{folder} to {room}/{target_folder}"
    return None


def faults_of_namespaces(path, lines):
    parts = path.split("/")
    if parts[1:2] == ["src"]:
        known = {"dupin", f"dupin::{parts[2]}", parts[2]}
        for number, line in enumerate(lines, 1):
            match = NAMESPACE.match(line)
            if not match or line.startswith("namespace fs"):
                continue
            forward = match[1].startswith("dupin::") and match[1][7:] in ARROWS[parts[0]]
            if match[1] not in known and not forward:
                yield f"{path}:{number}: namespace {match[1]} in the folder {parts[2]}"
            if path.endswith(".h") and match[1] == "dupin":
                yield f"{path}:{number}: a private header in the public namespace"
    for number, line in enumerate(lines, 1):
        if re.search(r"\bnamespace\s+(\w+::)*detail\b", line):
            yield f"{path}:{number}: a namespace that says nothing"


def faults_of_file(house, path, text):
    lines = text.splitlines()
    limit = next(most for pattern, most in MOST_LINES if pattern.match(path))
    if len(lines) > limit:
        yield f"{path}: {len(lines)} lines, at most {limit}"
    for number, line in enumerate(lines, 1):
        if match := INCLUDE.match(line):
            if fault := fault_of_include(house, path, *match.groups()):
                yield f"{path}:{number}: {fault}"
        if re.search(r"\b(TODO|FIXME|XXX)\b", line):
            yield f"{path}:{number}: an unfinished note"
    yield from faults_of_namespaces(path, lines)


def faults_of_names(house):
    """Every source has a header of its name and a test of its name."""
    tests = {path.rsplit("/", 1)[-1] for path in house.paths if path.startswith("tests/")}
    for path in house.paths:
        if "/src/" not in path or not path.endswith(".cpp"):
            continue
        folder, name = path.rsplit("/", 1)
        room, stem = path.split("/")[0], name[:-4]
        headers = {other.rsplit("/", 1)[-1][:-2] for other in house.paths if other.endswith(".h")
                   and other.rsplit("/", 1)[0] in (folder, f"{room}/include/dupin/{room}")}
        is_row = len(path.split("/")) > 4  # of a table, whose header is that of all rows
        if stem not in headers and not is_row:
            if not any(stem.startswith(header + "_") for header in headers):
                yield f"{path}: no header has its name, or a name that it begins with"
        elif not {f"{stem}_test.cpp", f"{stem}_internal_test.cpp"} & tests:
            yield f"{path}: no test has its name"


def types(lines):
    """The (name, line number) of all types that a file defines, but for those in namespaces without a name."""
    rooms = []  # the namespaces around a line
    for number, line in enumerate(lines, 1):
        if match := ANY_NAMESPACE.match(line):
            rooms.append(match[1])
        elif line.startswith("}  // namespace"):
            rooms.pop()
        elif (match := TYPE.match(line)) and None not in rooms and ("{" in line or not line.endswith(";")):
            yield "::".join([*rooms, match[1]]), number


def faults_of_types(house):
    """One name is one type in all of the rooms: the linker keeps one vector<Run>::push_back for all Runs."""
    places = {}
    for path in house.paths:
        if path.split("/")[0] in ROOMS:
            for name, number in types((ROOT / path).read_text(encoding="utf-8").splitlines()):
                if places.setdefault(name, path) != path:
                    yield f"{path}:{number}: {name} is another type in {places[name]}"


def circles(graph):
    """The strongly connected components of more than one node, by Tarjan's algorithm."""
    index, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on_stack.add(node)
        for other in graph.get(node, ()):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on_stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            circle = []
            while not circle or circle[-1] != node:
                circle.append(stack.pop())
                on_stack.discard(circle[-1])
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in list(graph):
        if node not in index:
            visit(node)
    return found


def faults_of_plan(house, includes):
    for room, arrows in ARROWS.items():
        for circle in circles(arrows):
            yield f"{room}: the arrows run in a circle: {', '.join(circle)}"
        floors = {}

        def floor(folder):
            if folder not in floors:
                floors[folder] = 1 + max((floor(other) for other in arrows[folder]), default=0)
            return floors[folder]

        if not any(circles(arrows)) and max(map(floor, arrows)) > MOST_FLOORS:
            yield f"{room}: {max(floors.values())} floors, at most {MOST_FLOORS}"
        for folder in sorted({path.split("/")[2] for path in house.paths
                              if path.startswith(f"{room}/src/")} ^ set(arrows)):
            yield f"{room}/src/{folder}: the folders and the arrows differ"
    counts = collections.Counter(path.rsplit("/", 1)[0] for path in house.paths
                                 if not path.startswith("cli/"))
    for folder, count in counts.items():
        if count > MOST_FILES:
            yield f"{folder}: {count} files, at most {MOST_FILES}"
    graph = collections.defaultdict(set)
    for path, target in includes:
        one, other = re.sub(r"\.(h|cpp)$", "", path), re.sub(r"\.(h|cpp)$", "", target)
        room = path.split("/")[0]
        stems = []
        for x in (one, other):
            home = house.homes.get(f"{room}/{x.rsplit('/', 1)[-1]}")
            public = x.startswith(f"{room}/include/dupin/{room}/")
            stems.append(x.replace("include/dupin/" + room, f"src/{home}") if public and home else x)
        if stems[0] != stems[1]:
            graph[stems[0]].add(stems[1])
    for circle in circles(graph):
        if len(circle) > LARGEST_CIRCLE:
            yield f"{len(circle)} files include each other: {', '.join(circle)}"


def faults():
    """All that is wrong, a line each."""
    house = House(sources())
    found, includes = [], []
    for path in house.paths:
        text = (ROOT / path).read_text(encoding="utf-8")
        found += faults_of_file(house, path, text)
        if path.split("/")[0] in ROOMS:
            for line in text.splitlines():
                if match := INCLUDE.match(line):
                    if target := house.included(path, *match.groups()):
                        includes.append((path, target))
    return found + list(faults_of_names(house)) + list(faults_of_types(house)) + list(faults_of_plan(house, includes))


def main():
    sys.setrecursionlimit(10000)
    found = faults()
    print("\n".join(found) if found else "layers: clean")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
