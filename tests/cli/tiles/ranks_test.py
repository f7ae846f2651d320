#!/usr/bin/env python3
"""Builds shared among processes by mpirun: the same bytes for all numbers of them, and nothing left where one fails.

Usage: ranks_test.py TOOL. Skipped (77) where mpirun cannot start two processes.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]


def plant(lines, wall=None):
    """Pipes with branches, line by line apart from each other."""
    parts = []
    for i in range(lines):
        y = 1000 * i + 7 * (i % 3)
        parts += [{"name": f"run{i}", "pipe": {"from": [200000.1, y, 0.3], "to": [201000, y, 20], "radius": 100}},
                  {"name": f"branch{i}", "pipe": {"from": [200500, y, 10], "to": [200510, y, 300], "radius": 100}}]
    if wall:
        parts[-1]["wall"] = wall
    return {"units": "mm", "tolerance": 0.5, "parts": parts}


def run(tool, folder, ranks, *arguments):
    command = [tool, "--json", "build", *arguments]
    return subprocess.run((MPIRUN + ["-np", str(ranks)] if ranks else []) + command, cwd=folder, capture_output=True,
                          text=True, timeout=300, check=False)


def check_bytes(tool, folder):
    """The report and the file, for one process and for several."""
    whole = run(tool, folder, 0, "plant.json", "-o", "whole.stl")
    assert whole.returncode == 0, whole.stderr
    expected = (folder / "whole.stl").read_bytes()
    for ranks in [1, 2, 4]:
        for more in [[], ["--tiles", "3"], ["--cache", "kept"]]:
            shared = run(tool, folder, ranks, "plant.json", "-o", "shared.stl", *more)
            assert shared.returncode == 0, shared.stderr
            assert (folder / "shared.stl").read_bytes() == expected, (ranks, more)
            report = json.loads(shared.stdout)  # one, by the first rank
            assert report["parts"] == json.loads(whole.stdout)["parts"]
            (folder / "shared.stl").unlink()


def check_new_caches(tool, folder):
    """All ranks make the cache's folder at once."""
    for number in range(5):
        made = run(tool, folder, 4, "plant.json", "-o", "made.stl", "--cache", f"new{number}")
        assert made.returncode == 0, made.stderr
        shutil.rmtree(folder / f"new{number}")
        (folder / "made.stl").unlink()


def check_formats(tool, folder):
    """The bytes of PLY, and a file of VTK for each rank."""
    assert run(tool, folder, 0, "plant.json", "-o", "whole.ply").returncode == 0
    shared = run(tool, folder, 2, "plant.json", "-o", "shared.ply")
    assert shared.returncode == 0, shared.stderr
    assert (folder / "shared.ply").read_bytes() == (folder / "whole.ply").read_bytes()
    listed = run(tool, folder, 3, "plant.json", "-o", "listed.pvtu", "--cache", "kept")
    assert listed.returncode == 0, listed.stderr
    files = sorted(path.name for path in folder.glob("listed*"))
    assert files == ["listed.pvtu", "listed_0.vtu", "listed_1.vtu", "listed_2.vtu"], files
    parse = xml.etree.ElementTree.parse
    sources = [piece.get("Source") for piece in parse(folder / "listed.pvtu").iter("Piece")]
    assert sources == files[1:], sources
    triangles = [int(parse(folder / name).find(".//Piece").get("NumberOfCells")) for name in sources]
    assert sum(triangles) == json.loads(listed.stdout)["output"]["check"]["triangles"], triangles
    assert max(triangles) < 2 * min(triangles), triangles
    for path in [*folder.glob("listed*"), *folder.glob("*.ply")]:
        path.unlink()


def check_failure(tool, folder):
    """A part that only one rank builds is refused."""
    (folder / "bad.json").write_text(json.dumps(plant(5, wall=120)), encoding="utf-8")
    failed = run(tool, folder, 2, "bad.json", "-o", "bad.stl")
    assert failed.returncode != 0
    assert "branch4" in failed.stderr, failed.stderr
    left = sorted(path.name for path in folder.iterdir())
    assert left == ["bad.json", "kept", "plant.json", "whole.stl"], left
    usage = run(tool, folder, 2, "plant.json", "-o", "a.off")
    assert usage.returncode == 2 and "binary STL" in usage.stderr, usage.stderr
    piped = run(tool, folder, 2, "-", "-o", "a.stl")
    assert piped.returncode == 2 and "standard input" in piped.stderr, piped.stderr


def has_mpirun():
    return shutil.which("mpirun") and subprocess.run([*MPIRUN, "-np", "2", "true"], capture_output=True, timeout=60,
                                                     check=False).returncode == 0


def main():
    if not has_mpirun():
        sys.exit(77)
    tool = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "plant.json").write_text(json.dumps(plant(12)), encoding="utf-8")
        check_bytes(tool, folder)
        check_new_caches(tool, folder)
        check_formats(tool, folder)
        check_failure(tool, folder)


if __name__ == "__main__":
    main()
