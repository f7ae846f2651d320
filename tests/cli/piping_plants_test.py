#!/usr/bin/env python3
"""Seeded random plants, as dirty as real ones, end to end through the tool.

Lines of many components walk beside each other, each within its own slab, so that nothing but its
own line can touch a component; coordinates are those of a plant, far from the origin. Every ninth
end or so is dirty: roundings, overlaps, ends that miss each other, bores that are missing or that
jump, reducers without length, unequal legs, lines and words that nobody knows. What is known of a
plant when it is made has to be found in the solids of all three regions.
"""
import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

SIZES = {50: 60.3, 80: 88.9, 100: 114.3, 150: 168.3, 200: 219.1}
FILLETS = []  # of every other plant
SNAP, BRIDGE, WALL = 0.05, 0.5, 3.0


def add(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


class Plant:
    """Writes components one after the other, and keeps what is true of them."""

    def __init__(self, seed, components):
        self.random = random.Random(seed)
        self.text = ["ISOGEN-FILES ISOGEN.FLS", "  UNITS-BORE MM", "UNITS-CO-ORDS MM",
                     "PIPELINE-REFERENCE RANDOM-%d" % seed, "    AREA caf\xe9"]
        self.is_first = False
        self.components = self.lines = self.misfits = self.zero = 0
        while self.components < components:
            self.line()

    def point(self, key, place, size=None):
        self.text.append("    %s %s%s" % (key, " ".join("%13.4f" % x for x in place),
                                          "" if size is None else " %10.4f" % size))

    def component(self, kind, ends, **more):
        """Ends are (place, size); `more` has a centre and branches."""
        self.components += 1
        self.text.append((" " if self.random.random() < 0.05 else "") + kind)
        for place, size in ends:
            self.point(self.random.choice(["END-POINT", "END-POINT", "ENDPOINT"]), place, size)
        if "center" in more:
            self.point("CENTRE-POINT", more["center"])
        for i, (place, size) in enumerate(more.get("branches", []), 1):
            self.point("BRANCH%d-POINT" % i, place, size)
        for extra in more.get("extra", []):
            self.text.append("    " + extra)
        if self.random.random() < 0.1:
            self.text += ["    <SKEY> XXXX", "    COMPONENT-ATTRIBUTE4 17"]
        if self.random.random() < 0.05:
            self.text += ["SUPPORT", "    SKEY SKID", "MESSAGE-SQUARE", "some free text"]

    def dirty(self, place):
        """The place as the next component has it; `True` if it needs a bridge."""
        dirt = self.random.random()
        if dirt < 0.85 or self.is_first:
            return place, False
        if dirt < 0.97:  # rounded, or an overlap or gap of ten micrometres
            return add(place, [self.random.uniform(-0.01, 0.01) for _ in place]), False
        self.misfits += 1
        way = [self.random.gauss(0, 1) for _ in place]
        return add(place, way, self.random.uniform(0.12, 0.2) / math.hypot(*way)), True

    def line(self):
        """One line along x, with jogs along y and z."""
        x0 = [212345.678, 98765.4321 + 5000.0 * self.lines, 12345.678]
        self.lines += 1
        self.here, self.way = list(x0), [1.0, 0.0, 0.0]
        self.low = x0
        self.size = self.random.choice(list(SIZES))
        self.is_first = True
        self.pipe(500)
        self.is_first = False
        for _ in range(40):
            self.random.choice([self.elbows, self.tee, self.reducer, self.valve, self.olet,
                                self.zero_reducer, self.cross, self.bend, self.tap, self.coupling,
                                self.elbows])()
            self.pipe(self.random.uniform(4, 8) * self.size)
        if self.random.random() < 0.5:
            end = add(self.here, self.way, 0.3 * self.size)
            self.component("CAP", [(self.here, self.size), (end, self.size)])

    def straight(self, kind, length, size=None, extra=()):
        """Goes on along the way; `size` is that of the other end."""
        start, bridged = self.dirty(self.here)
        end = add(start if bridged else self.here, self.way, length)
        own = [None if kind != "PIPE" and self.random.random() < 0.05 and size is None
               else self.size, size or self.size]
        if self.random.random() < 0.5:
            self.component(kind, [(start, own[0]), (end, own[1])], extra=extra)
        else:
            self.component(kind, [(end, own[1]), (start, own[0])], extra=extra)
        self.here, self.size = end, size or self.size

    def pipe(self, length):
        self.straight("PIPE", length, extra=["WOBBLE 3"] if self.random.random() < 0.02 else [])

    def coupling(self):
        self.straight(self.random.choice(["COUPLING", "GASKET", "INSTRUMENT", "MISC-COMPONENT"]),
                      self.random.uniform(0.05, 1) * self.size)

    def valve(self):
        self.straight("FLANGE", 0.6 * self.size)
        self.straight("GASKET", 1.6)
        self.straight("VALVE", 2 * self.size)
        self.straight("FLANGE", 0.6 * self.size)

    def reducer(self):
        size = self.random.choice([s for s in SIZES if s != self.size])
        length = 1.2 * max(size, self.size)
        if self.random.random() < 0.5:
            self.straight("REDUCER-CONCENTRIC", length, size)
            return
        aside = [0, 0, (SIZES[self.size] - SIZES[size]) / 2]
        end = add(add(self.here, self.way, length), aside)
        self.component("REDUCER-ECCENTRIC", [(self.here, self.size), (end, size)],
                       extra=["FLAT-DIRECTION UP"])
        self.here, self.size = end, size

    def zero_reducer(self):
        size = self.random.choice([s for s in SIZES if s != self.size])
        self.component("REDUCER-CONCENTRIC", [(self.here, self.size), (self.here, size)])
        self.size = size
        self.zero += 1

    def turn(self, way, kind="ELBOW", first=1.5, second=1.5):
        """An elbow; legs by the size."""
        start, bridged = self.dirty(self.here)
        corner = add(start if bridged else self.here, self.way, first * self.size)
        end = add(corner, way, second * self.size)
        extra = ["ANGLE 9000", "BEND-RADIUS %.4f" % (1.5 * self.size)]
        self.component(kind, [(start, self.size), (end, self.size)], center=corner, extra=extra)
        self.here, self.way = end, way

    def jog(self, kind, first, second):
        axis = self.random.choice([1, 2])
        sign = -1.0 if self.here[axis] > self.low[axis] else 1.0
        aside = [0.0, 0.0, 0.0]
        aside[axis] = sign
        self.turn(aside, kind, first, second)
        self.pipe(self.random.uniform(0.5, 3) * self.size)
        self.turn([1.0, 0.0, 0.0], kind, second, first)

    def elbows(self):
        self.jog("ELBOW", 1.5, 1.5)

    def bend(self):
        self.jog("BEND", 1.5, self.random.choice([1.5, 2.5]))

    def branch(self, start, way, size, length):
        """A pipe to a side, closed or not."""
        end = add(start, way, length)
        self.component("PIPE", [(start, size), (end, size)])
        if self.random.random() < 0.3:
            self.component("FLANGE-BLIND", [(end, size), (add(end, way, 0.3 * size), size)])

    def tee(self):
        size = self.random.choice([s for s in SIZES if s <= self.size])
        center = add(self.here, self.way, 1.1 * self.size)
        end = add(center, self.way, 1.1 * self.size)
        way = self.random.choice([[0, 1.0, 0], [0, 0, 1.0], [0, 0, -1.0]])
        side = add(center, way, 1.1 * self.size)
        ends = [(self.here, self.size), (end, self.size)]
        if self.random.random() < 0.15:  # the branch among the ends
            self.component("TEE", [ends[0], (side, size)], center=center, branches=[ends[1]])
        else:
            off = add(center, way, self.random.choice([0, 0, 0.5]))
            self.component("TEE", ends, center=off, branches=[(side, size)])
        self.branch(side, way, size, self.random.uniform(2, 4) * size)
        self.here = end

    def cross(self):
        center = add(self.here, self.way, 1.1 * self.size)
        end = add(center, self.way, 1.1 * self.size)
        sides = [add(center, [0, 0, s], 1.1 * self.size) for s in (1, -1)]
        self.component("CROSS", [(self.here, self.size), (end, self.size)], center=center,
                       branches=[(side, self.size) for side in sides])
        for side, sign in zip(sides, (1.0, -1.0)):
            self.branch(side, [0, 0, sign], self.size, 2 * self.size)
        self.here = end

    def olet(self):
        """On the pipe just made, or beside it."""
        self.pipe(3 * self.size)
        center = add(self.here, self.way, -1.5 * self.size)
        side = add(center, [0, 1.0, 0], SIZES[self.size] / 2 + 30)
        self.component("OLET", [], center=center, branches=[(side, 50)])
        self.branch(side, [0, 1.0, 0], 50, 200)

    def tap(self):
        """A pipe that begins on the wall."""
        self.pipe(3 * self.size)
        center = add(self.here, self.way, -1.5 * self.size)
        side = add(center, [0, 1.0, 0], SIZES[self.size] / 2)
        self.text += ["    TAP-CONNECTION", "    CO-ORDS %.4f %.4f %.4f 50" % tuple(side)]
        self.branch(side, [0, 1.0, 0], 50, 250)


def build(tool, folder, file, *options):
    """The report and the exit code."""
    done = subprocess.run([tool, "build", file, "--json", "--snap", "%gmm" % SNAP, "--bridge",
                           "%gmm" % BRIDGE, "--tolerance", "1mm", "--connect", "0.01mm", *FILLETS, *options],
                          cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr + done.stdout[:300]
    return json.loads(done.stdout), done.returncode


def is_inside(point, triangles):
    """By the crossings of the ray that goes up from the point."""
    x, y, z = point
    crossings = 0
    for t in triangles:
        if max(t[2], t[5], t[8]) < z or min(t[0], t[3], t[6]) > x or max(t[0], t[3], t[6]) < x or \
                min(t[1], t[4], t[7]) > y or max(t[1], t[4], t[7]) < y:
            continue
        sides = [(t[i + 3] - t[i]) * (y - t[i + 1]) - (t[i + 4] - t[i + 1]) * (x - t[i])
                 for i in (0, 3)] + [(t[0] - t[6]) * (y - t[7]) - (t[1] - t[7]) * (x - t[6])]
        total = sum(sides)
        if total and (min(sides) >= 0 or max(sides) <= 0):
            height = (sides[1] * t[2] + sides[2] * t[5] + sides[0] * t[8]) / total
            crossings += height > z
    return crossings % 2 == 1


def test_patches(folder, region, output, open_ends):
    """What the list of patches says, against the report and the file itself."""
    listed = json.loads((folder / (region + ".json")).read_text())
    area = sum(patch["area"] for patch in listed["patches"])
    assert abs(area - output["check"]["area"]) < 1e-9 * area, (area, output["check"]["area"])
    assert len(listed["components"]) == output["check"]["components"]
    ends = [patch for patch in listed["patches"] if ".bore" not in patch["name"] and "." in patch["name"]]
    assert len(ends) == open_ends, (sorted(end["name"] for end in ends), open_ends)
    least = 0.9 * math.pi * (min(SIZES.values()) / 2 - WALL) ** 2
    for patch in listed["patches"]:  # where a blind closes a bore, and no slivers elsewhere
        assert ".bore." not in patch["name"] or patch["area"] > least, patch
    for end in ends:
        assert abs(math.hypot(*end["vector_area"]) - end["area"]) < 1e-3 * end["area"], end
    data = (folder / (region + ".stl")).read_bytes()[84:]
    triangles = [numbers[3:12] for numbers in struct.iter_unpack("<12fH", data)]
    for component in listed["components"]:
        assert component["clearance"] > WALL / 10, component
        # Beside it, as its ray may go through an edge.
        beside = add(component["inside"], [0.0137, 0.0071, 0.0053], component["clearance"])
        assert is_inside(beside, triangles), component


def test_joints(text, joints):
    """Distances are those of the file's own points, and no misfit is missing."""
    ends = {}
    for number, line in enumerate(text, 1):
        words = line.split()
        if words and words[0] in ("END-POINT", "ENDPOINT", "BRANCH1-POINT", "BRANCH2-POINT"):
            ends[number] = tuple(map(float, words[1:4]))
    owner, component = {}, 0
    for number, line in enumerate(text, 1):
        component = number if line and "POINT" not in line and not line.startswith("    ") else component
        owner[number] = component
    for joint in joints:
        a, b = joint["lines"]
        assert abs(math.dist(ends[a], ends[b]) - joint["distance"]) < 1e-9, joint
    cells = {}
    for number, place in ends.items():
        cells.setdefault(tuple(math.floor(x / BRIDGE) for x in place), []).append(number)
    # A reducer without length is joined by what it is beside, at the same place.
    joined = {ends[line] for joint in joints for line in joint["lines"]}
    for (i, j, k), numbers in cells.items():
        near = [n for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)
                for n in cells.get((i + x, j + y, k + z), [])]
        for a in numbers:
            for b in near:
                if owner[a] != owner[b] and SNAP < math.dist(ends[a], ends[b]) <= BRIDGE:
                    assert ends[a] in joined and ends[b] in joined, (a, b)


def test_plant(tool, folder, seed, components):
    """All regions of one plant."""
    plant = Plant(seed, components)
    (folder / "a.pcf").write_text("\r\n".join(plant.text) + "\r\n", encoding="latin-1")
    volumes = {}
    FILLETS[:] = ["--fillet", "auto"] if seed % 2 else []
    for region in ("outer", "metal", "fluid"):
        report, code = build(tool, folder, "a.pcf", "-o", region + ".stl", "--wall",
                             "%gmm" % WALL, "--region", region, "--patches", region + ".json")
        check, piping = report["output"]["check"], report["piping"]
        apart = [joint for joint in piping["joints"] if joint["state"] == "apart"]
        assert code == 0 and not apart, (region, apart, [g for g in report["gaps"]["pairs"] if
                                         g["verdict"] not in ("welded", "open")][:3])
        assert check["components"] == plant.lines, (region, check["components"], plant.lines)
        if region == "outer":
            assert check["euler_number"] == 2 * plant.lines, check["euler_number"]
            bridged = [joint for joint in piping["joints"] if joint["state"] == "bridged"]
            assert len(bridged) == plant.misfits, (len(bridged), plant.misfits)
            assert piping["components"] == plant.components - plant.zero
            assert piping["largest_move"] <= SNAP
            test_joints(plant.text, piping["joints"])
        test_patches(folder, region, report["output"], piping["open_ends"])
        volumes[region] = check["volume"]
    assert abs(volumes["outer"] - volumes["metal"] - volumes["fluid"]) < 1e-6 * volumes["outer"]
    print("seed %d: %d components, %d lines, %d misfits, %.6g mm3" %
          (seed, plant.components, plant.lines, plant.misfits, volumes["outer"]))


def main():
    tool = str(pathlib.Path(sys.argv[1]).resolve())
    components = int(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for seed in map(int, sys.argv[3:]):
            test_plant(tool, pathlib.Path(folder), seed, components)


if __name__ == "__main__":
    main()
