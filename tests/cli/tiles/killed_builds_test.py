#!/usr/bin/env python3
"""Builds with a cache that are killed at random moments go on, and come to the same bytes.

Usage: killed_builds_test.py TOOL
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

KILLS = 20


def plant(lines):
    """Crossing pipes, pair by pair apart from each other."""
    parts = []
    for i in range(lines):
        y = 1000 * i
        parts += [{"name": f"run{i}", "pipe": {"from": [200000, y, 0], "to": [201000, y, 20], "radius": 100}},
                  {"name": f"branch{i}", "pipe": {"from": [200500, y, 10], "to": [200510, y, 300], "radius": 80}}]
    return {"units": "mm", "tolerance": 0.05, "parts": parts}


def build(tool, folder, output, *more):
    return [tool, "build", str(folder / "plant.json"), "-o", str(folder / output), "--quiet", *more]


def main():
    tool = sys.argv[1]
    choose = random.Random(7)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "plant.json").write_text(json.dumps(plant(150)), encoding="utf-8")
        start = time.monotonic()
        subprocess.run(build(tool, folder, "whole.stl"), check=True)
        took = time.monotonic() - start
        expected = (folder / "whole.stl").read_bytes()
        unfinished = 0
        for kill in range(KILLS):
            arguments = build(tool, folder, "killed.stl", "--cache", str(folder / f"cache{kill}"))
            with subprocess.Popen(arguments) as process:
                time.sleep(choose.uniform(0.1, 0.9) * took)
                process.kill()
            unfinished += not (folder / "killed.stl").exists()
            subprocess.run(arguments, check=True)
            assert (folder / "killed.stl").read_bytes() == expected, kill
            (folder / "killed.stl").unlink()
        assert unfinished > 0, "none was killed before it had ended"


if __name__ == "__main__":
    main()
