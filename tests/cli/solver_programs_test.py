#!/usr/bin/env python3
"""What solvers' own programs say of our meshes: gmsh fills a surface and reads tetrahedra, OpenFOAM checks both.
Each is skipped where it is not installed; exit code 77 if none is. Usage: solver_programs_test.py DUPIN
    apt-get install --no-install-recommends gmsh openfoam"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

DOCUMENT = {"units": "mm", "tolerance": 0.05, "parts": [
    {"name": "run", "pipe": {"from": [0, 0, 0], "to": [80, 0, 0], "radius": 10}},
    {"name": "branch", "pipe": {"from": [30, 2, 0], "to": [45, 2, 40], "radius": 6}}]}
HEAD = "FoamFile {{ version 2.0; format ascii; class dictionary; object {0}; }}\n"
CASE = {"controlDict": "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; "
                       "writeInterval 1;",
        "fvSchemes": "gradSchemes {} divSchemes {} laplacianSchemes {}",
        "fvSolution": "solvers {}"}


def run(*command, folder, code=0):
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == code, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout + done.stderr


class SolverPrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        (cls.folder / "tee.json").write_text(json.dumps(DOCUMENT), encoding="utf-8")
        run(TOOL, "build", "tee.json", "-o", "tee.stl", "--quality", "cfd", "--size", "6mm", folder=cls.folder)
        run(TOOL, "build", "tee.json", "-o", "tee.msh", "--size", "6mm", folder=cls.folder)

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_fills_the_surface(self):
        (self.folder / "tee.geo").write_text('Merge "tee.stl";\nSurface Loop(1) = Surface{:};\nVolume(1) = {1};\n',
                                             encoding="utf-8")
        said = run("gmsh", "tee.geo", "-3", "-format", "msh22", "-o", "filled.msh", folder=self.folder)
        self.assertNotIn("Error", said)
        self.assertIn("No ill-shaped tets in the mesh", said)
        self.assertIn("$Elements", (self.folder / "filled.msh").read_text(encoding="utf-8"))

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_reads_the_tetrahedra(self):
        said = run("gmsh", "tee.msh", "-check", "-", folder=self.folder)
        self.assertNotIn("Error", said)
        self.assertNotIn("Warning", said)

    @unittest.skipUnless(shutil.which("checkMesh"), "OpenFOAM is not installed")
    def test_openfoam_takes_surface_and_tetrahedra(self):
        (self.folder / "system").mkdir()
        for name, text in CASE.items():
            (self.folder / "system" / name).write_text(HEAD.format(name) + text, encoding="utf-8")
        surface = run("surfaceCheck", "tee.stl", folder=self.folder)
        self.assertIn("Surface is closed. All edges connected to two faces.", surface)
        run("gmshToFoam", "tee.msh", folder=self.folder)
        patches = (self.folder / "constant" / "polyMesh" / "boundary").read_text(encoding="utf-8")
        for name in ("run.start", "run.end", "branch.end"):
            self.assertIn(name, patches)
        self.assertIn("Mesh OK.", run("checkMesh", folder=self.folder))


if __name__ == "__main__":
    TOOL = os.path.abspath(sys.argv.pop(1))
    if not shutil.which("gmsh") and not shutil.which("checkMesh"):
        print("neither gmsh nor OpenFOAM is installed")
        sys.exit(77)
    unittest.main(verbosity=2)
