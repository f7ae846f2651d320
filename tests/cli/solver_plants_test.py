#!/usr/bin/env python3
"""Meshes for solvers of seeded random plants, as dirty as real ones (piping_plants_test.py), in all three regions.

What the tool says of a mesh is measured again in the file that it wrote: angles, edges, areas of patches, and that
the three volumes agree as far as the distance lets them. Usage:
    solver_plants_test.py DUPIN COMPONENTS SEED...
Ten plants of 1000 components (1000 1 2 3 4 5 6 7 8 9 10) take some minutes of a processor each, so that ctest
has a small one."""
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

import piping_plants_test

SIZE, DISTANCE, ANGLE = 50.0, 2.0, 25.0
OPTIONS = ["--snap", "0.05mm", "--bridge", "0.5mm", "--tolerance", "1mm", "--connect", "0.01mm", "--wall", "3mm",
           "--quality", "cfd", "--size", f"{SIZE}mm", "--distance", f"{DISTANCE}mm"]
# Of triangles: what sharp edges that nearly meet may leave below the angle though none is between two of them.
MOST_POOR = 1e-5


def build(tool, folder, region):
    done = subprocess.run([tool, "build", "a.pcf", "--json", "-o", region + ".off", "--region", region, "--patches",
                           region + ".json", *OPTIONS], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr + done.stdout[:500]
    return json.loads(done.stdout)["output"]


def measured(file):
    """The longest edge, and how many triangles have an angle below the one asked for."""
    lines = (line for line in file.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#"))
    assert next(lines).startswith("OFF")
    points, triangles, _ = map(int, next(lines).split())
    places = [tuple(map(float, next(lines).split()[:3])) for _ in range(points)]
    longest, poor = 0.0, 0
    for _ in range(triangles):
        corners = [places[int(word)] for word in next(lines).split()[1:4]]
        a, b, c = sorted(math.dist(corners[k], corners[(k + 1) % 3]) for k in range(3))
        longest = max(longest, c)
        # At coordinates of 2e5, a tenth of a degree is more than what the lengths of edges are rounded by.
        poor += a * a < b * b + c * c - 2 * b * c * math.cos(math.radians(ANGLE - 0.1))
    return longest, poor


def test_region(tool, folder, region):
    """The mesh's volume and area."""
    output = build(tool, folder, region)
    check, mesh = output["check"], output["solver_mesh"]
    assert check["solid"] and check["watertight"], check
    assert mesh["deviation"] <= DISTANCE and mesh["longest_edge"] <= SIZE, mesh
    longest, poor = measured(folder / (region + ".off"))
    assert longest <= SIZE * (1 + 1e-9), longest
    assert poor <= mesh["poor_triangles"], (poor, mesh)
    unexcused = mesh["poor_triangles"] - mesh["poor_between_edges"]
    assert unexcused <= MOST_POOR * check["triangles"], mesh
    listed = json.loads((folder / (region + ".json")).read_text(encoding="utf-8"))
    area = sum(patch["area"] for patch in listed["patches"])
    assert abs(area - check["area"]) < 1e-9 * area, (area, check["area"])
    print("  %s: %d triangles, %.3g mm off, angles from %.1f degrees, %d below %g, %d of them between edges" % (
        region, check["triangles"], mesh["deviation"], math.degrees(mesh["smallest_angle"]), mesh["poor_triangles"],
        ANGLE, mesh["poor_between_edges"]), flush=True)
    return check["volume"], check["area"]


def main():
    tool = str(pathlib.Path(sys.argv[1]).resolve())
    for seed in map(int, sys.argv[3:]):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            plant = piping_plants_test.Plant(seed, int(sys.argv[2]))
            (folder / "a.pcf").write_text("\r\n".join(plant.text) + "\r\n", encoding="latin-1")
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            volumes, areas = {}, {}
            for region in ("outer", "metal", "fluid"):
                volumes[region], areas[region] = test_region(tool, folder, region)
            missing = volumes["outer"] - volumes["metal"] - volumes["fluid"]
            assert abs(missing) <= DISTANCE * sum(areas.values()), (volumes, areas)
            print("seed %d: %d components, %.0f s of processors" % (
                seed, plant.components, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before), flush=True)


if __name__ == "__main__":
    main()
