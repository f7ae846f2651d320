#!/usr/bin/env python3
"""Lets other people's programs read what `dupin build` makes of the examples, and judges from what they say.

Usage: tools/clients.py BUILD_FOLDER [--write] [CLIENT ...] [--examples NAME ...]

Every document in examples/ is built in every format by BUILD_FOLDER/cli/dupin, and read by each client that is
installed. What a client counts has to be what the tool's own report says: triangles, volume, and that every edge
is shared by two triangles in opposite directions. The table is printed, or with --write becomes docs/clients.md,
which says how to install the clients. Exit code 1 if a file is not accepted and the reason is not a client's own
that is known (KNOWN), 77 if no client is installed.
"""
import argparse
import collections
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "clients.md"
PATTERNS = ["*.json", "*.pcf", "*.swc", "*.graph"]
OPTIONS = {"frame.graph": ["--radius", "2"]}  # docs/graphs.md
REFUSED = {("tight.json", None): "its blend folds, which is what it is for"}
WITHOUT_STEP = "need OpenCASCADE"  # builds that have not got it
EXTENSIONS = {"stl": "stl", "stl-ascii": "stl", "off": "off", "obj": "obj", "ply": "ply", "ply-ascii": "ply",
              "3mf": "3mf", "glb": "glb", "vtp": "vtp", "msh-surface": "msh", "step": "step"}
# Formats in which points stand several times, so that who wants to know neighbours makes one of them.
REPEATED_POINTS = ["stl", "stl-ascii", "ply", "ply-ascii", "glb"]
METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1, "in": 0.0254, "ft": 0.3048}
TOLERANCE = 1e-4  # of volumes, relative
OWN_TRIANGLES = 1e-2  # the same, where a client made the triangles of a STEP file by itself
MOST_SECONDS = 300
MOST_MEMORY = 8 << 30  # of what triangulates solids of any size by the same few micrometres
READERS = ROOT / "tools" / "client_readers"
DEBIANS_PYTHON = "/usr/bin/python3"  # has what Debian packages, whichever runs this
SKIPPED = 77


@dataclasses.dataclass
class Built:
    """A file, and what the tool said of it."""
    example: str
    format: str
    path: pathlib.Path
    triangles: int | None  # None of smooth surfaces
    volume: float  # in the file's unit of length
    solids: int | None


@dataclasses.dataclass
class Said:
    """What a client says of a file; None where it does not say."""
    triangles: int | None = None
    volume: float | None = None
    open_edges: int | None = None
    solids: int | None = None
    complaint: str = ""
    remark: str = ""  # what is no complaint
    tolerance: float = TOLERANCE


@dataclasses.dataclass
class Client:
    name: str
    formats: list
    version: object  # a function without arguments; None if the client is not there
    read: object  # a function from several Built of one example to a Said of each
    judged: str  # what it is asked for
    packages: str


def run(*command, **environment):
    """The exit code and all that a program printed."""
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace",
                              timeout=MOST_SECONDS, env={**os.environ, **environment}, check=False)
    except subprocess.TimeoutExpired:
        return -1, f"no answer within {MOST_SECONDS} s"
    return done.returncode, done.stdout + done.stderr


def one_line(text, most=300):
    """Without colours, and what differs from one run to the next: temporary folders and addresses."""
    text = re.sub(rf"\x1b\[[0-9;]*m|{tempfile.gettempdir()}/tmp\w+/|(?<=0x)[0-9a-f]{{5,}}", "", text)
    text = " ".join(text.split())
    return text if len(text) <= most else text[:most] + "..."


def last_line(text):
    return one_line((text.strip().splitlines() or ["nothing at all"])[-1])


def number_after(label, text, kind=float):
    """The number after a label, or None; the sum where there are several."""
    found = [kind(match) for match in re.findall(label + r"\s*([-+0-9.eE]+)", text)]
    return sum(found) if found else None


def complaints(text, pattern=r"(?i)\berror|\bwarn|not a file|exception|unable|fail", but=r"(?!)"):
    return one_line("; ".join(line for line in text.splitlines()
                              if re.search(pattern, line) and not re.search(but, line)))


