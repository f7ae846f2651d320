#!/usr/bin/env python3
"""Plants of many components, larger than memory: time, peak memory, and how they grow.

Usage: bench/large_plants.py BUILD_FOLDER [--components N ...] [--tolerance MM] [--memory SIZE]
       [--compare N] [--folder DIR] [--connected | --rack]

Plants are seeded: lines of pipes, bends, a reducer and filleted branches in a rack, each line apart from the
next, 200 m from the origin. Each is built within --memory, and what was written is checked within it; up to
--compare components also at once, and the bytes and reports are compared. With --connected, all lines begin in
headers, and are one thing that hangs together; with --rack, components are pipes, half of them through all of the
other half, without a ring between them. Then a branch of one line is moved, or a pipe made thinner, and the plant is
built again from a cache.
"""
import argparse
import copy
import filecmp
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

LINES_PER_LEVEL = 50
PITCH = 900  # of lines, mm
HEADER = 199_500  # where lines begin that hang together, mm
RACK_PITCH = 300  # of its pipes, mm
PER_LINE = 12  # components, without fillets


def line(number, choose):
    """The parts of one line."""
    x, y, z = 200_000 + choose.randrange(1000), PITCH * (number % LINES_PER_LEVEL), PITCH * (number // LINES_PER_LEVEL)
    radius = choose.choice([57.15, 84.15, 109.55])

    def name(part):
        return f"l{number}-{part}"

    def length():
        return round(choose.uniform(700, 2500), 1)

    def ahead(part, previous, size):
        return {"name": name(part), "pipe": {"from": name(previous) + ".end", "length": size}}

    def bend(part, previous, toward):
        return {"name": name(part), "elbow": {"from": name(previous) + ".end", "bend_radius": 3 * radius, "angle": 45,
                                              "toward": toward}}

    parts = [{"name": name("p0"), "pipe": {"from": [x, y, z], "to": [x + length(), y, z], "radius": radius}},
             bend("b0", "p0", [0, 0, 1]), ahead("p1", "b0", 150), bend("b1", "p1", [1, 0, 0])]
    previous = "b1"
    for i in range(2, 5):
        run = length()
        parts.append(ahead(f"p{i}", previous, run))
        parts.append({"name": name(f"n{i}"),
                      "pipe": {"on": name(f"p{i}"), "at": run / 2, "direction": [0, 0.2, 1], "length": radius + 150,
                               "radius": radius / 2}})
        parts.append({"name": name(f"f{i}"),
                      "fillet": {"between": [name(f"p{i}"), name(f"n{i}")], "radius": radius / 8}})
        previous = f"p{i}"
    parts.append({"name": name("r"), "cone": {"from": name(previous) + ".end", "length": 120, "end_radius": 0.75 * radius}})
    parts.append(ahead("p5", "r", length()))
    return parts


def header(number):
    """A pipe across the beginning of a line, which goes on from that of the line beside it, or up from the level below."""
    y, z = PITCH * (number % LINES_PER_LEVEL), PITCH * (number // LINES_PER_LEVEL)
    if y:
        return [{"name": f"h{number}", "pipe": {"from": f"h{number - 1}.end", "length": PITCH}}]
    parts = [{"name": f"h{number}", "pipe": {"from": [HEADER, -PITCH / 2, z], "to": [HEADER, PITCH / 2, z], "radius": 200}}]
    if z:
        parts.append({"name": f"u{number}", "pipe": {"from": [HEADER, 80 - PITCH / 2, z - PITCH], "radius": 60,
                                                     "to": [HEADER, 80 - PITCH / 2, z]}})
    return parts


def plant(components, tolerance, is_connected=False):
    choose = random.Random(21)
    lines = [line(number, choose) for number in range(math.ceil(components / PER_LINE))]
    if is_connected:
        for number, parts in enumerate(lines):
            parts[0]["pipe"]["from"][0] = HEADER
            parts += header(number)
    return {"units": "mm", "tolerance": tolerance, "parts": [part for parts in lines for part in parts]}


def rack(pipes, tolerance):
    """Pipes along x and pipes along y through each other."""
    side, parts = pipes // 2, []
    end = RACK_PITCH * side - RACK_PITCH / 2
    for i in range(side):
        at = RACK_PITCH * i
        for name, place, radius in [("x", lambda t, at=at: [t, at, 0], 60), ("y", lambda t, at=at: [at, t, 10], 50)]:
            parts.append({"name": f"{name}{i}",
                          "pipe": {"from": place(-RACK_PITCH / 2), "to": place(end), "radius": radius}})
    return {"units": "mm", "tolerance": tolerance, "parts": parts}


def with_one_edit(document):
    edited = copy.deepcopy(document)
    branches = [part for part in edited["parts"] if "on" in part.get("pipe", {})]
    if branches:
        branches[len(branches) // 2]["pipe"]["at"] *= 0.9
    else:
        edited["parts"][len(edited["parts"]) // 2]["pipe"]["radius"] -= 1
    return edited


def run(tool, arguments):
    """Seconds, peak bytes and the report."""
    start = time.monotonic()
    process = subprocess.Popen([tool, "--json", *map(str, arguments)], stdout=subprocess.PIPE)
    report = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode > 1:
        sys.exit("failed: " + " ".join(map(str, arguments)))
    return time.monotonic() - start, usage.ru_maxrss * 1024, json.loads(report)


def exponent(rows, column):
    (n, *first), (m, *last) = rows[0], rows[-1]
    return math.log(last[column] / first[column]) / math.log(m / n)


def measured(tool, folder, components, arguments):
    """A row of the table, as for exponents: components, and seconds and bytes of the build and of the check."""
    document, edited = folder / "plant.json", folder / "edited.json"
    content = (rack(components, arguments.tolerance) if arguments.rack
               else plant(components, arguments.tolerance, arguments.connected))
    document.write_text(json.dumps(content), encoding="utf-8")
    edited.write_text(json.dumps(with_one_edit(content)), encoding="utf-8")
    tiled, whole = folder / "tiled.stl", folder / "whole.stl"
    seconds, memory, report = run(tool, ["build", document, "-o", tiled, "--memory", arguments.memory])
    triangles = report["output"]["check"]["triangles"]
    check_seconds, check_memory, checked = run(tool, ["check", tiled, "--memory", arguments.memory])
    if not checked["solid"]:
        sys.exit(f"{components} components: what was written is no solid")
    same = after = ""
    if components <= arguments.compare:
        if run(tool, ["check", tiled])[2] != checked:
            sys.exit(f"{components} components: the check in tiles says otherwise than that of the whole")
        limit = ["--triangles", 10 * triangles]
        run(tool, ["build", document, "-o", whole, *limit])
        if not filecmp.cmp(tiled, whole, shallow=False):
            sys.exit(f"{components} components: tiles give other bytes than the whole")
        run(tool, ["build", document, "-o", whole, "--cache", folder / f"cache-{components}"])
        after, _, _ = run(tool, ["build", edited, "-o", whole, "--cache", folder / f"cache-{components}"])
        same, after = "yes", f"{after:.2f}"
    print(f"{components:>10} {triangles:>12} {seconds:>9.1f} {triangles / seconds / 1e6:>8.2f} {memory / 1e6:>9.0f} "
          f"{check_seconds:>9.1f} {check_memory / 1e6:>9.0f} {same:>6} {after:>7}", flush=True)
    return components, seconds, memory, check_seconds, check_memory


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--components", type=int, nargs="+", default=[1000, 10_000, 100_000])
    parser.add_argument("--tolerance", type=float, default=0.05)
    parser.add_argument("--memory", default="4GB")
    parser.add_argument("--compare", type=int, default=10_000)
    parser.add_argument("--folder", help="for the files, which may be large")
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument("--connected", action="store_true", help="all lines begin in headers")
    kinds.add_argument("--rack", action="store_true", help="pipes through each other")
    arguments = parser.parse_args()
    tool = str((arguments.build / "cli" / "dupin").resolve())
    print(f"{'components':>10} {'triangles':>12} {'s':>9} {'M tri/s':>8} {'peak MB':>9} {'check s':>9} {'check MB':>9} "
          f"{'equal':>6} {'edit s':>7}")
    if arguments.folder:
        os.makedirs(arguments.folder, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        rows = [measured(tool, pathlib.Path(folder), components, arguments) for components in arguments.components]
    if len(rows) > 1:
        print(f"exponents: time {exponent(rows, 0):.2f}, memory {exponent(rows, 1):.2f}, of the check "
              f"{exponent(rows, 2):.2f} and {exponent(rows, 3):.2f}")


if __name__ == "__main__":
    main()
