#!/usr/bin/env python3
"""Tiles, threads and processes give the bytes of the whole: of all examples, racks, stacks and random scenes.

Usage: same_bytes_test.py TOOL EXAMPLES [SCENES]. Scenes are seeded; parts stand on a lattice, so that boxes, ends and
axes of parts touch, coincide and lie in one plane, within districts and on their borders.
"""
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
TILES = ["1", "3", "8", "64"]
FAR = 200_000  # floats are 16 um apart there


def pipe(name, start, end, radius):
    return {"name": name, "pipe": {"from": start, "to": end, "radius": radius}}


def scene(seed):
    """Pipes along the axes in cells of a lattice, which some of them leave, or just reach."""
    choose = random.Random(seed)
    origin = choose.choice([0, FAR])
    parts = []
    for number in range(choose.randrange(12, 40)):
        cell = [origin + 400 * choose.randrange(4) for _ in range(3)]
        axis = choose.randrange(3)
        start = [c + 40 * choose.randrange(5) for c in cell]
        end = list(start)
        end[axis] += choose.choice([40, 80, 120, 200, 400 - 40])
        if choose.random() < 0.2:  # a border that floats do not hold
            end[axis] += choose.choice([1e-3, 1e-9, 0.1])
        parts.append(pipe(f"p{number}", start, end, choose.choice([10, 20, 20, 40])))
    return {"units": "mm", "tolerance": 2, "parts": parts}


def rack(count):
    parts = []
    for i in range(count):
        parts.append(pipe(f"a{i}", [0, 100 * i, 0], [100 * count, 100 * i, 0], 30))
        parts.append(pipe(f"b{i}", [100 * i + 50, -50, 20], [100 * i + 50, 100 * count - 50, 20], 30))
    return {"units": "mm", "tolerance": 0.5, "parts": parts}


def stacks(count):
    """Coaxial pipes, one after the other, that touch, overlap or leave slits, and stacks of these."""
    return {"units": "mm", "tolerance": 0.5,
            "parts": [pipe(f"s{i}-{j}", [FAR + 500 * i, 100 * j, 0], [FAR + 500 * i, 100 * j + 100 + (j % 3 - 1) * 0.01 * i, 0],
                           30 + j % 2) for i in range(count) for j in range(5)]}


def bytes_of(tool, folder, document, *options, before=()):
    output = folder / "out.stl"
    output.unlink(missing_ok=True)
    process = subprocess.run([*before, tool, "build", str(document), "-o", str(output), "--quiet", *options],
                             capture_output=True, text=True, timeout=600, check=False)
    return output.read_bytes() if output.exists() else process.returncode


def check(tool, folder, document, number, has_mpirun):
    whole = bytes_of(tool, folder, document)
    for tiles in TILES:
        assert bytes_of(tool, folder, document, "--tiles", tiles) == whole, (document, tiles)
    one = {min(os.sched_getaffinity(0))}
    alone = ["taskset", "-c", str(*one)]
    assert bytes_of(tool, folder, document, before=alone) == whole, (document, "one thread")
    assert bytes_of(tool, folder, document, "--tiles", "3", before=alone) == whole, (document, "one thread, tiles")
    if has_mpirun:
        ranks = [1, 2, 4][number % 3]
        more = ["--tiles", TILES[number % 4]] if number % 2 else []
        shared = bytes_of(tool, folder, document, *more, before=[*MPIRUN, "-np", str(ranks)])
        assert shared == whole, (document, ranks, more)
    return isinstance(whole, bytes)


def main():
    tool, examples = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
    scenes = int(sys.argv[3]) if len(sys.argv) > 3 else 50
    has_mpirun = shutil.which("mpirun") and subprocess.run([*MPIRUN, "-np", "2", "true"], capture_output=True, timeout=60,
                                                           check=False).returncode == 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        documents = sorted(path for path in examples.iterdir() if path.suffix in {".json", ".pcf", ".graph", ".swc"})
        made = {"rack": rack(8), "stacks": stacks(6), **{f"scene-{seed}": scene(seed) for seed in range(scenes)}}
        for title, content in made.items():
            documents.append(folder / f"{title}.json")
            documents[-1].write_text(json.dumps(content), encoding="utf-8")
        built = sum(check(tool, folder, document, number, has_mpirun) for number, document in enumerate(documents))
        print(built, "of", len(documents), "documents were built")
        assert built > 0.9 * len(documents)


if __name__ == "__main__":
    main()