def one_by_one(read):
    return lambda files: [read(file) for file in files]


def version_of(command, pattern):
    def version():
        if not shutil.which(command[0]):
            return None
        match = re.search(pattern, run(*command)[1])
        return match.group(1) if match else None
    return version


# Programs.

@one_by_one
def read_admesh(file):
    code, said = run("admesh", file.path)
    before = {name: int(count) for name, count in re.findall(r"^([A-Z][\w ]*?) +: +(\d+) +\d+$", said, re.MULTILINE)}
    repairs = {name: int(count) for name, count in re.findall(
        r"^(Degenerate facets|Edges fixed|Facets \w+|Backwards edges|Normals fixed) +: +(\d+)", said, re.MULTILINE)}
    wrong = ", ".join(f"{name}: {count}" for name, count in repairs.items() if count)
    return Said(triangles=before.get("Number of facets"), volume=number_after(r"Volume +:", said),
                open_edges=before.get("Total disconnected facets"),
                complaint=wrong if code == 0 and len(repairs) == 7 else last_line(said))


@one_by_one
def read_assimp(file):
    code, said = run("assimp", "info", file.path, "--raw", "--silent", "-vds", "-l")
    return Said(triangles=number_after(r"\nFaces:", said, int),
                complaint=complaints(said) or ("" if code == 0 else last_line(said)))


@one_by_one
def read_f3d(file):
    code, said = run("f3d", "--dry-run", "--no-render", "--verbose", "--geometry-only", file.path)
    polygons = number_after("Number of polygons:", said, int)
    wrong = complaints(said) or ("" if code == 0 else f"exit code {code}: {last_line(said)}")
    if file.triangles is None:
        return Said(complaint=wrong or ("" if polygons else "no polygons"))
    return Said(triangles=polygons, complaint=wrong)


@one_by_one
def read_prusa(file):
    code, said = run("prlimit", f"--as={MOST_MEMORY}", "prusa-slicer", "--info", file.path)
    values = dict(re.findall(r"^(\w+) = +(.*)$", said, re.MULTILINE))
    repairs = [f"{name} = {value}" for name, value in values.items()
               if value != "0" and re.search("open|degenerate|fixed|removed|added|reversed|backwards", name)]
    wrong = ", ".join(repairs + ([] if values.get("manifold") == "yes" else [f"manifold = {values.get('manifold')}"]))
    is_smooth = file.triangles is None
    return Said(triangles=None if is_smooth else int(values.get("number_of_facets", -1)),
                volume=float(values.get("volume", "nan")), tolerance=OWN_TRIANGLES if is_smooth else TOLERANCE,
                complaint=complaints(said, but="StaticPrintConfigs") or wrong or ("" if code == 0 else last_line(said)))


OCCT_SCRIPT = """pload MODELING XSDRAW
stepread {path} read *
foreach shape [directory read_*] {{
  puts [checkshape $shape]
  puts [vprops $shape 1e-6]
  puts [nbshapes $shape]
}}
"""


def version_of_occt():
    if not shutil.which("occt-draw"):
        return None
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder, "version.tcl")
        script.write_text("pload MODELING XSDRAW\nputs [dversion]\n", encoding="utf-8")
        match = re.search(r"Open CASCADE Technology (\S+)", run("occt-draw", "-b", "-f", script)[1])
    return match.group(1) if match else None


@one_by_one
def read_occt(file):
    script = file.path.with_suffix(".tcl")
    script.write_text(OCCT_SCRIPT.format(path=file.path), encoding="utf-8")
    _, said = run("occt-draw", "-b", "-f", script)
    wrong = complaints(said, pattern=r"(?i)exception|fault|\*\*|not valid|\bfail", but="Relative error")
    if not wrong and "This shape seems to be valid" not in said:
        wrong = last_line(said)
    return Said(volume=number_after(r"Mass :", said), solids=number_after(r"SOLID +:", said, int), complaint=wrong)


# Clients that are libraries, by the programs in READERS.

