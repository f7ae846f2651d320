#!/usr/bin/env python3
"""Surfaces made for solvers, read by the programs that they are for: gmsh fills them, OpenFOAM checks
them. Usage: solver_meshes_test.py DUPIN EXAMPLE[:REGION]... Exit code 77: neither program is here."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent.parent / "examples"
SKIPPED = 77


def run(*command, folder):
    return subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True,
                          errors="replace", timeout=300)


def build(tool, example, region, folder):
    options = ["--region", region] if region else []
    made = run(tool, "build", EXAMPLES / example, "-o", "surface.stl", "--quality", "cfd", "--json", *options,
               folder=folder)
    assert made.returncode in (0, 1), f"{example}: {made.stderr}"
    report = json.loads(made.stdout)["output"]["remeshing"]
    loose = report["poor_triangles"] - report["confined_triangles"]
    assert loose == 0, f"{example}: {loose} triangles below the angle without a sharp edge to blame: {report['worst']}"


def fill_by_gmsh(example, folder):
    (folder / "volume.geo").write_text('Merge "surface.stl";\nn() = Surface "*";\nSurface Loop(1) = n();\n'
                                       "Volume(1) = 1;\n")
    made = run("gmsh", "-3", "volume.geo", "-o", "volume.msh", "-format", "msh2", folder=folder)
    text = made.stdout + made.stderr
    assert made.returncode == 0 and "Error" not in text, f"{example}: gmsh: {text[-600:]}"
    assert re.search(r"^\d+ 4 ", (folder / "volume.msh").read_text(), re.M), f"{example}: gmsh made no tetrahedra"


def check_by_openfoam(example, folder):
    made = run("surfaceCheck", "surface.stl", folder=folder)
    assert "Surface is closed" in made.stdout, f"{example}: surfaceCheck: {made.stdout[-600:]}"
    assert "Surface has no illegal triangles" in made.stdout, f"{example}: surfaceCheck: {made.stdout[-600:]}"


def main():
    tool, cases = sys.argv[1], sys.argv[2:]
    programs = [(name, use) for name, use in [("gmsh", fill_by_gmsh), ("surfaceCheck", check_by_openfoam)]
                if shutil.which(name)]
    if not programs:
        print("skipped: neither gmsh nor OpenFOAM's surfaceCheck is installed")
        return SKIPPED
    for case in cases:
        example, _, region = case.partition(":")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            build(pathlib.Path(tool).resolve(), example, region, folder)
            for program, use in programs:
                use(example, folder)
                print(f"{case}: {program} takes it")
    return 0


if __name__ == "__main__":
    sys.exit(main())