def set_node_path():
    """Where npm install -g leaves things, which node does not look into by itself."""
    if "NODE_PATH" not in os.environ and shutil.which("npm"):
        os.environ["NODE_PATH"] = run("npm", "root", "-g")[1].strip()


def read_by(*command, **environment):
    """Reads an example's files by a program that prints a line of JSON for each."""
    def read(files):
        asked = json.dumps([[str(file.path), file.format, file.format in REPEATED_POINTS] for file in files])
        _, said = run(*command, asked, **environment)
        answers = {}
        for line in said.splitlines():
            if line.startswith("SAID "):
                answer = json.loads(line[5:])
                path = answer.pop("path")
                answers[path] = Said(**answer)
        silence = Said(complaint="no answer: " + last_line(said))
        return [answers.get(str(file.path), silence) for file in files]
    return read


def version_by(*command):
    """What a line of code prints, if it can."""
    def version():
        if not shutil.which(command[0]):
            return None
        code, said = run(*command)
        return one_line(said) if code == 0 and said.strip() else None
    return version


def read_by_python(name):
    return read_by(DEBIANS_PYTHON, "-B", READERS / name)


LIB3MF_VERSION = """
import ctypes, ctypes.util, os
major, minor = ctypes.c_uint32(), ctypes.c_uint32()
ctypes.CDLL(ctypes.util.find_library("3MF")).lib3mf_getinterfaceversion(ctypes.byref(major), ctypes.byref(minor))
print(f"{major.value}.{minor.value}", flush=True)
os._exit(0)
"""
# What clients cannot do, each looked into: by client and format, or by client, format and example.
FLOATS = "some points of the example differ as doubles and not as floats, which is what the client keeps"
EMPTY_TRIANGLES = ("some of the triangles that it makes of the surfaces have no area; without them, what it exports is "
                   "closed, says admesh")
NEAR_POINTS = "gmsh makes one of points nearer than 1e-8 of the diagonal of the box, which the example has"
KNOWN = {
    ("admesh", "stl-ascii"): "admesh 0.98 reads ASCII STL of one solid; ours has one for each label",
    ("gmsh", "ply"): "gmsh 4 takes the coordinates of a binary PLY for floats, and knows no property of a face beside "
                     "its corners; ours are doubles, and faces have a label",
    ("meshio", "obj"): "meshio 5 wants as many normals as points in OBJ, where either are numbered by themselves",
    ("meshio", "ply"): "meshio 5 cannot read a binary PLY whose faces have a property beside their corners; ours have "
                       "a label",
    ("admesh", "stl", "header_forty.json"): "admesh computes the normals of thin triangles in floats; ours are "
                                            "the exact ones, rounded",
    ("gmsh", "stl", "header_forty.json"): NEAR_POINTS,
    ("gmsh", "stl-ascii", "header_forty.json"): NEAR_POINTS,
    **{("PrusaSlicer", "step", example): "it sums the volumes of millions of triangles in floats; its own triangles "
                                         "summed in doubles have ours"
       for example in ("header_forty.json", "vessel.json")},
    **{("Blender", form, "header_forty.json"): FLOATS for form in ("ply", "ply-ascii")},
    **{("VTK", form, "header_forty.json"): FLOATS for form in ("obj", "ply", "ply-ascii")},
    **{("PrusaSlicer", "step", example): EMPTY_TRIANGLES for example in (
        "around.json", "equal-tee.json", "frame.graph", "junction.json", "neuron.swc", "plant-run.json",
        "ringed-canal.json")},
}
CLIENTS = [
    Client("admesh", ["stl", "stl-ascii"], version_of(["admesh", "--version"], r"version (\S+)"), read_admesh,
           "facets, volume, no edge without a neighbour, nothing to repair", "admesh"),
    Client("assimp", ["stl", "stl-ascii", "off", "obj", "ply", "ply-ascii", "3mf", "glb"],
           version_of(["assimp", "version"], r"Version (\S+)"), read_assimp,
           "`assimp info --raw -vds`: faces, its own validation, no error or warning", "assimp-utils"),
    Client("Blender", ["stl", "stl-ascii", "obj", "ply", "ply-ascii", "glb"],
           version_of(["blender", "--version"], r"Blender (\S+)"),
           read_by("blender", "-b", "--factory-startup", "--python", READERS / "read_blender.py", "--",
                   PATH="/usr/bin:" + os.environ["PATH"], PYTHONDONTWRITEBYTECODE="1"),
           "its importers: triangles, volume, closed. Debian's NumPy no longer has the name `bool` that the glTF "
           "importer uses; the script gives it that name first", "blender"),
    Client("f3d", ["stl", "stl-ascii", "obj", "ply", "ply-ascii", "glb", "vtp", "step"],
           version_of(["f3d", "--version"], r"(?i)version:? *(\d[\d.]*\d)"), read_f3d,
           "`f3d --no-render --verbose`: polygons (of STEP: any), no error or warning", "f3d"),
    Client("glTF validator", ["glb"], version_by("node", "-p", "require('gltf-validator').version()"),
           read_by("node", READERS / "read_gltf.js"),
           "Khronos' own: triangles, no error or warning", "npm: gltf-validator"),
    Client("gmsh", ["stl", "stl-ascii", "ply", "ply-ascii", "msh-surface", "step"],
           version_by(DEBIANS_PYTHON, "-c", "import gmsh; gmsh.initialize(); "
                                            "print(gmsh.option.getString('General.Version'))"),
           read_by_python("read_gmsh.py"),
           "triangles, volume, closed; of STEP the number of solids (of volumes, gmsh does not ask OpenCASCADE for an "
           "accuracy, and gets some that are several percent off); no error or warning",
           "python3-gmsh"),
    Client("lib3mf", ["3mf"], version_by(DEBIANS_PYTHON, "-c", LIB3MF_VERSION), read_by_python("read_lib3mf.py"),
           "strict mode: `ismanifoldandoriented`, triangles, volume, no warning", "lib3mf1"),
    Client("meshio", ["stl", "stl-ascii", "off", "obj", "ply", "ply-ascii", "msh-surface"],
           version_by(DEBIANS_PYTHON, "-c", "import meshio; print(meshio.__version__)"),
           read_by_python("read_meshio.py"),
           "triangles, volume, closed", "python3-meshio"),
    Client("OpenCASCADE", ["step"], version_of_occt, read_occt,
           "its Draw: `checkshape`, the number of solids and their volume", "occt-draw libocct-draw-dev"),
    Client("PrusaSlicer", ["stl", "stl-ascii", "obj", "3mf", "step"],
           version_of(["prusa-slicer", "--help"], r"PrusaSlicer-(\d[\d.]*)"), read_prusa,
           "`prusa-slicer --info`: facets, volume (of STEP, which it triangulates itself, within "
           f"{OWN_TRIANGLES:.0%}), manifold, nothing to repair", "prusa-slicer"),
    Client("VTK", ["stl", "stl-ascii", "obj", "ply", "ply-ascii", "vtp"],
           version_by(DEBIANS_PYTHON, "-c", "from vtkmodules.vtkCommonCore import vtkVersion as v; "
                                            "print(v.GetVTKVersion())"), read_by_python("read_vtk.py"),
           "cells, `vtkMassProperties`, `vtkFeatureEdges` without boundary or non-manifold edges", "python3-vtk9"),
]


def reason(client, form, example):
    """Why a client is known not to accept a file, or None."""
    return KNOWN.get((client, form)) or KNOWN.get((client, form, example))


def examples(names):
    found = sorted(path for pattern in PATTERNS for path in (ROOT / "examples").glob(pattern))
    if missing := set(names or []) - {path.name for path in found}:
        sys.exit(f"no such example: {', '.join(sorted(missing))}")
    return [path for path in found if not names or path.name in names]


def build(tool, example, form, folder):
    """The file, or the tool's words why there is none."""
    path = folder / f"{example.stem}-{form}.{EXTENSIONS[form]}"
    code, said = run(tool, "--json", "build", example, "-o", path, "--format", form, *OPTIONS.get(example.name, []))
    report = json.loads(said[said.index("{"):]) if "{" in said else {"error": {"message": said}}
    if code != 0:
        error = report.get("error", {"message": said, "where": ""})
        return None, one_line(f"exit code {code}: {error.get('where', '')} {error['message']}".replace(f"{ROOT}/", ""))
    output = report["output"]
    measured = output.get("check", output)
    factor = METRES[report["unit"]] ** 3 if form == "glb" else 1
    solids = len(output["solids"]) if "solids" in output else None
    return Built(example.name, form, path, measured.get("triangles"), measured["volume"] * factor, solids), None


def fault(file, said):
    """Why a file is not accepted, or None."""
    if said.complaint:
        return one_line(said.complaint)
    for what, ours, theirs in [("triangles", file.triangles, said.triangles), ("solids", file.solids, said.solids),
                               ("edges that two triangles do not share", 0, said.open_edges)]:
        if ours is not None and theirs is not None and ours != theirs:
            return f"{theirs} {what}, not {ours}"
    if said.volume is not None and not abs(said.volume - file.volume) <= said.tolerance * abs(file.volume):
        return f"a volume of {said.volume:.9g}, not {file.volume:.9g}"
    if said.triangles is None and said.volume is None and file.triangles is not None:
        return "it says nothing of the file"
    return None


class Record:
    """What became of every file."""

    def __init__(self):
        self.tried = collections.defaultdict(set)
        self.accepted = collections.Counter()
        self.faults = []  # (client, format, example, words)
        self.remarks = []  # the same
        self.refused = []  # (example, format, words)
        self.bad = False

    def see(self, client, file, said):
        self.tried[client.name, file.format].add(file.example)
        if said.remark:
            self.remarks.append((client.name, file.format, file.example, said.remark))
        words = fault(file, said)
        if words is None:
            self.accepted[client.name, file.format] += 1
        else:
            self.faults.append((client.name, file.format, file.example, words))
            self.bad = self.bad or not reason(client.name, file.format, file.example)

    def refuse(self, example, form, words):
        self.refused.append((example, form, words))
        self.bad = self.bad or not REFUSED.keys() & {(example, None), (example, form)}


def try_all(tool, clients, names):
    record = Record()
    forms = [form for form in EXTENSIONS if any(form in client.formats for client in clients)]
    for example in examples(names):
        print(f"{example.name} ...", file=sys.stderr, flush=True)
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for form in forms:
                file, words = build(tool, example, form, pathlib.Path(folder))
                if file:
                    files.append(file)
                elif WITHOUT_STEP not in words:
                    record.refuse(example.name, form, words)
            for client in clients:
                mine = [file for form in client.formats for file in files if file.format == form]
                for file, said in zip(mine, client.read(mine) if mine else []):
                    record.see(client, file, said)
    return record


def system():
    text = pathlib.Path("/etc/os-release").read_text(encoding="utf-8")
    return re.search(r'^PRETTY_NAME="(.*)"', text, re.MULTILINE).group(1)


def table(clients, versions, record):
    yield "| client | version | format | accepted | of |"
    yield "|---|---|---|---|---|"
    for client in clients:
        if not versions[client.name]:
            yield f"| {client.name} | not installed when this was made | {', '.join(client.formats)} | | |"
            continue
        for form in client.formats:
            count, of = record.accepted[client.name, form], len(record.tried[client.name, form])
            yield f"| {client.name} | {versions[client.name]} | {form} | {count} | {of} |"


def list_of_words(record, faults):
    """What was said of several examples in one line."""
    grouped = collections.defaultdict(list)
    for client, form, example, words in faults:
        # What is known of a format reads the same but for numbers.
        pattern = re.sub(r"-?\b\d+\b", "...", words) if (client, form) in KNOWN else words
        grouped[client, form, pattern, reason(client, form, example)].append(example)
    for (client, form, words, why), found in sorted(grouped.items(), key=lambda group: [group[0][:3], group[1]]):
        tried = len(record.tried[client, form])
        rest = sorted(record.tried[client, form] - set(found))
        which = found if 2 * len(found) <= tried or tried <= 3 else rest
        names = ", ".join(f"`{example}`" for example in which)
        start = "" if which is found else "all but " if rest else "all"
        yield f"- {client}, {form}, {start}{names}: \"{words}\"" + (f" ({why})" if why else "")


def list_of_refusals(record):
    grouped = collections.defaultdict(list)
    for example, form, words in record.refused:
        grouped[example, words].append(form)
    for (example, words), forms in grouped.items():
        why = REFUSED.get((example, None)) or REFUSED.get((example, forms[0])) or "not expected"
        yield f"- `{example}` ({', '.join(forms)}): {why}. \"{words}\""


HEAD = """# Clients
Files that `dupin build` writes of every document in `examples/`, as other people's programs read them. Accepted is \
what the program reads without a complaint, and of which it says the same as the tool's report, as far as it says it: \
so many triangles, that volume (within {tolerance:g}, relative), every edge shared by two triangles in opposite \
directions. Where a format repeats points ({repeated}), points at the same place are made one first. What Blender, \
gmsh, lib3mf and meshio hand over, points and triangles, is measured by the script.

This page is made by `tools/clients.py BUILD_FOLDER --write`, here on {system} with {version}; `ctest -L clients` \
tries three examples. The clients are no part of `tools/setup`, as they are large. All of them:

```text
apt-get install --no-install-recommends {packages}
npm install -g {npm}
```
"""
LOOKED_INTO = """
What a client said, and in brackets what was found to be the reason. Without one, the script fails.
"""
ELSEWHERE = """
Not in the table:

- Chromium shows report pages in `tests/cli/report_page_test.py` (`ctest -L browser`).
- gmsh and OpenFOAM take meshes for solvers in `tests/cli/solver_programs_test.py` (`ctest -L clients`).
"""


def page(tool, clients, versions, record):
    packages = " ".join(client.packages for client in clients if not client.packages.startswith("npm: "))
    npm = " ".join(client.packages[5:] for client in clients if client.packages.startswith("npm: "))
    intro = HEAD.format(tolerance=TOLERANCE, repeated=", ".join(REPEATED_POINTS), system=system(), packages=packages,
                        npm=npm, version=one_line(run(tool, "--version")[1]))
    lines = [intro, *table(clients, versions, record), "", "What each is asked for:", ""]
    lines += [f"- {client.name}: {client.judged}." for client in clients]
    lines += [ELSEWHERE, "## Not accepted", LOOKED_INTO]
    lines += [*(list(list_of_words(record, record.faults)) or ["Nothing."]), ""]
    if record.remarks:
        lines += ["## Accepted with a remark", "", *list_of_words(record, record.remarks), ""]
    lines += ["## Refused by the tool", "", *(list(list_of_refusals(record)) or ["Nothing."])]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("clients", nargs="*", metavar="CLIENT", help="; ".join(client.name for client in CLIENTS))
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--examples", nargs="+", metavar="NAME")
    asked = parser.parse_intermixed_args()
    names = {name.lower() for name in asked.clients}
    if unknown := names - {client.name.lower() for client in CLIENTS}:
        parser.error(f"no such client: {', '.join(sorted(unknown))}")
    if asked.write and (names or asked.examples):
        parser.error("--write is for all clients and all examples")
    tool = asked.build.resolve() / "cli" / "dupin"
    if not tool.exists():
        parser.error(f"there is no {tool}")
    chosen = [client for client in CLIENTS if not names or client.name.lower() in names]
    set_node_path()
    versions = {client.name: client.version() for client in chosen}
    if not any(versions.values()):
        print("no client is installed")
        return SKIPPED
    record = try_all(tool, [client for client in chosen if versions[client.name]], asked.examples)
    text = page(tool, chosen, versions, record)
    if asked.write:
        DOCUMENT.write_text(text, encoding="utf-8")
    else:
        print(text, end="")
    return 1 if record.bad else 0


if __name__ == "__main__":
    sys.exit(main())
